#include "ltd_sim/scenario.hpp"

#include <algorithm>

#include "loco_dynamics/loco_factory.hpp"
#include "scenario_checks.hpp"
#include "scenario_limits.hpp"
#include "scenario_names.hpp"
#include "scenario_places.hpp"

namespace ltd {

namespace {

Driver readDriver(rail::YamlReader reader, const TrainModel& train, rail::Nanoseconds macro_step,
                  const rail::Track& track, const AirBrake& air_brake, bool sand, bool ability_known) {
  std::vector<int> largest(train.notch_groups.size(), 1 << 20);
  for (const LocoUnit& unit : train.locomotives)
    largest[unit.notch_group] = std::min(largest[unit.notch_group], train.traction[unit.type].notches());
  std::vector<int> largest_brake(train.notch_groups.size(), 1 << 20);
  for (const LocoUnit& unit : train.locomotives)
    largest_brake[unit.notch_group] =
        std::min(largest_brake[unit.notch_group], train.dynamic_brakes[unit.type].notches());
  TrainAbility ability = computeAbility(train, air_brake);
  ability.sand = sand;
  ability.known = ability_known;
  return Driver::read(reader, train.notch_groups, largest, largest_brake, macro_step, track, ability);
}

bool anyHasContacts(const TrainModel& train) {
  const std::vector<LocoUnit>& units = train.locomotives;
  return std::any_of(units.begin(), units.end(), [](const LocoUnit& u) { return loco::hasContacts(u.model); });
}

/// Refuses keys that do nothing in this train; leaves them alone if the train is not known.
void refuseKeys(rail::YamlReader& root, const std::vector<std::string>& keys, bool train_known,
                const std::string& reason) {
  for (const std::string& key : keys) {
    if (train_known)
      root.refuseKey(key, reason + ": remove it, or choose another locomotive_model");
    else
      root.ignore(key);
  }
}

/// What locomotives with contacts need; in a train without any of them these keys are of no use.
/// @param train_known  the locomotives' models are known: without them nothing is asked for nor refused
/// @return the sections of the rail
std::vector<loco::RailConditions::Section> readContactOptions(rail::YamlReader& root, const Scenario& scenario,
                                                              bool train_known, bool step_known) {
  const std::vector<LocoUnit>& units = scenario.train.locomotives;
  const bool needed = anyHasContacts(scenario.train);
  const bool spatial =
      std::any_of(units.begin(), units.end(), [](const LocoUnit& u) { return loco::isSpatial(u.model); });
  if (spatial)
    loco::readSpatialOptions(root);  // the profiles themselves, with a locomotive's wheel radius: checkLocomotives
  else
    refuseKeys(root, {"profiles", "gravity_stiffness"}, train_known, "is of use to 3D locomotives only");
  if (!needed) {
    refuseKeys(root, {"adhesion", "sanded_adhesion", "rail_sections", "control"}, train_known,
               "is of no use to 1D locomotives");
    return {};
  }
  return loco::readModelOptions(root, step_known ? scenario.micro_step : 0).rail.sections;
}

}  // namespace

Scenario Scenario::load(const std::string& path, const std::vector<rail::Override>& overrides) {
  rail::Problems problems;
  Scenario scenario;
  scenario.file = path;
  checkScenarioExists(path, problems);
  problems.throwIfAny();
  scenario.document = rail::Document::load(path, overrides, problems);
  problems.throwIfAny();

  rail::YamlReader root(scenario.document, problems);
  scenario.name = root.text("name");
  if (scenario.name.find('/') != std::string::npos || scenario.name.substr(0, 1) == ".")
    root.refuse("name", "names the bag, so it must not hold '/' nor begin with '.'");
  root.text("description");
  const bool model_known = isSound(problems, [&] { scenario.locomotive_model = loco::readModel(root); });
  scenario.rotary_inertia = root.boolean("rotary_inertia");
  const bool step_known = isSound(problems, [&] { readSteps(root.map("steps"), scenario); });
  const bool run_known = isSound(problems, [&] { scenario.run = readRun(root.map("run")); });
  scenario.lock = readLock(root.map("lock"));
  const bool train_known = isSound(problems, [&] {
    scenario.train = TrainModel::read(root.map("train"), scenario.locomotive_model, scenario.rotary_inertia);
  });
  std::vector<loco::RailConditions::Section> sections;
  const bool sections_known =
      isSound(problems, [&] { sections = readContactOptions(root, scenario, model_known && train_known, step_known); });
  const bool track_known = isSound(problems, [&] { scenario.track = rail::Track::read(root.map("track")); });
  // Sand does nothing in 1D either, but a driver may be shared with models in which it does.
  const bool sand = !model_known || !train_known || !anyHasContacts(scenario.train) || root.has("sanded_adhesion");
  const bool brake_known = isSound(problems, [&] {
    if (root.has("air_brake")) scenario.air_brake = AirBrake::read(root.map("air_brake"), scenario.train);
  });
  if (scenario.train.notch_groups.empty())
    root.ignore("driver");  // whoever drives cannot be judged without anything to drive
  else
    scenario.driver = readDriver(root.map("driver"), scenario.train, scenario.macro_step, scenario.track,
                                 scenario.air_brake, sand, train_known && track_known && brake_known);
  const Bounds track{track_known, scenario.track.start_m(), scenario.track.end_m()};
  const double start_m = scenario.run.start_location_m;
  const bool on_track = run_known && track_known && start_m >= track.from_m && start_m <= track.to_m;
  const Bounds bounds{on_track, start_m, track.to_m};
  scenario.output = readOutput(root.map("output"), bounds, scenario.macro_step, step_known);
  root.finish();
  if (sections_known && track_known) checkRailSections(root, sections, scenario.track);
  if (run_known) checkEndIsAhead(root, scenario.run, track);
  if (train_known && run_known && track_known) checkPlaces(root, scenario);
  if (train_known && step_known) checkStep(root, scenario);
  if (problems.empty()) checkLocomotives(scenario, problems);
  problems.throwIfAny();
  return scenario;
}

}  // namespace ltd
