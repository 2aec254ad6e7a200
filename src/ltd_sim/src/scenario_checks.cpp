#include "scenario_checks.hpp"

#include "rail_core/constants.hpp"
#include "scenario_words.hpp"

namespace ltd {

void checkRailSections(rail::YamlReader& root, const std::vector<loco::RailConditions::Section>& sections,
                       const rail::Track& track) {
  for (std::size_t i = 0; i < sections.size(); ++i) {
    rail::YamlReader section = root.maps("rail_sections")[i];
    const std::string rule = "is beyond the track, " + format(track.start_m() / rail::kMetresPerKilometre) + " to " +
                             format(track.end_m() / rail::kMetresPerKilometre) + " km";
    if (sections[i].from_m < track.start_m()) section.refuse("from_km", rule);
    if (sections[i].to_m > track.end_m()) section.refuse("to_km", rule);
  }
}

void checkPlaces(rail::YamlReader& root, const Scenario& scenario) {
  if (scenario.train.locomotives.empty()) return;
  double front_m = scenario.run.start_location_m, rear_m = scenario.run.start_location_m;
  const std::size_t lead = scenario.train.locomotives.front().vehicle;
  for (std::size_t i = 0; i < lead; ++i) front_m += scenario.train.coupler_distance_m[i];
  for (std::size_t i = lead; i < scenario.train.coupler_distance_m.size(); ++i)
    rear_m -= scenario.train.coupler_distance_m[i];
  rail::YamlReader run = root.map("run");
  const std::string track = " (track " + format(scenario.track.start_m() / rail::kMetresPerKilometre) + " to " +
                            format(scenario.track.end_m() / rail::kMetresPerKilometre) + " km)";
  if (rear_m < scenario.track.start_m() || front_m > scenario.track.end_m())
    run.refuse("start_location_km", "the train would stand from " + format(rear_m / rail::kMetresPerKilometre) +
                                        " to " + format(front_m / rail::kMetresPerKilometre) + " km, beyond the track" +
                                        track);
  const double ahead_m = front_m - scenario.run.start_location_m;  // of vehicles before the leading locomotive
  if (scenario.run.end_location_m + ahead_m > scenario.track.end_m())
    run.refuse("end_location_km", "the head of the train would be beyond the track" + track);
}

void checkStep(rail::YamlReader& root, const Scenario& scenario) {
  if (scenario.train.locomotives.empty()) return;
  const double force_N = computeDesignCouplerForce(scenario.train);
  const StepBound bound = computeStepBound(scenario.train, force_N);
  if (rail::toSeconds(scenario.macro_step) < bound.largest_step_s) return;
  const rail::Vehicle& vehicle = scenario.train.vehicles[bound.vehicle];
  root.map("steps").refuse("macro_step_s",
                           "must be below " + format(bound.largest_step_s) + " for this train: vehicle " +
                               std::to_string(bound.vehicle + 1) + " (" + vehicle.name + ", " +
                               format(vehicle.mass_kg / rail::kKilogramsPerTonne) + " t) with a coupler force of " +
                               format(force_N / 1e6) + " MN, the sum of the locomotives' largest tractions");
}

void checkLocomotives(const Scenario& scenario, rail::Problems& problems) {
  std::string last_key;
  for (const LocoUnit& unit : scenario.train.locomotives)
    if (unit.key != last_key) loco::makeLocomotive(scenario.document, last_key = unit.key, problems);
}

}  // namespace ltd
