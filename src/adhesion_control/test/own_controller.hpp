#pragma once

#include "adhesion_control/adhesion_controller.hpp"
#include "adhesion_control/slip_measurement.hpp"

/// Cuts the torque of an axle to a share as soon as it slips, and gives it back after a time.
/// State: micro steps that the cut still lasts, for every axle.
class CutBackController : public adhesion::AdhesionController {
 public:
  CutBackController(double slip_limit, double share, rail::Nanoseconds duration, const adhesion::Setup& setup)
      : slip_limit_(slip_limit),
        share_(share),
        steps_(static_cast<double>(duration / setup.micro_step)),
        wheel_radius_m_(setup.wheel_radius_m),
        axles_(setup.axles()) {}

  std::size_t stateSize() const override { return axles_; }

  void step(double v_mps, const std::vector<adhesion::AxleMeasurement>& axles, double* state,
            std::vector<adhesion::AxleCommand>& commands) const override {
    for (std::size_t i = 0; i < axles_; ++i) {
      const double T_ref = axles[i].torque_reference_N_m;
      const double s = adhesion::computeSlip(axles[i].omega_radps, v_mps, wheel_radius_m_);
      const bool slips = T_ref < 0.0 ? s < -slip_limit_ : s > slip_limit_;
      if (slips) state[i] = steps_;
      const bool cut = state[i] > 0.0;
      if (cut) state[i] -= 1.0;
      commands[i] = {cut ? share_ * T_ref : T_ref, cut};
    }
  }

 private:
  double slip_limit_, share_, steps_, wheel_radius_m_;
  std::size_t axles_;
};
