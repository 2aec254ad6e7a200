#include "adhesion_control/torque_limit.hpp"

#include <algorithm>

#include "rail_core/constants.hpp"

namespace adhesion {

double computeTorqueReference(const TorqueLimit& limit, double force_reference_N) {
  const double largest_N = limit.adhesion_limit * limit.mass_kg * rail::kGravity_mps2;
  return limit.wheel_radius_m * std::clamp(force_reference_N, -largest_N, largest_N) / limit.axles;  // (A7)
}

double limitRimPower(const TorqueLimit& limit, double torque_reference_N_m, double omega_radps,
                     double rim_power_limit_W) {
  const double share_W = rim_power_limit_W / limit.axles;
  if (torque_reference_N_m * omega_radps <= share_W) return torque_reference_N_m;
  return share_W / omega_radps;  // (A8)
}

}  // namespace adhesion
