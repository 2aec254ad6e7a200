#pragma once

namespace loco {

/// Curvatures of two bodies that touch, each the sum over both bodies: convex is positive.
struct RelativeCurvature {
  double along_1pm = 0.0;   ///< along rolling: 1/r of the wheel on a straight rail
  double across_1pm = 0.0;  ///< across: wheel (negative where hollow) plus rail crown
};

/// The elasticity of both bodies, taken to be of one material.
struct Elasticity {
  double young_Pa = 210e9;
  double poisson = 0.28;
};

/// Hertz's contact of one pair of curvatures: what does not depend on load is found once.
///   N = K delta^1.5,   a, b ~ N^(1/3)                                                                    (C1)
/// Source: Johnson, Contact Mechanics, 1985, Eqs. (4.24) to (4.30). Not modelled: curvature that changes within the
/// patch, friction's influence on the pressure, plasticity.
class HertzContact {
 public:
  /// Both curvatures must be > 0: surfaces that conform touch along a line or at two places.
  HertzContact(const RelativeCurvature& curvature, const Elasticity& elasticity);

  struct Ellipse {
    double a_m;  ///< along rolling
    double b_m;  ///< across
  };
  Ellipse computeEllipse(double normal_N) const;
  double aOverB() const { return a_unit_ / b_unit_; }

  /// Normal force [N] at approach delta [m]; 0 if the bodies do not touch (delta <= 0).
  double computeNormalForce(double approach_m) const;
  double computeApproach(double normal_N) const;
  /// dN/ddelta [N/m]; 0 if the bodies do not touch.
  double computeTangentStiffness(double approach_m) const;

 private:
  double a_unit_;     ///< a at 1 N [m]
  double b_unit_;     ///< b at 1 N [m]
  double stiffness_;  ///< K [N/m^1.5]
};

}  // namespace loco
