#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "loco_dynamics/contact/hertz.hpp"

namespace loco {

/// Contacts of one wheel at most: tread, root, flange.
inline constexpr std::size_t kMostContacts = 3;

enum class Side : std::size_t { kLeft = 0, kRight = 1 };

/// Pose of a wheelset against the track frame T (x forward, y left, z up; origin midway between the rail tops).
struct WheelsetPose {
  double y_m = 0.0;  ///< axle centre, + left
  double z_m = 0.0;  ///< axle centre's height over its nominal one, which is the wheel's radius r0 above the rail tops
  double roll_rad = 0.0;  ///< about x, + left wheel up; turns first, about the axle's own x
  double yaw_rad = 0.0;   ///< about z, + nose left
};

/// One region where a wheel overlaps its rail.
struct ContactRegion {
  /// Contact point in T: x ahead of the axle centre, y left of the track's centre, z above the rail tops [m]. Its x
  /// holds both the yawed wheel's way forward (-+0.75 m times yaw) and the contact's own lead r tan(gamma) psi.
  Eigen::Vector3d p_T = Eigen::Vector3d::Zero();
  /// Of the contact plane about x: the rail's outward normal is n_T = (0, -sin, cos). A left wheel has angle > 0 on its
  /// tread (its cone gets thinner to the field side) and up to +1.2 on its flange, a right wheel < 0. [rad]
  double angle_rad = 0.0;
  double rolling_radius_m = 0.0;
  double approach_m = 0.0;      ///< overlap delta > 0, along the normal
  RelativeCurvature curvature;  ///< effective: with it Hertz gives N = K delta^1.5 and the ellipse
  /// 0 to 1: the region counts with this share of its forces (normal and creep force of the whole ellipse). 1 but where
  /// two regions merge or split.
  double share = 1.0;
};

}  // namespace loco
