#include "adhesion_control/pi_adhesion_controller.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "adhesion_control/slip_measurement.hpp"

namespace adhesion {

PiAdhesionController::PiAdhesionController(const Parameters& parameters, const Setup& setup)
    : pi_(parameters.pi), wheel_radius_m_(setup.wheel_radius_m) {
  assert(setup.micro_step > 0 && parameters.sampling_period % setup.micro_step == 0);
  const rail::Nanoseconds period = parameters.sampling_period == 0 ? setup.micro_step : parameters.sampling_period;
  steps_per_sample_ = static_cast<double>(period / setup.micro_step);
  period_s_ = rail::toSeconds(period);
  for (std::size_t axle = 0; axle < setup.axles(); ++axle) {
    const std::size_t group = parameters.grouping == Grouping::kBogie ? setup.bogie_of_axle[axle] : axle;
    if (group >= groups_.size()) groups_.resize(group + 1);
    groups_[group].push_back(axle);
  }
  assert(std::none_of(groups_.begin(), groups_.end(), [](const Group& group) { return group.empty(); }));
}

void PiAdhesionController::step(double v_mps, const std::vector<AxleMeasurement>& axles, double* state,
                                std::vector<AxleCommand>& commands) const {
  assert(commands.size() == axles.size());
  double& steps_to_sample = state[0];
  double* const integral_N_m = state + 1;
  double* const reduction_N_m = integral_N_m + groups_.size();

  const bool sample = steps_to_sample == 0.0;
  steps_to_sample = (sample ? steps_per_sample_ : steps_to_sample) - 1.0;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    if (sample) reduction_N_m[g] = stepGroup(groups_[g], v_mps, axles, integral_N_m[g]);
    for (const std::size_t i : groups_[g]) {
      const double T_ref = axles[i].torque_reference_N_m;
      const double R = clampBetweenZeroAnd(reduction_N_m[g], T_ref);  // (A5)
      commands[i] = {T_ref - R, R != 0.0};
    }
  }
}

/// Samples one group. @return R [N m]
double PiAdhesionController::stepGroup(const Group& group, double v_mps, const std::vector<AxleMeasurement>& axles,
                                       double& integral_N_m) const {
  double T_ref = axles[group.front()].torque_reference_N_m;
  for (const std::size_t i : group) {
    if (std::abs(axles[i].torque_reference_N_m) > std::abs(T_ref)) T_ref = axles[i].torque_reference_N_m;
  }
  double s = computeSlip(axles[group.front()].omega_radps, v_mps, wheel_radius_m_);
  for (const std::size_t i : group) {
    const double s_i = computeSlip(axles[i].omega_radps, v_mps, wheel_radius_m_);
    s = T_ref < 0.0 ? std::min(s, s_i) : std::max(s, s_i);  // (A4)
  }
  return pi_.step(s, T_ref, period_s_, integral_N_m);
}

}  // namespace adhesion
