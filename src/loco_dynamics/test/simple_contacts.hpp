#pragma once

#include <cmath>

#include "loco_dynamics/contact_finder.hpp"

namespace fixtures {

/// A coned wheel on a rail whose head is a circle (or a knife edge, radius 0), both wheels alike: small angles, exact
/// otherwise. Contact without load at y = +-0.75 m with the wheelset in its nominal pose.
struct ConedWheel {
  double conicity = 1.0 / 20.0;
  double crown_radius_m = 0.3;
  double wheel_radius_m = 0.5335;
  double half_distance_m = 0.75;
  double across_1pm = 1.0 / 0.3;  ///< for Hertz

  std::size_t find(loco::Side side, const loco::WheelsetPose& pose,
                   std::array<loco::ContactRegion, loco::kMostContacts>& regions) const {
    if (side == loco::Side::kLeft) return findLeft(pose, regions);
    const std::size_t found = findLeft({-pose.y_m, pose.z_m, -pose.roll_rad, -pose.yaw_rad}, regions);
    regions[0].p_T.y() *= -1.0;
    regions[0].angle_rad *= -1.0;
    return found;
  }

  std::size_t findLeft(const loco::WheelsetPose& pose,
                       std::array<loco::ContactRegion, loco::kMostContacts>& regions) const {
    using Eigen::Vector2d;
    const double cone = std::atan(conicity), angle = cone + pose.roll_rad;
    const Vector2d n0(-std::sin(cone), std::cos(cone)), n(-std::sin(angle), std::cos(angle));
    const Vector2d centre = Vector2d(half_distance_m, 0.0) - crown_radius_m * n0;
    const Vector2d axle(pose.y_m, wheel_radius_m + pose.z_m);
    const Vector2d along(std::cos(pose.roll_rad), std::sin(pose.roll_rad)), down(along.y(), -along.x());
    const Vector2d on_wheel = axle + half_distance_m * along + wheel_radius_m * down;
    const Vector2d on_rail = centre + crown_radius_m * n;
    loco::ContactRegion& r = regions[0];
    r = {};
    r.approach_m = (on_rail - on_wheel).dot(n);
    if (!(r.approach_m > 0.0)) return 0;
    r.angle_rad = angle;
    r.rolling_radius_m = wheel_radius_m - conicity * ((on_rail - axle).dot(along) - half_distance_m);
    const Vector2d arm = on_rail - axle;  // the wheel's surface there must move along itself when it spins
    const double x = pose.yaw_rad * (-std::sin(angle) * arm.y() - std::cos(angle) * arm.x()) /
                     (std::cos(angle) + pose.roll_rad * std::sin(angle));
    r.p_T = {x, on_rail.x(), on_rail.y()};
    r.curvature = {1.0 / wheel_radius_m, across_1pm};
    r.share = 1.0;
    return 1;
  }
};

/// The 2D locomotive's contact: one given geometry wherever the wheelset is, upright, at the nominal radius.
struct GivenPatch {
  double wheel_radius_m = 0.5335;
  double across_1pm = 1.0 / 0.3 - 2.25;

  std::size_t find(loco::Side side, const loco::WheelsetPose& pose,
                   std::array<loco::ContactRegion, loco::kMostContacts>& regions) const {
    loco::ContactRegion& r = regions[0];
    r = {};
    r.approach_m = -pose.z_m;
    if (!(r.approach_m > 0.0)) return 0;
    r.rolling_radius_m = wheel_radius_m;
    r.p_T = {0.0, side == loco::Side::kLeft ? 0.75 : -0.75, pose.z_m};
    r.curvature = {1.0 / wheel_radius_m, across_1pm};
    r.share = 1.0;
    return 1;
  }
};

}  // namespace fixtures
