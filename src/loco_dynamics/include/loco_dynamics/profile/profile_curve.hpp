#pragma once

#include <cstddef>
#include <vector>

#include "loco_dynamics/profile/profile_points.hpp"

namespace loco {

/// Smooth curve through points: cubic splines y(t), z(t) of the chord length t, continuous in slope and curvature,
/// their second derivatives zero at both ends. In the profile frame (y to the field side, z down).
class ProfileCurve {
 public:
  /// @param points  at least two, no two neighbours alike
  explicit ProfileCurve(ProfilePoints points);

  struct Value {
    double y_m, z_m;
    double dy, dz;            ///< derivatives by t [-]
    double ddy_1pm, ddz_1pm;  ///< second derivatives by t
    double slope() const { return dz / dy; }
    /// Of the surface z(y): positive where the material above a wheel's (below a rail's) surface bulges down (up) -
    /// that is d2z/dy2 over the arc length squared. [1/m]
    double computeCurvature_1pm() const;
  };
  /// @param t_m  chord length from the first point, 0 to length_m()
  Value at(double t_m) const;
  double length_m() const { return t_m_.back(); }

  const ProfilePoints& points() const { return points_; }
  /// Chord length at a point.
  double chordAt(std::size_t point) const { return t_m_[point]; }

 private:
  ProfilePoints points_;
  std::vector<double> t_m_;                ///< chord length at each point
  std::vector<double> ddy_1pm_, ddz_1pm_;  ///< second derivatives at each point
};

/// Part of a curve along which y rises and the surface is nowhere steeper than a limit.
struct CurveRange {
  double begin_m;  ///< chord lengths
  double end_m;
};

/// The largest such range about a point of the curve.
CurveRange findRangeBelowSlope(const ProfileCurve& curve, std::size_t about, double largest_slope);

}  // namespace loco
