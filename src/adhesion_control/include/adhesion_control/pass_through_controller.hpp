#pragma once

#include "adhesion_control/adhesion_controller.hpp"

namespace adhesion {

/// `law: none`: no adhesion control, T = T_ref, whatever the wheels do.
class PassThroughController : public AdhesionController {
 public:
  std::size_t stateSize() const override { return 0; }
  void step(double v_mps, const std::vector<AxleMeasurement>& axles, double* state,
            std::vector<AxleCommand>& commands) const override;
};

}  // namespace adhesion
