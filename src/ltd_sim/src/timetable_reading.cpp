// The part of TimetableDriver that reads it.

#include <algorithm>
#include <cmath>

#include "ltd_sim/timetable_driver.hpp"
#include "rail_core/constants.hpp"
#include "rail_core/message_number.hpp"

namespace ltd {

namespace {

constexpr double kHoldingMargin = 1.5;  // chosen: a standing train is held with so much more than the grade pulls

/// A time as whole nanoseconds, to the nearest: it is compared with t, no step depends on it.
rail::Nanoseconds readTime(rail::YamlReader& reader, const std::string& key, double fallback_s) {
  const std::optional<rail::Nanoseconds> t =
      rail::wholeNanoseconds(reader.numberOr(key, rail::aboveUpTo(0.0, 600.0), fallback_s));
  if (!t) reader.refuse(key, "must be a whole number of nanoseconds");
  return t.value_or(1);
}

}  // namespace

TimetableDriver::Point TimetableDriver::readPoint(rail::YamlReader reader) {
  Point point;
  point.location_m = reader.number("location_km", rail::anyNumber()) * rail::kMetresPerKilometre;
  if (reader.has("time_s")) point.time_s = reader.number("time_s", rail::notNegative());
  point.stop = reader.booleanOr("stop", false);
  if (reader.has("dwell_s")) point.dwell_s = reader.number("dwell_s", rail::between(0.0, 86400.0));
  if (point.dwell_s && !point.stop) reader.refuse("dwell_s", "is of use with stop: true only");
  reader.finish();
  return point;
}

void TimetableDriver::readPoints(rail::YamlReader& reader, const rail::Track& track) {
  std::vector<rail::YamlReader> points = reader.maps("points");
  double last_time_s = 0.0;
  const bool track_known = track.end_m() > track.start_m();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t before = reader.problems().count();
    const Point point = readPoint(points[i]);
    points_.push_back(point);
    if (reader.problems().count() != before) continue;
    if (track_known && (point.location_m < track.start_m() || point.location_m > track.end_m()))
      points[i].refuse("location_km", "is beyond the track");
    if (i > 0 && point.location_m <= points_[i - 1].location_m)
      points[i].refuse("location_km", "must be ahead of the point before it");
    if (point.time_s && *point.time_s <= last_time_s) points[i].refuse("time_s", "must be after the times before it");
    if (point.stop && !point.dwell_s && i + 1 < points.size())
      points[i].refuse("stop", "must have a dwell_s: the train goes on");
    if (point.time_s) last_time_s = *point.time_s + point.dwell_s.value_or(0.0);
  }
}

void TimetableDriver::readHabits(rail::YamlReader& reader) {
  deceleration_mps2_ = reader.number("service_deceleration_mps2", rail::aboveUpTo(0.0, 2.0));
  graduated_release_ = reader.choice("brake_release", {"direct", "graduated"}) == "graduated";
  release_above_mps_ = reader.numberOr("release_above_kmph", rail::between(0.0, 100.0), 25.0) / rail::kKmphPerMps;
  margin_mps_ = reader.numberOr("limit_margin_kmph", rail::between(0.0, 20.0), 2.0) / rail::kKmphPerMps;
  late_tolerance_s_ = reader.numberOr("late_tolerance_s", rail::notNegative(), 10.0);
  planning_period_ = readTime(reader, "planning_period_s", 1.0);
  controls_.settings.notch_hold = readTime(reader, "notch_hold_s", 3.0);
  controls_.settings.air_hold = readTime(reader, "reaction_s", 4.0);
  reaction_s_ = rail::toSeconds(controls_.settings.air_hold);
}

/// What of line and train do not go together.
void TimetableDriver::readLine(rail::YamlReader& reader, const rail::Track& track) {
  line_ = TimetableLine(track, ability_, deceleration_mps2_, margin_mps_);
  if (line_.smallestSpeed() <= 0.0) reader.refuse("limit_margin_kmph", "must be below the line's lowest speed limit");
  if (ability_.full_service_N && ability_.first_reduction_Pa > DriverControls::kFirstReduction_Pa)
    reader.refuse("kind",
                  "applies the air brake with " +
                      rail::messageNumber(DriverControls::kFirstReduction_Pa / kPascalsPerBar) +
                      " bar at first and holds at stops with as much at least: air_brake.valve.first_reduction_bar " +
                      rail::messageNumber(ability_.first_reduction_Pa / kPascalsPerBar) + " must not be larger");
  double least_N = ability_.full_service_N ? ability_.full_service_N(0.0) : 0.0;
  for (double v = 0.0; v <= line_.largestSpeed() && least_N > 0.0; v += 1.0)
    least_N = std::min(least_N, ability_.full_service_N(v));
  const double steepest = std::min(0.0, track.smallestGrade());
  const double brakes_mps2 = (least_N + ability_.weight_N * steepest) / ability_.mass_kg;
  if (deceleration_mps2_ > brakes_mps2)
    reader.refuse("service_deceleration_mps2",
                  "must not be above what full service gives on the line's steepest descent, " +
                      rail::messageNumber(brakes_mps2, rail::Rounding::kDown) + " m/s2");
  else
    readStops(reader, track);
}

/// The curve to each stop, and whether the train stays there.
void TimetableDriver::readStops(rail::YamlReader& reader, const rail::Track& track) {
  const double full_N = ability_.full_service_N ? ability_.full_service_N(0.0) : 0.0;
  const double length_m = ability_.ahead_m + ability_.behind_m;
  std::vector<rail::YamlReader> points = reader.maps("points");
  for (std::size_t i = 0; i < points_.size(); ++i) {
    Point& point = points_[i];
    if (!point.stop) continue;
    point.deceleration_mps2 = line_.decelerationTo(point.location_m);
    const double rise_m = track.at(point.location_m + ability_.ahead_m).height_m -
                          track.at(point.location_m - ability_.behind_m).height_m;
    const double pull_N = std::fabs(ability_.weight_N * rise_m / length_m);
    if (kHoldingMargin * pull_N > full_N)
      points[i].refuse("location_km", "the train would not stay on the grade there: it pulls with " +
                                          std::to_string(std::lround(pull_N / 1e3)) + " kN, and full service, " +
                                          std::to_string(std::lround(full_N / 1e3)) + " kN, must be " +
                                          rail::messageNumber(kHoldingMargin) + " times that");
    else
      point.holding_Pa = DriverControls::reductionFor(full_N > 0.0 ? kHoldingMargin * pull_N / full_N : 0.0, ability_);
  }
}

TimetableDriver TimetableDriver::read(rail::YamlReader& reader, const rail::Track& track, const TrainAbility& ability) {
  const std::size_t before = reader.problems().count();
  TimetableDriver driver;
  driver.ability_ = ability;
  driver.readPoints(reader, track);
  driver.readHabits(reader);
  if (!ability.known) return driver;
  const bool track_known = track.end_m() > track.start_m();
  const bool train_known = ability.mass_kg > 0.0 && ability.notches > 0 && ability.traction_N;
  if (track_known && train_known && reader.problems().count() == before) driver.readLine(reader, track);
  if (!train_known && reader.problems().count() == before)
    reader.refuse("kind", "needs a train whose traction and brakes are known");
  return driver;
}

}  // namespace ltd
