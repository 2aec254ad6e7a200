#include "rail_core/track.hpp"

#include <algorithm>
#include <set>

#include "track_profile.hpp"

namespace rail {
namespace {

/// Goes along a quantity's segments with rising s.
class SegmentWalk {
 public:
  explicit SegmentWalk(const std::vector<Segment>& segments) : at_(segments.begin()), end_(segments.end()) {}

  /// The segment that holds from s on, beginning at s.
  Segment from(double s_m) {
    while (at_ + 1 != end_ && (at_ + 1)->s_m <= s_m) ++at_;
    return {s_m, at_->value + at_->slope * (s_m - at_->s_m), at_->slope};
  }

 private:
  std::vector<Segment>::const_iterator at_, end_;
};

}  // namespace

Track Track::read(YamlReader reader) {
  const std::size_t before = reader.problems().count();
  Track track;
  track.name_ = reader.text("name");
  const TrackProfile profile = reader.has("table") ? readTrackTable(reader) : readTrackLists(reader);
  const std::string irregularity = reader.has("irregularity") ? reader.text("irregularity") : "";
  reader.finish();
  const bool complete =
      !profile.grade.empty() && !profile.speed_limit.empty();  // not so if an included file is missing
  if (complete && reader.problems().count() == before) track.build(profile);
  if (complete && !irregularity.empty()) {
    track.irregularity_ = TrackIrregularity::read(irregularity, reader.file("irregularity"), profile.start_m,
                                                  profile.end_m, reader.problems());
  }
  return track;
}

/// Cuts all quantities at the break points of each, and adds up the height.
void Track::build(const TrackProfile& profile) {
  start_m_ = profile.start_m;
  end_m_ = profile.end_m;
  std::set<double> breaks{end_m_};
  for (const auto* segments : {&profile.grade, &profile.curvature, &profile.cant, &profile.speed_limit}) {
    for (const Segment& segment : *segments) breaks.insert(segment.s_m);
  }
  SegmentWalk grades(profile.grade), curvatures(profile.curvature), cants(profile.cant), limits(profile.speed_limit);
  double height_m = 0.0;
  for (const double s_m : breaks) {
    if (!pieces_.empty()) {
      const Piece& last = pieces_.back();
      const double length_m = s_m - last.s_m;
      height_m += (last.grade + 0.5 * last.grade_slope_1pm * length_m) * length_m;
    }
    const Segment grade = grades.from(s_m), curvature = curvatures.from(s_m), cant = cants.from(s_m);
    pieces_.push_back({s_m, grade.value, grade.slope, curvature.value, curvature.slope, cant.value, cant.slope,
                       limits.from(s_m).value, height_m, 0.0, 0.0, 0.0, 0.0});
  }
  buildCant();
}

TrackPoint Track::at(double s_m, std::size_t& hint) const {
  if (pieces_.empty()) return {};
  hint = findPiece(s_m, hint);
  const Piece& piece = pieces_[hint];
  const double beyond_m = s_m - piece.s_m;
  const double along_m = beyond_m < 0.0 ? 0.0 : beyond_m;  // before the start the values there hold; NaN stays NaN
  TrackPoint point;
  point.grade = piece.grade + piece.grade_slope_1pm * along_m;
  point.curvature_1pm = piece.curvature_1pm + piece.curvature_slope_1pm2 * along_m;
  point.cant_m = piece.cant_m + piece.cant_slope * along_m;
  point.speed_limit_mps = piece.speed_limit_mps;
  point.height_m = piece.height_m + piece.grade * beyond_m + 0.5 * piece.grade_slope_1pm * along_m * along_m;
  return point;
}

TrackPoint Track::at(double s_m) const {
  std::size_t hint = 0;
  return at(s_m, hint);
}

/// Index of the piece that holds at s: the last one that starts at or before s, or the first.
std::size_t Track::findPiece(double s_m, std::size_t hint) const {
  constexpr int kSteps = 3;  // chosen: a vehicle moves less than a piece per step, save where break points lie close
  std::size_t i = std::min(hint, pieces_.size() - 1);
  for (int step = 0; step < kSteps; ++step) {
    if (i > 0 && s_m < pieces_[i].s_m) {
      --i;
    } else if (i + 1 < pieces_.size() && s_m >= pieces_[i + 1].s_m) {
      ++i;
    } else {
      return i;
    }
  }
  const auto above =
      std::upper_bound(pieces_.begin(), pieces_.end(), s_m, [](double s, const Piece& piece) { return s < piece.s_m; });
  return above == pieces_.begin() ? 0 : static_cast<std::size_t>(above - pieces_.begin()) - 1;
}

double Track::largestGrade() const { return gradeExtremes().second; }

double Track::smallestGrade() const { return gradeExtremes().first; }

/// Smallest and largest grade; a linear one is extreme at an end of its piece.
std::pair<double, double> Track::gradeExtremes() const {
  if (pieces_.empty()) return {0.0, 0.0};
  std::pair<double, double> extremes{pieces_.back().grade, pieces_.back().grade};
  for (std::size_t i = 0; i + 1 < pieces_.size(); ++i) {
    const Piece& piece = pieces_[i];
    const double at_end = piece.grade + piece.grade_slope_1pm * (pieces_[i + 1].s_m - piece.s_m);
    extremes.first = std::min({extremes.first, piece.grade, at_end});
    extremes.second = std::max({extremes.second, piece.grade, at_end});
  }
  return extremes;
}

}  // namespace rail
