#include <cstddef>
#include <limits>
#include <optional>
#include <string>

#include "rail_core/constants.hpp"
#include "rail_core/number_text.hpp"
#include "track_profile.hpp"
#include "track_rules.hpp"

namespace rail {
namespace {

std::string inKilometres(double s_m) { return formatNumber(s_m / kMetresPerKilometre); }

/// A chainage key in km as metres; nothing, with the problem added, if it is missing or no number.
std::optional<double> readChainage(YamlReader& reader, const std::string& key) {
  const std::size_t before = reader.problems().count();
  const double km = reader.number(key, anyNumber());
  if (!reader.present() || reader.problems().count() != before) return std::nullopt;
  return cleanChainage(km * kMetresPerKilometre);
}

/// Where the track begins and ends, as far as the file says so.
struct Limits {
  std::optional<double> start_m, end_m;
};

Limits readLimits(YamlReader& reader) {
  Limits limits{readChainage(reader, "start_km"), readChainage(reader, "end_km")};
  if (limits.start_m && limits.end_m && *limits.end_m <= *limits.start_m) {
    reader.refuse("end_km", "must be > start_km = " + inKilometres(*limits.start_m));
    limits.end_m.reset();
  }
  return limits;
}

/// Reads `from_km` of a list whose entries hold until the next, and checks its order.
std::optional<double> readFrom(YamlReader& entry, const Limits& limits, bool first, std::optional<double> previous_m) {
  const std::optional<double> from_m = readChainage(entry, "from_km");
  if (!from_m) return from_m;
  if (first && limits.start_m && *from_m != *limits.start_m) {
    entry.refuse("from_km", "the first must be start_km = " + inKilometres(*limits.start_m));
  } else if (!first && previous_m && *from_m <= *previous_m) {
    entry.refuse("from_km", "must be > that of the entry before, " + inKilometres(*previous_m));
  } else if (limits.end_m && *from_m >= *limits.end_m) {
    entry.refuse("from_km", "must be < end_km = " + inKilometres(*limits.end_m));
  }
  return from_m;
}

/// A list of values that each hold until the next: grades and speed limits.
/// @param per_unit  how many of the file's units make one SI unit
std::vector<Segment> readHeld(YamlReader& reader, const std::string& list, const std::string& key, const Range& range,
                              double per_unit, const Limits& limits) {
  const std::size_t before = reader.problems().count();
  std::vector<YamlReader> entries = reader.maps(list);
  if (reader.problems().count() == before && entries.empty()) reader.refuse(list, "must not be empty");
  std::vector<Segment> segments;
  std::optional<double> previous_m;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::optional<double> from_m = readFrom(entries[i], limits, i == 0, previous_m);
    const double value = entries[i].number(key, range) / per_unit;
    entries[i].finish();
    if (from_m) appendSegment(segments, {*from_m, value, 0.0});
    previous_m = from_m;
  }
  return segments;
}

struct Curve {
  std::optional<double> start_m;  ///< nothing if unknown: then the rest may be harmless values, not the file's
  double in_m = 0.0, circular_m = 0.0, out_m = 0.0;
  double curvature_1pm = 0.0, cant_m = 0.0;
  double circularStart_m() const { return cleanChainage(*start_m + in_m); }
  double circularEnd_m() const { return cleanChainage(circularStart_m() + circular_m); }
  double end_m() const { return cleanChainage(circularEnd_m() + out_m); }
};

Curve readCurve(YamlReader& reader) {
  Curve curve;
  curve.start_m = readChainage(reader, "start_km");
  const double radius_m =
      reader.number("radius_m", between(kSmallestRadius_m, std::numeric_limits<double>::infinity()));
  const bool left = reader.choice("direction", {"left", "right"}) == "left";
  curve.in_m = reader.number("transition_in_m", notNegative());
  curve.circular_m = reader.number("circular_m", notNegative());
  curve.out_m = reader.number("transition_out_m", notNegative());
  curve.cant_m = reader.number("cant_mm", between(0.0, kLargestCant_mm)) / kMillimetresPerMetre;
  curve.curvature_1pm = (left ? 1.0 : -1.0) / radius_m;
  reader.finish();
  return curve;
}

/// How a curve, itself in order, stands to the track and to the curve before.
void checkCurve(YamlReader& reader, const Curve& curve, const Curve& previous, const Limits& limits) {
  const double start_m = *curve.start_m;
  if (curve.end_m() <= start_m) reader.refuse("circular_m", "the curve has no length");
  if (limits.start_m && start_m < *limits.start_m) {
    reader.refuse("start_km", "must be >= the track's start_km = " + inKilometres(*limits.start_m));
  }
  if (limits.end_m && curve.end_m() > *limits.end_m) {
    reader.refuse("start_km", "the curve ends at " + inKilometres(curve.end_m()) +
                                  " km, beyond the track's end_km = " + inKilometres(*limits.end_m));
  }
  if (!previous.start_m) return;
  if (start_m < *previous.start_m) {
    reader.refuse("start_km", "curves must be in order, the one before starts at " + inKilometres(*previous.start_m));
  } else if (start_m < previous.end_m()) {
    reader.refuse("start_km", "overlaps the curve before, which ends at " + inKilometres(previous.end_m()));
  }
}

/// Zero, linear to `value`, constant, linear to zero: the shape of curvature and cant alike.
void appendTrapezoid(std::vector<Segment>& segments, const Curve& curve, double value) {
  const double start_m = *curve.start_m;
  const double full_m = curve.circularStart_m(), leave_m = curve.circularEnd_m(), end_m = curve.end_m();
  if (full_m > start_m) appendSegment(segments, {start_m, 0.0, value / (full_m - start_m)});
  if (leave_m > full_m) appendSegment(segments, {full_m, value, 0.0});
  if (end_m > leave_m) appendSegment(segments, {leave_m, value, -value / (end_m - leave_m)});
  appendSegment(segments, {end_m, 0.0, 0.0});
}

void readCurves(YamlReader& reader, const Limits& limits, TrackProfile& profile) {
  appendSegment(profile.curvature, {profile.start_m, 0.0, 0.0});
  appendSegment(profile.cant, {profile.start_m, 0.0, 0.0});
  Curve previous;
  for (YamlReader& entry : reader.maps("curves")) {
    const std::size_t before = reader.problems().count();
    const Curve curve = readCurve(entry);
    const bool readable = entry.present() && reader.problems().count() == before;
    if (readable) {
      checkCurve(entry, curve, previous, limits);
      appendTrapezoid(profile.curvature, curve, curve.curvature_1pm);
      appendTrapezoid(profile.cant, curve, curve.cant_m);
      previous = curve;
    } else {
      previous = {};
    }
  }
}

}  // namespace

TrackProfile readTrackLists(YamlReader& reader) {
  TrackProfile profile;
  const Limits limits = readLimits(reader);
  profile.start_m = limits.start_m.value_or(0.0);
  profile.end_m = limits.end_m.value_or(profile.start_m);
  profile.grade = readHeld(reader, "grades", "grade_permille", between(-kLargestGrade_permille, kLargestGrade_permille),
                           kPermillePerOne, limits);
  readCurves(reader, limits, profile);
  profile.speed_limit = readHeld(reader, "speed_limits", "limit_kmph", positive(), kKmphPerMps, limits);
  return profile;
}

}  // namespace rail
