#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "loco_dynamics/profile/contact_region.hpp"
#include "loco_dynamics/profile/wheel_rail_geometry.hpp"

namespace loco {

/// How deep the LEFT wheel of a wheelset in a given pose lies in its rail, by place on the wheel's profile.
///
/// The wheel is a surface of revolution. Of the circle of each profile point only that point can touch the rail, which
/// is straight, where the surface's normal has no component along x:
///   e_r . x = r'(s) e_a . x,    e_a axle's direction to the left, e_r from the axle to the point          (G1)
/// These points are a curve (y(s), d(s)), d down; for a yawed wheelset it runs ahead of the axle where the wheel is
/// steep. The overlap is its depth below the rail's surface, taken along the rail's normal:
///   e(s) = (d - z_rail(y)) cos(gamma),    tan(gamma) = z_rail'(y)                                         (G2)
/// Source: Wang's trace line for (G1), as in Shabana, Zaazaa, Sugiyama, Railroad Vehicle Dynamics, 2008.
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

  /// Depth and slope at a place without the roots that its sign and its zeros do not need.
  struct Value {
    double depth_m;        ///< e/cos(gamma)
    double tilt;           ///< (de/ds)/cos^3(gamma)
    double length_square;  ///< 1/cos^2(gamma)

    double overlap_m() const { return depth_m / std::sqrt(length_square); }             ///< e
    double slope() const { return tilt / (length_square * std::sqrt(length_square)); }  ///< de/ds
    /// How far it is to e = 0 along the tangent: -e/(de/ds).
    double newtonStep_m() const { return -depth_m * length_square / tilt; }
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

  Value at(double s_m) const {
    const Locus locus = computeLocus(s_m, geometry_.wheel().at(s_m));
    const HeightTable::Value rail = geometry_.rail().at(locus.y_m - geometry_.railTop_m());
    return makeValue(locus.d_m - rail.z_m, locus.y_slope, locus.d_slope, rail.slope, rail.slope_1pm);
  }
  /// @param tilt_slope  becomes about d(tilt)/ds: what the lead of a yawed wheel changes by is left out
  Value at(double s_m, double& tilt_slope) const {
    const HeightTable::Value wheel = geometry_.wheel().at(s_m);
    const Locus locus = computeLocus(s_m, wheel);
    const HeightTable::Value rail = geometry_.rail().at(locus.y_m - geometry_.railTop_m());
    const Value value = makeValue(locus.d_m - rail.z_m, locus.y_slope, locus.d_slope, rail.slope, rail.slope_1pm);
    tilt_slope = (wheel.slope_1pm - rail.slope_1pm * locus.y_slope * locus.y_slope) * value.length_square;
    return value;
  }
  Place placeAt(double s_m) const;

  /// Several places at once: each loop over them does one thing, so that they share vector registers.
  template <std::size_t N>
  struct Lanes {
    std::array<double, N> s_m;
    std::array<double, N> wheel_z_m, wheel_slope, wheel_slope_1pm;  ///< of the profile
    std::array<double, N> y_m, d_m, y_slope, d_slope;               ///< of the wheel's curve
    std::array<double, N> rail_z_m, rail_slope, rail_slope_1pm;
  };
  /// Looks the wheel's profile up at s.
  template <std::size_t N>
  void lookUpWheel(Lanes<N>& lanes) const;
  /// Computes curve and rail from s and the wheel's profile.
  template <std::size_t N>
  void computeLanes(Lanes<N>& lanes) const;
  static Value makeValue(double depth_m, double y_slope, double d_slope, double rail_slope, double rail_slope_1pm) {
    const double length_square = 1.0 + rail_slope * rail_slope;
    return {depth_m, (d_slope - rail_slope * y_slope) * length_square - depth_m * rail_slope * rail_slope_1pm * y_slope,
            length_square};
  }

 private:
  struct Locus {
    double y_m, d_m;          ///< d down from the rail tops' plane
    double y_slope, d_slope;  ///< by s
    double radius_m, sin_theta, cos_theta;
  };
  Locus computeLocus(double s_m, const HeightTable::Value& wheel) const {
    const double r = geometry_.wheelRadius_m() + wheel.z_m, arm = geometry_.tapingLine_m() + s_m;
    const double q = lead_ * wheel.slope, root = std::sqrt(1.0 - q * q);  // sine, cosine of theta - theta_0, (G1)
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

template <std::size_t N>
void Overlap::lookUpWheel(Lanes<N>& lanes) const {
  for (std::size_t i = 0; i < N; ++i) {
    const HeightTable::Value wheel = geometry_.wheel().at(lanes.s_m[i]);
    lanes.wheel_z_m[i] = wheel.z_m;
    lanes.wheel_slope[i] = wheel.slope;
    lanes.wheel_slope_1pm[i] = wheel.slope_1pm;
  }
}

template <std::size_t N>
void Overlap::computeLanes(Lanes<N>& lanes) const {
  for (std::size_t i = 0; i < N; ++i) {
    const Locus locus =
        computeLocus(lanes.s_m[i], {lanes.wheel_z_m[i], lanes.wheel_slope[i], lanes.wheel_slope_1pm[i]});
    lanes.y_m[i] = locus.y_m;
    lanes.d_m[i] = locus.d_m;
    lanes.y_slope[i] = locus.y_slope;
    lanes.d_slope[i] = locus.d_slope;
  }
  for (std::size_t i = 0; i < N; ++i) {
    const HeightTable::Value rail = geometry_.rail().at(lanes.y_m[i] - geometry_.railTop_m());
    lanes.rail_z_m[i] = rail.z_m;
    lanes.rail_slope[i] = rail.slope;
    lanes.rail_slope_1pm[i] = rail.slope_1pm;
  }
}

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
