#pragma once

#include <cstddef>
#include <vector>

#include "loco_dynamics/profile/contact_region.hpp"
#include "loco_dynamics/profile/wheel_rail_geometry.hpp"

namespace loco {

/// Upper bounds of the overlap by stretch of the wheel: tells of most of the wheel, before it is looked at, that it
/// does not touch. With s along the wheel, c the wheel's place on the rail (c = 0: taping line above the rail's top)
///   d - z_rail <= max over s in the stretch of (z_wheel(s) - z_rail(s + c)) - sin(roll) arm - z        (G9)
/// since no point of a wheel circle is lower than its radius below the axle. c is known but for what yaw and roll move.
/// Constant; poses are the LEFT wheel's.
class ReachTable {
 public:
  /// A stretch of the wheel [m].
  struct Stretch {
    double begin_m, end_m;
  };
  ReachTable() = default;
  ReachTable(const WheelRailGeometry& geometry, const std::vector<Stretch>& stretches);

  /// What a pose says of all stretches.
  struct Reach {
    std::size_t first_shift, last_shift;  ///< those that may be; none if first > last: nothing is known
    double sin_roll, z_m, taping_line_m;
  };
  Reach reachOf(const WheelsetPose& left_pose, const WheelRailGeometry& geometry) const;
  bool mayTouch(std::size_t stretch, const Reach& reach) const;

 private:
  double computeBound(const WheelRailGeometry& geometry, const Stretch& stretch, double shift_m) const;

  std::vector<Stretch> stretches_;
  std::vector<double> bound_m_;  ///< by stretch, then by shift
};

}  // namespace loco
