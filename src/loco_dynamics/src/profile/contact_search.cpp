#include "loco_dynamics/profile/contact_search.hpp"

#include <algorithm>
#include <cmath>

#include "region_blend.hpp"

namespace loco {

namespace {

constexpr double kNodeDistance_m = 1.5e-3;  // along the surface; chosen: a tenth of the smallest radius, 12 mm
// Less overlap is no contact. Chosen: 1e-7 N, and more than rounding, which could leave nothing to sum up.
constexpr double kLeast_m = 1e-12;
constexpr double kBeside_m = 2e-3;  // the search ends this far outside the rail's head

/// Peaks of the overlap from values at the nodes, met in rising s.
class PeakFinder {
 public:
  explicit PeakFinder(const Overlap& overlap) : overlap_(overlap) {}

  void meet(double s_m, const Overlap::Value& here) {
    if (has_before_) {
      if (before_.tilt > 0.0 && here.tilt <= 0.0) meetPeak(s_m, here);
      if (before_.tilt <= 0.0 && here.tilt > 0.0) meetValley(s_m, here);
    }
    if (open_ && here.depth_m <= 0.0) close({s_m, here.overlap_m()});
    if (!has_before_ || (!open_ && here.depth_m <= 0.0)) left_ = {s_m, here.overlap_m()};
    before_s_m_ = s_m;
    before_ = here;
    has_before_ = true;
  }
  /// What lies between the last place met and the next one does not touch.
  void skip() { has_before_ = false; }
  const OverlapPeaks& finish() {
    if (open_) close({before_s_m_, before_.overlap_m()});
    return peaks_;
  }

 private:
  void meetPeak(double s_m, const Overlap::Value& here) {
    if (peaks_.count == kMostPeaks || cannotTouch(s_m, here)) return;
    const FlatPlace top = findFlatPlace(overlap_, before_s_m_, before_.tilt, s_m, here.tilt);
    if (top.overlap_m <= kLeast_m) return;
    peaks_.peak[peaks_.count] = {top.s_m, top.overlap_m, left_.s_m, 0.0, left_.overlap_m, 0.0};
    open_ = true;
  }
  /// True if a peak between the last two nodes stays below zero by far: it lies under both ends' tangents, and twice
  /// their rise leaves room for a curvature that changes.
  bool cannotTouch(double s_m, const Overlap::Value& here) const {
    const double step_m = s_m - before_s_m_;
    return std::min(before_.overlap_m() + 2.0 * before_.slope() * step_m,
                    here.overlap_m() - 2.0 * here.slope() * step_m) < 0.0;
  }
  void meetValley(double s_m, const Overlap::Value& here) {
    if (!open_) return;
    close(findFlatPlace(overlap_, before_s_m_, before_.tilt, s_m, here.tilt));
  }
  void close(const FlatPlace& end) {
    peaks_.peak[peaks_.count].right_m = end.s_m;
    peaks_.peak[peaks_.count].right_e_m = end.overlap_m;
    ++peaks_.count;
    open_ = false;
    left_ = end;
  }

