#pragma once

#include <memory>

#include "adhesion_control/adhesion_controller.hpp"

namespace adhesion {

/// Any controller with the lag of the motors behind it: the motor's torque T_m follows the controller's torque T,
///   tau dT_m/dt = T - T_m                                                                                    (A6)
/// T is held over a micro step h, so the exact solution is
///   T_m(t + h) = T + (T_m(t) - T) exp(-h/tau),   mean over the step T + (T_m(t) - T) (1 - exp(-h/tau)) tau/h
/// The mean is what the wheelset gets: its impulse is exact for every h. tau -> 0 gives T.
/// While T_ref falls T_m follows late, and so is beyond T_ref for a time of about tau.
/// Source: chosen, the usual first model of a current-controlled motor. Not modelled: dead time, torque ripple.
///
/// State: the controller's, then T_m of every axle [N m], 0 at first.
class LaggedController : public AdhesionController {
 public:
  /// @param lag_s  tau [s], > 0
  LaggedController(std::unique_ptr<const AdhesionController> controller, double lag_s, const Setup& setup);

  std::size_t stateSize() const override { return controller_->stateSize() + axles_; }
  std::vector<double> initialState() const override;
  void step(double v_mps, const std::vector<AxleMeasurement>& axles, double* state,
            std::vector<AxleCommand>& commands) const override;

 private:
  std::unique_ptr<const AdhesionController> controller_;
  std::size_t axles_;
  double decay_;       ///< exp(-h/tau)
  double mean_decay_;  ///< (1 - exp(-h/tau)) tau/h
};

}  // namespace adhesion
