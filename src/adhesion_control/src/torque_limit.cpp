#include "adhesion_control/torque_limit.hpp"

#include <algorithm>

#include "adhesion_control/slip_measurement.hpp"
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

double fadeDynamicBrake(double reference, double rim_speed_mps) {
  if (!(reference < 0.0)) return reference;
  return reference * std::clamp(rim_speed_mps / kLowestSpeed_mps, 0.0, 1.0);  // (A11)
}

}  // namespace adhesion
