#include "loco_dynamics/contact/flexibility.hpp"

#include <algorithm>
#include <cmath>

namespace loco {

namespace {
constexpr double kPi = 3.14159265358979323846;
constexpr double kMillimetre = 1e-3;
constexpr double kFullySliding = 3.0;  ///< sum of creepages over characteristic creepages from which L is one

double square(double x) { return x * x; }
}  // namespace

Flexibilities computeFlexibilities(const ContactPatch& patch) {
  const double a_over_G = patch.a_m / patch.shear_modulus_Pa;
  return {8.0 * a_over_G / (3.0 * patch.kalker.c11), 8.0 * a_over_G / (3.0 * patch.kalker.c22),
          kPi * a_over_G * std::sqrt(patch.a_m / patch.b_m) / (4.0 * patch.kalker.c23)};  // (C6)
}

Flexibilities blendFlexibilities(const Flexibilities& three, const ContactPatch& patch, const Creepage& creepage,
                                 double mu_static) {
  const double xx = square(creepage.xi_x);
  const double yy = square(creepage.xi_y);
  const double ss = square(3.0 * kPi / 32.0 * patch.a_m * creepage.phi_1pm);
  const double compliance = xx / three.l1 + yy / three.l2 + ss / three.l3;
  if (!(compliance > 0.0)) return three;
  const double one = (xx + yy + ss) / compliance;

  const double ab = patch.a_m * patch.b_m;
  const double scale = mu_static * patch.normal_N / (ab * patch.shear_modulus_Pa);
  const double x1 = scale / patch.kalker.c11;
  const double x2 = scale / patch.kalker.c22;
  const double x3 = scale / (std::sqrt(ab) * patch.kalker.c23) * kMillimetre;
  const double creep = xx + yy + square(creepage.phi_1pm * kMillimetre);
  const double t = std::min(1.0, std::sqrt(creep / (x1 * x1 + x2 * x2 + x3 * x3)) / kFullySliding);
  return {three.l1 + t * (one - three.l1), three.l2 + t * (one - three.l2), three.l3 + t * (one - three.l3)};  // (C7)
}

}  // namespace loco
