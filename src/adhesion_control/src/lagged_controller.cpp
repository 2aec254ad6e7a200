#include "adhesion_control/lagged_controller.hpp"

#include <cassert>
#include <cmath>
#include <utility>

namespace adhesion {

LaggedController::LaggedController(std::unique_ptr<const AdhesionController> controller, double lag_s,
                                   const Setup& setup)
    : controller_(std::move(controller)), axles_(setup.axles()) {
  assert(lag_s > 0.0 && setup.micro_step > 0);
  const double h_over_tau = rail::toSeconds(setup.micro_step) / lag_s;
  decay_ = std::exp(-h_over_tau);
  mean_decay_ = -std::expm1(-h_over_tau) / h_over_tau;
}

std::vector<double> LaggedController::initialState() const {
  std::vector<double> state = controller_->initialState();
  state.resize(stateSize(), 0.0);
  return state;
}

void LaggedController::step(double v_mps, const std::vector<AxleMeasurement>& axles, double* state,
                            std::vector<AxleCommand>& commands) const {
  controller_->step(v_mps, axles, state, commands);
  double* const motor_torque_N_m = state + controller_->stateSize();
  for (std::size_t i = 0; i < axles_; ++i) {
    const double T = commands[i].torque_N_m;
    const double difference = motor_torque_N_m[i] - T;
    motor_torque_N_m[i] = T + difference * decay_;
    commands[i].torque_N_m = T + difference * mean_decay_;  // (A6)
  }
}

}  // namespace adhesion
