#include "ltd_sim/scenario.hpp"

#include <algorithm>

#include "loco_dynamics/loco_factory.hpp"
#include "rail_core/constants.hpp"
#include "rail_core/message_number.hpp"
#include "scenario_names.hpp"
#include "scenario_places.hpp"

namespace ltd {

namespace {

rail::Nanoseconds readTime(rail::YamlReader& reader, const std::string& key, const rail::Range& range) {
  const std::optional<rail::Nanoseconds> t = rail::wholeNanoseconds(reader.number(key, range));
  if (t && *t > 0) return *t;
  reader.refuse(key, "must be a whole number of nanoseconds, at least one");
  return 1;
}

/// Reads and says whether nothing was wrong: only what is known may be compared with something else, or a fault would
/// accuse what is sound beside it.
template <typename Read>
bool isSound(const rail::Problems& problems, Read read) {
  const std::size_t before = problems.count();
  read();
  return problems.count() == before;
}

RunLimits readRun(rail::YamlReader reader) {
  RunLimits run;
  run.start_location_m = reader.number("start_location_km", rail::anyNumber()) * rail::kMetresPerKilometre;
  run.end_location_m = reader.number("end_location_km", rail::anyNumber()) * rail::kMetresPerKilometre;
  run.start_speed_mps = reader.number("start_speed_kmph", rail::between(0.0, 400.0)) / rail::kKmphPerMps;
  run.end_time = readTime(reader, "end_time_s", rail::aboveUpTo(0.0, 1e6));
  rail::YamlReader stall = reader.map("stall");
  run.stall_speed_mps = stall.number("speed_below_mps", rail::notNegative());
  run.stall_time = readTime(stall, "for_s", rail::aboveUpTo(0.0, 1e5));
  stall.finish();
  if (reader.has("end_at_standstill_s"))
    run.standstill_time = readTime(reader, "end_at_standstill_s", rail::aboveUpTo(0.0, 1e5));
  if (reader.has("runaway_above_limit_kmph"))
    run.runaway_margin_mps = reader.number("runaway_above_limit_kmph", rail::between(0.0, 400.0)) / rail::kKmphPerMps;
  reader.finish();
  return run;
}

void readSteps(rail::YamlReader reader, Scenario& scenario) {
  const bool known = isSound(reader.problems(), [&] {
    scenario.macro_step = readTime(reader, "macro_step_s", rail::aboveUpTo(0.0, 1.0));
    scenario.micro_step = readTime(reader, "micro_step_s", rail::aboveUpTo(0.0, 1.0));
  });
  if (known && scenario.macro_step % scenario.micro_step != 0)
    reader.refuse("macro_step_s", "must be a whole multiple of micro_step_s = " +
                                      rail::exactNumber(rail::toSeconds(scenario.micro_step)));
  reader.finish();
}

LockLimits readLock(rail::YamlReader reader) {
  LockLimits lock;
  lock.join_deadline_s = reader.number("join_deadline_s", rail::positive());
  lock.answer_deadline_s = reader.number("answer_deadline_s", rail::positive());
  lock.synchronisation_tolerance_mps = reader.number("synchronisation_tolerance_mps", rail::positive());
  reader.finish();
  return lock;
}

rail::Nanoseconds readInterval(rail::YamlReader& reader, const std::string& key, rail::Nanoseconds macro_step,
                               bool step_known) {
  rail::Nanoseconds interval = 0;
  const bool known =
      isSound(reader.problems(), [&] { interval = readTime(reader, key, rail::positive()); }) && step_known;
  if (known && interval % macro_step != 0) reader.refuse(key, "must be a whole multiple of steps.macro_step_s");
  return interval;
}

OutputOptions readOutput(rail::YamlReader reader, const Bounds& bounds, rail::Nanoseconds macro_step, bool step_known) {
  OutputOptions output;
  output.report_locations_m = readLocations(reader, "report_locations_km", bounds);
  output.section_boundaries_m = readLocations(reader, "section_boundaries_km", bounds);
  output.timeseries_interval = readInterval(reader, "timeseries_interval_s", macro_step, step_known);
  output.telemetry_interval = readInterval(reader, "telemetry_interval_s", macro_step, step_known);
  output.record_exchange = reader.boolean("record_exchange");
  reader.finish();
  return output;
}

Driver readDriver(rail::YamlReader reader, const TrainModel& train, rail::Nanoseconds macro_step,
                  const rail::Track& track, const AirBrake& air_brake, bool sand) {
  std::vector<int> largest(train.notch_groups.size(), 1 << 20);
  for (const LocoUnit& unit : train.locomotives)
    largest[unit.notch_group] = std::min(largest[unit.notch_group], train.traction[unit.type].notches());
  std::vector<int> largest_brake(train.notch_groups.size(), 1 << 20);
  for (const LocoUnit& unit : train.locomotives)
    largest_brake[unit.notch_group] =
        std::min(largest_brake[unit.notch_group], train.dynamic_brakes[unit.type].notches());
  TrainAbility ability = computeAbility(train, air_brake);
  ability.sand = sand;
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

/// The couplers' friction and stiffness bound the macro step; see computeStepBound.
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

/// What each locomotive's own model refuses: the micro step above all, which its stiffest motion bounds.
void checkLocomotives(const Scenario& scenario, rail::Problems& problems) {
  std::string last_key;
  for (const LocoUnit& unit : scenario.train.locomotives)
    if (unit.key != last_key) loco::makeLocomotive(scenario.document, last_key = unit.key, problems);
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
  if (root.has("air_brake")) scenario.air_brake = AirBrake::read(root.map("air_brake"), scenario.train);
  if (scenario.train.notch_groups.empty())
    root.ignore("driver");  // whoever drives cannot be judged without anything to drive
  else
    scenario.driver =
        readDriver(root.map("driver"), scenario.train, scenario.macro_step, scenario.track, scenario.air_brake, sand);
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
