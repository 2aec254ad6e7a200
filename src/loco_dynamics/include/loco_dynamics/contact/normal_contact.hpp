#pragma once

#include "loco_dynamics/contact/hertz.hpp"

namespace loco {

enum class NormalLaw {
  kHertz,  ///< N = K delta^1.5
  kLinear  ///< N = k delta
};

/// Normal force of one wheel on its rail over the approach delta of the two:                               (P1)
///   N = K delta^1.5 + c delta'  or  k delta + c delta',   N >= 0, 0 if they do not touch
/// The ellipse is Hertz's for this N with either law. Constant.
class NormalContact {
 public:
  struct Parameters {
    RelativeCurvature curvature;
    Elasticity elasticity;
    double damping_N_s_per_m = 0.0;  ///< c
    NormalLaw law = NormalLaw::kHertz;
    double linear_stiffness_N_per_m = 0.0;  ///< k, > 0 if the law is linear
  };
  explicit NormalContact(const Parameters& parameters);

  double computeForce(double approach_m, double approach_rate_mps) const;
  /// Elastic energy [J].
  double computeStoredEnergy(double approach_m) const;
  double computeApproach(double normal_N) const;
  /// dN/ddelta under a static load [N/m].
  double computeTangentStiffness(double normal_N) const;
  const HertzContact& hertz() const { return hertz_; }

 private:
  double elasticForce(double approach_m) const;

  Parameters parameters_;
  HertzContact hertz_;
};

}  // namespace loco
