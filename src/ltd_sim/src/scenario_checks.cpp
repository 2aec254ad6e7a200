#include "scenario_checks.hpp"

#include "loco_dynamics/loco_factory.hpp"
#include "rail_core/constants.hpp"
#include "rail_core/message_number.hpp"

namespace ltd {

void checkStep(rail::YamlReader& root, const Scenario& scenario) {
  if (scenario.train.locomotives.empty()) return;
  const double force_N = computeDesignCouplerForce(scenario.train);
  const StepBound bound = computeStepBound(scenario.train, force_N);
  if (rail::toSeconds(scenario.macro_step) < bound.largest_step_s) return;
  const rail::Vehicle& vehicle = scenario.train.vehicles[bound.vehicle];
  root.map("steps").refuse(
      "macro_step_s", "must be below " + rail::messageNumber(bound.largest_step_s, rail::Rounding::kDown) +
                          " for this train: vehicle " + std::to_string(bound.vehicle + 1) + " (" + vehicle.name + ", " +
                          rail::messageNumber(vehicle.mass_kg / rail::kKilogramsPerTonne) +
                          " t) with a coupler force of " + rail::messageNumber(force_N / 1e6) +
                          " MN, the sum of the locomotives' largest tractions");
}

void checkLocomotives(const Scenario& scenario, rail::Problems& problems) {
  std::string last_key;
  for (const LocoUnit& unit : scenario.train.locomotives)
    if (unit.key != last_key) loco::makeLocomotive(scenario.document, last_key = unit.key, problems);
}

}  // namespace ltd
