#include "loco_dynamics/contact/polach.hpp"

#include <cmath>

namespace loco {

namespace {

constexpr double kPi = 3.14159265358979323846;

/// K of (C12): -2|e|/3 for small e, 0 for large.
double computeSpinSaturation(double e_s) {
  const double e2 = e_s * e_s;
  const double d = (e2 - 1.0) / (e2 + 1.0);
  const double root = std::sqrt((1.0 - d) * (1.0 + d));
  return std::abs(e_s) * (d * d * d / 3.0 - d * d / 2.0 + 1.0 / 6.0) - root * root * root / 3.0;
}

}  // namespace

PlaneForce computePolachForce(const ContactPatch& patch, const PolachFactors& factors, const Creepage& creepage,
                              double mu) {
  const double with_spin = creepage.xi_y + creepage.phi_1pm * patch.a_m;
  const double s_yc = std::abs(with_spin) > std::abs(creepage.xi_y) ? with_spin : creepage.xi_y;
  const double s_c = std::sqrt(creepage.xi_x * creepage.xi_x + s_yc * s_yc);
  if (!(s_c > 0.0)) return {0.0, 0.0};
  const double full_slip = mu * patch.normal_N;

  const double s = std::sqrt(creepage.xi_x * creepage.xi_x + creepage.xi_y * creepage.xi_y);
  const double c_x = patch.kalker.c11 * creepage.xi_x;
  const double c_y = patch.kalker.c22 * creepage.xi_y;
  const double c = s > 0.0 ? std::sqrt(c_x * c_x + c_y * c_y) / s : patch.kalker.c22;
  const double e = patch.shear_modulus_Pa * kPi * patch.a_m * patch.b_m * c * s_c / (4.0 * full_slip);
  const double e_A = factors.k_A * e;
  const double force = 2.0 * full_slip / kPi * (e_A / (1.0 + e_A * e_A) + std::atan(factors.k_S * e));  // (C11)

  const double shape = 1.0 + 6.3 * (1.0 - std::exp(-patch.a_m / patch.b_m));
  const double e_s = 8.0 / 3.0 * patch.shear_modulus_Pa * patch.b_m * std::sqrt(patch.a_m * patch.b_m) *
                     patch.kalker.c23 * s_yc / full_slip * 0.5 * (factors.k_A + factors.k_S) / shape;
  const double spin =
      9.0 / 16.0 * patch.a_m * full_slip * computeSpinSaturation(e_s) * shape * creepage.phi_1pm;  // (C12)

  const double x = -force * creepage.xi_x / s_c;
  const double y = (-force * creepage.xi_y + spin) / s_c;
  const double cut = std::sqrt(x * x + y * y) / full_slip;
  return cut > 1.0 ? PlaneForce{x / cut, y / cut} : PlaneForce{x, y};
}

}  // namespace loco
