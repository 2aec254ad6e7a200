#include "loco_dynamics/contact/reduction_factor.hpp"

#include <cmath>

namespace loco {

double computeStressGradient(double k0, const ContactPatch& patch, const Creepage& creepage, double mu) {
  constexpr double kPi = 3.14159265358979323846;
  const double with_spin = creepage.xi_y + creepage.phi_1pm * patch.a_m;
  const double nu_y = std::abs(with_spin) > std::abs(creepage.xi_y) ? with_spin : creepage.xi_y;
  const double nu_tot = std::sqrt(creepage.xi_x * creepage.xi_x + nu_y * nu_y);
  return k0 * patch.shear_modulus_Pa * kPi * patch.a_m * patch.b_m * patch.kalker.c11 * nu_tot /
         (4.0 * mu * patch.normal_N);  // (C5)
}

double computeReduction(const ReductionFactor& factor, double eps) {
  return factor.k0 * (factor.alpha_inf + (1.0 - factor.alpha_inf) / (1.0 + factor.beta * eps));  // Eq. (3)
}

}  // namespace loco
