#pragma once

#include <cmath>

#include "loco_dynamics/profile/contact_region.hpp"
#include "loco_dynamics/profile/wheel_rail_geometry.hpp"

namespace loco {

/// How deep the LEFT wheel of a wheelset in a given pose lies in its rail, by place on the wheel's profile.
///
/// The wheel is a surface of revolution. Of the circle of each profile point only that point can touch the rail, which
/// is straight, where the surface's normal has no component along x:
///   e_r . x = r'(s) e_a . x,    e_a axle's direction to the left, e_r from the axle to the point          (W1)
/// These points are a curve (y(s), d(s)), d down; for a yawed wheelset it runs ahead of the axle where the wheel is
/// steep. The overlap is its depth below the rail's surface, taken along the rail's normal:
///   e(s) = (d - z_rail(y)) cos(gamma),    tan(gamma) = z_rail'(y)                                         (W2)
/// Source: Wang's trace line for (W1), as in Shabana, Zaazaa, Sugiyama, Railroad Vehicle Dynamics, 2008.
class Overlap {
 public:
  Overlap(const WheelRailGeometry& geometry, const WheelsetPose& pose)
      : geometry_(geometry),
        pose_(pose),
        sin_roll_(std::sin(pose.roll_rad)),
        cos_roll_(std::cos(pose.roll_rad)),
        sin_yaw_(std::sin(pose.yaw_rad)),
        cos_yaw_(std::cos(pose.yaw_rad)) {
    const double length = std::hypot(cos_yaw_, sin_yaw_ * sin_roll_);
    cos_0_ = cos_yaw_ / length;
    sin_0_ = sin_yaw_ * sin_roll_ / length;
    lead_ = -sin_yaw_ * cos_roll_ / length;
  }

  struct Value {
    double overlap_m;  ///< e
    double slope;      ///< de/ds
  };
  /// A place's full geometry.
  struct Place {
    double x_m, y_m, rail_z_m;  ///< y from the track's centre to the left, z down from the rail tops
    double radius_m;
    double wheel_slope;  ///< dr/ds
    double rail_slope, rail_cos;
    double overlap_m;
    double rail_length;  ///< arc length along the rail per ds
  };

  Value at(double s_m) const { return at(s_m, geometry_.wheel().at(s_m)); }
  Value at(double s_m, const HeightTable::Value& wheel) const {
    const Locus locus = computeLocus(s_m, wheel);
    const HeightTable::Value rail = geometry_.rail().at(locus.y_m - geometry_.railTop_m());
    const double cos_gamma = 1.0 / std::sqrt(1.0 + rail.slope * rail.slope);
    const double depth = locus.d_m - rail.z_m;
    const double cos_slope = -rail.slope * rail.slope_1pm * cos_gamma * cos_gamma * cos_gamma;
    return {depth * cos_gamma,
            (locus.d_slope - rail.slope * locus.y_slope) * cos_gamma + depth * cos_slope * locus.y_slope};
  }
  Place placeAt(double s_m) const;

 private:
  struct Locus {
    double y_m, d_m;          ///< d down from the rail tops' plane
    double y_slope, d_slope;  ///< by s
    double radius_m, sin_theta, cos_theta;
  };
  Locus computeLocus(double s_m, const HeightTable::Value& wheel) const {
    const double r = geometry_.wheelRadius_m() + wheel.z_m, arm = geometry_.tapingLine_m() + s_m;
    const double q = lead_ * wheel.slope, root = std::sqrt(1.0 - q * q);  // sine, cosine of theta - theta_0, (W1)
    const double sin_theta = q * cos_0_ + root * sin_0_, cos_theta = root * cos_0_ - q * sin_0_;
    const double theta_slope = lead_ * wheel.slope_1pm / root;
    const double across = cos_theta * cos_yaw_ * sin_roll_ + sin_theta * sin_yaw_;
    const double across_turned = -sin_theta * cos_yaw_ * sin_roll_ + cos_theta * sin_yaw_;
    Locus locus;
    locus.y_m = pose_.y_m + arm * cos_yaw_ * cos_roll_ + r * across;
    locus.d_m = r * cos_theta * cos_roll_ - arm * sin_roll_ - pose_.z_m - geometry_.wheelRadius_m();
    locus.y_slope = cos_yaw_ * cos_roll_ + wheel.slope * across + r * across_turned * theta_slope;
    locus.d_slope = wheel.slope * cos_theta * cos_roll_ - sin_roll_ - r * sin_theta * cos_roll_ * theta_slope;
    locus.radius_m = r;
    locus.sin_theta = sin_theta;
    locus.cos_theta = cos_theta;
    return locus;
  }

  const WheelRailGeometry& geometry_;
  WheelsetPose pose_;
  double sin_roll_, cos_roll_, sin_yaw_, cos_yaw_;
  double sin_0_, cos_0_;  ///< of theta_0, where e_r has no x
  double lead_;           ///< sin(theta - theta_0) over r'
};

inline Overlap::Place Overlap::placeAt(double s_m) const {
  const HeightTable::Value wheel = geometry_.wheel().at(s_m);
  const Locus locus = computeLocus(s_m, wheel);
  const HeightTable::Value rail = geometry_.rail().at(locus.y_m - geometry_.railTop_m());
  const double arm = geometry_.tapingLine_m() + s_m, rail_length = std::sqrt(1.0 + rail.slope * rail.slope);
  Place place;
  place.x_m = -arm * sin_yaw_ * cos_roll_ +
              locus.radius_m * (locus.sin_theta * cos_yaw_ - locus.cos_theta * sin_yaw_ * sin_roll_);
  place.y_m = locus.y_m;
  place.rail_z_m = rail.z_m;
  place.radius_m = locus.radius_m;
  place.wheel_slope = wheel.slope;
  place.rail_slope = rail.slope;
  place.rail_cos = 1.0 / rail_length;
  place.overlap_m = (locus.d_m - rail.z_m) * place.rail_cos;
  place.rail_length = rail_length * locus.y_slope;
  return place;
}

}  // namespace loco
