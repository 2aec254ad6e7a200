#include "adhesion_control/pass_through_controller.hpp"

#include <cassert>

namespace adhesion {

void PassThroughController::step(double /*v_mps*/, const std::vector<AxleMeasurement>& axles, double* /*state*/,
                                 std::vector<AxleCommand>& commands) const {
  assert(commands.size() == axles.size());
  for (std::size_t i = 0; i < axles.size(); ++i) commands[i] = {axles[i].torque_reference_N_m, false};
}

}  // namespace adhesion
