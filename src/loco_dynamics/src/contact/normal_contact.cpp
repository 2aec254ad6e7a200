#include "loco_dynamics/contact/normal_contact.hpp"

#include <algorithm>

namespace loco {

NormalContact::NormalContact(const Parameters& parameters)
    : parameters_(parameters), hertz_(parameters.curvature, parameters.elasticity) {}

double NormalContact::elasticForce(double approach_m) const {
  return parameters_.law == NormalLaw::kHertz ? hertz_.computeNormalForce(approach_m)
                                              : parameters_.linear_stiffness_N_per_m * approach_m;
}

double NormalContact::computeForce(double approach_m, double approach_rate_mps) const {
  if (approach_m <= 0.0) return 0.0;
  return std::max(0.0, elasticForce(approach_m) + parameters_.damping_N_s_per_m * approach_rate_mps);  // (P1)
}

double NormalContact::computeStoredEnergy(double approach_m) const {
  if (approach_m <= 0.0) return 0.0;
  const double share = parameters_.law == NormalLaw::kHertz ? 0.4 : 0.5;  // integral of K d^1.5, or of k d
  return share * elasticForce(approach_m) * approach_m;
}

double NormalContact::computeApproach(double normal_N) const {
  return parameters_.law == NormalLaw::kHertz ? hertz_.computeApproach(normal_N)
                                              : normal_N / parameters_.linear_stiffness_N_per_m;
}

double NormalContact::computeTangentStiffness(double normal_N) const {
  return parameters_.law == NormalLaw::kHertz ? hertz_.computeTangentStiffness(hertz_.computeApproach(normal_N))
                                              : parameters_.linear_stiffness_N_per_m;
}

}  // namespace loco
