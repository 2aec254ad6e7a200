#include "loco_dynamics/profile/reach_table.hpp"

#include <algorithm>
#include <cmath>

namespace loco {

namespace {

// The table's shifts: fine enough that a bound on a tread is 0.05 mm too high, wide enough for any wheel on its rail.
constexpr double kShift_m = 0.5e-3;
constexpr double kLargestShift_m = 30e-3;
constexpr std::size_t kShifts = 121;
constexpr double kSample_m = 0.2e-3;
constexpr double kSteepest = 6.0;            // profiles go on straight beyond 80 degrees, tangent 5.67
constexpr double kDeepestProfile_m = 60e-3;  // the deepest that a file may be
constexpr double kSafety_m = 10e-6;          // chosen: more than curvature adds between samples on arcs of 1 mm

}  // namespace

ReachTable::ReachTable(const WheelRailGeometry& geometry, const std::vector<Stretch>& stretches)
    : stretches_(stretches) {
  for (const Stretch& stretch : stretches_) {
    for (std::size_t i = 0; i < kShifts; ++i) {
      bound_m_.push_back(computeBound(geometry, stretch, kShift_m * static_cast<double>(i) - kLargestShift_m));
    }
  }
}

/// For all shifts within half a step of this one: the profiles' slopes carry the samples to what lies between.
double ReachTable::computeBound(const WheelRailGeometry& geometry, const Stretch& stretch, double shift_m) const {
  double bound_m = -1.0;
  const auto samples = static_cast<std::size_t>(std::ceil((stretch.end_m - stretch.begin_m) / kSample_m)) + 1;
  for (std::size_t i = 0; i <= samples; ++i) {
    const double s_m = std::min(stretch.begin_m + kSample_m * static_cast<double>(i), stretch.end_m);
    const HeightTable::Value wheel = geometry.wheel().at(s_m), rail = geometry.rail().at(s_m + shift_m);
    const double rail_way_m = 0.5 * (kSample_m + kShift_m);
    const double between_m = 0.5 * kSample_m * std::abs(wheel.slope) + rail_way_m * std::abs(rail.slope) +
                             0.5 * rail_way_m * rail_way_m * (std::abs(wheel.slope_1pm) + std::abs(rail.slope_1pm));
    bound_m = std::max(bound_m, wheel.z_m - rail.z_m + between_m + kSafety_m);
  }
  return bound_m;
}

ReachTable::Reach ReachTable::reachOf(const WheelsetPose& pose, const WheelRailGeometry& geometry) const {
  const double sin_roll = std::sin(pose.roll_rad), r0_m = geometry.wheelRadius_m();
  const double shift_m = pose.y_m + geometry.tapingLine_m() + r0_m * sin_roll - geometry.railTop_m();
  // y - (s + shift): the axle's tilt shortens its arm (below 1.5 m), r is not r0, a yawed wheel touches ahead
  const double yaw_square = pose.yaw_rad * pose.yaw_rad, roll_square = pose.roll_rad * pose.roll_rad;
  const double largest_r_m = r0_m + kDeepestProfile_m;
  const double moved_m = 0.75 * (yaw_square + roll_square) + kDeepestProfile_m * std::abs(sin_roll) +
                         largest_r_m * ((1.0 + kSteepest + 0.5 * kSteepest * kSteepest) * yaw_square + roll_square);
  const double low = (shift_m - moved_m + kLargestShift_m) / kShift_m,
               high = (shift_m + moved_m + kLargestShift_m) / kShift_m;
  Reach reach{1, 0, sin_roll, pose.z_m, geometry.tapingLine_m()};
  if (low >= 0.0 && high <= static_cast<double>(kShifts - 1)) {
    reach.first_shift = static_cast<std::size_t>(std::lround(low));
    reach.last_shift = static_cast<std::size_t>(std::lround(high));
  }
  return reach;
}

bool ReachTable::mayTouch(std::size_t stretch, const Reach& reach) const {
  if (reach.first_shift > reach.last_shift) return true;
  const Stretch& along = stretches_[stretch];
  const double arm_m = reach.taping_line_m + (reach.sin_roll > 0.0 ? along.begin_m : along.end_m);
  const double least_m = -reach.sin_roll * arm_m - reach.z_m;
  const double* const bound_m = &bound_m_[stretch * kShifts];
  for (std::size_t i = reach.first_shift; i <= reach.last_shift; ++i) {
    if (bound_m[i] + least_m > 0.0) return true;
  }
  return false;
}

}  // namespace loco