  const Overlap& overlap_;
  OverlapPeaks peaks_;
  Overlap::Value before_{};
  double before_s_m_ = 0.0;
  bool has_before_ = false;
  bool open_ = false;  ///< the last peak's stretch has no right end yet
  FlatPlace left_{};   ///< where the next peak's stretch begins
};

template <std::size_t N>
using Values = std::array<Overlap::Value, N>;

template <typename Block, std::size_t N>
void computeValues(const Overlap& overlap, const Block& block, Values<N>& values) {
  Overlap::Lanes<N> lanes;
  lanes.s_m = block.s_m;
  lanes.wheel_z_m = block.wheel_z_m;
  lanes.wheel_slope = block.wheel_slope;
  lanes.wheel_slope_1pm = block.wheel_slope_1pm;
  overlap.computeLanes(lanes);
  for (std::size_t i = 0; i < N; ++i)
    values[i] = Overlap::makeValue(lanes.d_m[i] - lanes.rail_z_m[i], lanes.y_slope[i], lanes.d_slope[i],
                                   lanes.rail_slope[i], lanes.rail_slope_1pm[i]);
}

ContactRegion makeRegion(const Overlap& overlap, const RegionShape& shape, double share) {
  const Overlap::Place place = overlap.placeAt(shape.s_m);
  ContactRegion region;
  region.p_T = {place.x_m, place.y_m, -place.rail_z_m};
  region.angle_rad = std::atan2(-shape.side, shape.up);
  region.rolling_radius_m = place.radius_m;
  region.approach_m = shape.overlap_m;
  region.curvature.across_1pm = shape.across_1pm;
  region.curvature.along_1pm = 1.0 / (place.radius_m * std::sqrt(1.0 + place.wheel_slope * place.wheel_slope));
  region.share = share;
  return region;
}

}  // namespace

ContactSearch::ContactSearch(const WheelRailGeometry& geometry) : geometry_(geometry) {
  const HeightTable& wheel = geometry_.wheel();
  std::size_t count = 0;
  const auto add = [&](double s_m) {
    if (count % kBlock == 0) blocks_.emplace_back();
    const HeightTable::Value value = wheel.at(s_m);
    for (std::size_t i = count++ % kBlock; i < kBlock; ++i) {  // the last node fills its block
      blocks_.back().s_m[i] = s_m;
      blocks_.back().wheel_z_m[i] = value.z_m;
      blocks_.back().wheel_slope[i] = value.slope;
      blocks_.back().wheel_slope_1pm[i] = value.slope_1pm;
    }
    return value;
  };
  for (double s_m = wheel.begin_m(); s_m < wheel.end_m();) {
    const HeightTable::Value value = add(s_m);
    s_m += kNodeDistance_m / std::sqrt(1.0 + value.slope * value.slope);
  }
  add(wheel.end_m());

  std::vector<ReachTable::Stretch> stretches;  // from the node before each block to the node behind it
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    stretches.push_back({i > 0 ? blocks_[i - 1].s_m.back() : wheel.begin_m(),
                         i + 1 < blocks_.size() ? blocks_[i + 1].s_m.front() : wheel.end_m()});
  }
  reach_ = ReachTable(geometry_, stretches);
}

std::size_t ContactSearch::find(Side side, const WheelsetPose& pose,
                                std::array<ContactRegion, kMostContacts>& regions) const {
  const bool mirrored = side == Side::kRight;
  const WheelsetPose left_pose = mirrored ? WheelsetPose{-pose.y_m, pose.z_m, -pose.roll_rad, -pose.yaw_rad} : pose;
  const Overlap overlap(geometry_, left_pose);

  // only where there is rail: the locus lies near y + taping line + s, pushed outwards by roll
  const double shift_m = left_pose.y_m + geometry_.tapingLine_m() + geometry_.wheelRadius_m() * left_pose.roll_rad;
  const double first_m = geometry_.railTop_m() + geometry_.rail().begin_m() - kBeside_m - shift_m;
  const double last_m = geometry_.railTop_m() + geometry_.rail().end_m() + kBeside_m - shift_m;
  PeakFinder finder(overlap);
  Values<kBlock> values;
  const ReachTable::Reach reach = reach_.reachOf(left_pose, geometry_);
  for (std::size_t at = 0; at < blocks_.size(); ++at) {
    const Block& block = blocks_[at];
    if (block.s_m.back() < first_m) continue;
    if (block.s_m.front() > last_m) break;
    if (!reach_.mayTouch(at, reach)) {
      finder.skip();
      continue;
    }
    computeValues(overlap, block, values);
    for (std::size_t i = 0; i < kBlock; ++i)
      if (block.s_m[i] >= first_m && block.s_m[i] <= last_m) finder.meet(block.s_m[i], values[i]);
  }
  const BlendedRegions blended = blendRegions(overlap, finder.finish());
  for (std::size_t i = 0; i < blended.count; ++i) {
    regions[i] = makeRegion(overlap, blended.shape[i], blended.share[i]);
    if (mirrored) {
      regions[i].p_T.y() = -regions[i].p_T.y();
      regions[i].angle_rad = -regions[i].angle_rad;
    }
  }
  return blended.count;
}

}  // namespace loco
