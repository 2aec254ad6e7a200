#include "ltd_sim/loco_energy.hpp"

namespace ltd {

LocoEnergy computeStepEnergy(const loco::LocoTraction& answer, double distance_m, bool coasts) {
  const double work_rail_J = answer.traction_N * distance_m;  // Eq. (4)
  const bool brakes = work_rail_J < 0.0 && !coasts;
  const RimWork at_rim(answer.work_rim_J);
  LocoEnergy step;
  step.rail = brakes ? 0.0 : work_rail_J;
  step.brake_rail = brakes ? -work_rail_J : 0.0;
  step.rim = at_rim.motored_J;
  step.recovered_rim = at_rim.recovered_J;
  step.slip = answer.work_slip_J;
  step.shoes = answer.work_shoes_J;
  return step;
}

LocoEnergy& operator+=(LocoEnergy& sum, const LocoEnergy& step) {
  sum.rail += step.rail;
  sum.rim += step.rim;
  sum.slip += step.slip;
  sum.brake_rail += step.brake_rail;
  sum.recovered_rim += step.recovered_rim;
  sum.shoes += step.shoes;
  return sum;
}

}  // namespace ltd
