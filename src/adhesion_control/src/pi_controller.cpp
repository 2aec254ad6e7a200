#include "adhesion_control/pi_controller.hpp"

#include <algorithm>
#include <cmath>

namespace adhesion {

double clampBetweenZeroAnd(double value, double end) {
  return std::clamp(value, std::min(0.0, end), std::max(0.0, end));
}

double PiController::step(double slip, double torque_reference_N_m, double period_s, double& integral_N_m) const {
  const double T_ref = torque_reference_N_m;
  const double e = slip - std::copysign(parameters_.slip_limit, T_ref);
  const double I = clampBetweenZeroAnd(integral_N_m, T_ref);  // T_ref may have fallen, or changed its sign
  const double K_p = parameters_.proportional_gain_N_m;
  const double K_i = parameters_.integral_gain_N_m_per_s;

  integral_N_m = clampBetweenZeroAnd(I + K_i * e * period_s, T_ref);  // (A3)
  return clampBetweenZeroAnd(K_p * e + I, T_ref);                     // (A2)
}

}  // namespace adhesion
