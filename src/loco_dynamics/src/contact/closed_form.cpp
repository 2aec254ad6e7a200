#include "loco_dynamics/contact/closed_form.hpp"

#include <cmath>

namespace loco {

namespace {
constexpr double kPi = 3.14159265358979323846;
}  // namespace

double computeClosedForm(double x) {
  const double H = 0.75 * x;
  if (H >= 2.0) return 1.0;
  const double c0 = 0.5 * H;
  const double t0 = std::acos(c0);
  const double s0 = std::sqrt((1.0 - c0) * (1.0 + c0));
  // I4(pi/2) - I4(t0), with sin 2t = 2 s c and sin 4t = 4 s c (c^2 - s^2)
  const double sc = s0 * c0;
  const double rest = 3.0 / 8.0 * (0.5 * kPi - t0) - 0.5 * sc - 0.125 * sc * (c0 * c0 - s0 * s0);
  return 4.0 / kPi *
         (2.0 * H * (s0 - s0 * s0 * s0 / 3.0) - 0.5 * H * H * (t0 + sc) + H * H * H * s0 / 6.0 +
          4.0 / 3.0 * rest);  // (C10)
}

PlaneForce computeClosedForce(const ContactPatch& patch, const Flexibilities& flexibility, const Creepage& creepage,
                              double mu) {
  const double rise_x = creepage.xi_x / flexibility.l1;  // of stress along a strip in adhesion
  const double rise_y = creepage.xi_y / flexibility.l2;
  const double rise = std::sqrt(rise_x * rise_x + rise_y * rise_y);
  if (!(rise > 0.0)) return {0.0, 0.0};
  const double full_slip = mu * patch.normal_N;
  const double x = 2.0 / 3.0 * kPi * patch.a_m * patch.a_m * patch.b_m * rise / full_slip;  // 8/3 at full slip
  const double force = full_slip * computeClosedForm(x);
  return {-force * (rise_x / rise), -force * (rise_y / rise)};
}

}  // namespace loco
