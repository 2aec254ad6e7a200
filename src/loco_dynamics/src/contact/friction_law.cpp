#include "loco_dynamics/contact/friction_law.hpp"

#include <cmath>

namespace loco {

double computeFriction(const FrictionLaw& law, double slip_speed_mps) {
  return law.mu0 * ((1.0 - law.A) * std::exp(-law.B_s_per_m * slip_speed_mps) + law.A);  // Eq. (2)
}

}  // namespace loco
