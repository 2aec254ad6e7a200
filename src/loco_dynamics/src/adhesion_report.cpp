#include "loco_dynamics/adhesion_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "rail_core/digest.hpp"

namespace loco {

namespace {

// The numbers in the order of the fields: the one list that check and digest go through.
std::array<double, 16> numbersOf(const AxleAdhesion& a) {
  return {a.creep,
          a.adhesion,
          a.friction,
          a.static_friction,
          a.normal_force_N,
          a.force_N,
          a.torque_reference_N_m,
          a.torque_N_m,
          a.shoe_torque_N_m,
          a.controlled ? 1.0 : 0.0,
          a.frictional_power_W,
          a.t_gamma_N,
          a.vertical_force_N[0],
          a.vertical_force_N[1],
          a.lateral_force_N[0],
          a.lateral_force_N[1]};
}

std::array<double, 16> numbersOf(const ContactAdhesion& c) {
  return {static_cast<double>(c.axle),
          c.right ? 1.0 : 0.0,
          c.x_m,
          c.y_m,
          c.z_m,
          c.angle_rad,
          c.rolling_radius_m,
          c.a_m,
          c.b_m,
          c.normal_force_N,
          c.longitudinal_force_N,
          c.lateral_force_N,
          c.xi_x,
          c.xi_y,
          c.phi_1pm,
          c.friction};
}

template <typename Items, typename Call>
void forEachNumber(const Items& items, Call call) {
  for (const auto& item : items)
    for (const double x : numbersOf(item)) call(x);
}

}  // namespace

bool allFinite(const AdhesionReport& report) {
  bool finite = true;
  const auto check = [&finite](double x) { finite = finite && std::isfinite(x); };
  forEachNumber(report.axles, check);
  forEachNumber(report.contacts, check);
  return finite;
}

void addTo(rail::Digest& digest, const AdhesionReport& report) {
  const auto add = [&digest](double x) { digest.add(x); };
  digest.add(static_cast<std::uint64_t>(report.axles.size()));
  digest.add(static_cast<std::uint64_t>(report.contacts.size()));
  forEachNumber(report.axles, add);
  forEachNumber(report.contacts, add);
}

}  // namespace loco
