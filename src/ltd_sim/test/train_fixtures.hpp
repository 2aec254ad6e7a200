#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "loco_dynamics/local_port.hpp"
#include "loco_dynamics/loco_1d.hpp"
#include "ltd_sim/cosimulation.hpp"
#include "rail_core/constants.hpp"

/// Small vehicles, trains, tracks and drivers for the tests, without files.
namespace fixtures {

/// Reads a map's text with `read(YamlReader)`; whatever is wrong in it fails the test.
template <typename Read>
auto readMap(const std::string& text, Read read) {
  rail::Problems problems;
  const rail::Document document = rail::Document::parse(text, "test.yaml", problems);
  auto result = read(rail::YamlReader(document, problems));
  for (const std::string& line : problems.lines()) ADD_FAILURE() << line;
  return result;
}

/// What `read(YamlReader)` refuses in a map's text.
template <typename Read>
std::vector<std::string> faultsIn(const std::string& text, Read read) {
  rail::Problems problems;
  const rail::Document document = rail::Document::parse(text, "test.yaml", problems);
  read(rail::YamlReader(document, problems));
  return problems.lines();
}

/// Eqs. (5) and (6) of Wu et al. 2020.
inline rail::ResistanceCoefficients paperResistance() { return {2.943, 89.2, 0.0306, 0.122, 6116.0}; }

inline rail::Vehicle paperWagon() { return {"wagon", 120e3, 4, 15.0, 750.0, paperResistance()}; }
inline rail::Vehicle paperLoco() { return {"loco", 134e3, 6, 22.0, 5000.0, paperResistance()}; }
/// A vehicle without resistances, 10 m over couplers.
inline rail::Vehicle freeVehicle(double mass_kg) { return {"free", mass_kg, 4, 10.0, 0.0, {}}; }

/// config/couplers/draft_gear_20mm.yaml.
inline ltd::Coupler::Parameters draftGear() {
  return {0.020, {{0.030, 4.0e6}, {0.080, 30.0e6}, {0.0, 80.0e6}}, 0.45, 0.02};
}
/// Neither slack nor friction: force = k x.
inline ltd::Coupler::Parameters linearSpring(double stiffness_N_per_m, double slack_m = 0.0) {
  return {slack_m, {{0.0, stiffness_N_per_m}}, 1.0, 1.0};
}

/// The paper's locomotive: 560 kN, 4.10 MW, 8 notches.
inline ltd::TractionCharacteristic paperTraction() {
  return readMap(
      "{law: limits, notches: 8, largest_force_N: 560.0e3, force_slope_N_s_per_m: 0, power_at_rail_W: 4.10e6, "
      "rise_N_per_s: 40.0e3, fall_N_per_s: 160.0e3}",
      ltd::TractionCharacteristic::read);
}

/// Vehicles from the head, all joined by one type of coupler; those at `locos` are locomotives of notch group `lead`.
inline ltd::TrainModel makeTrain(const std::vector<rail::Vehicle>& vehicles, const std::vector<std::size_t>& locos,
                                 const ltd::Coupler::Parameters& coupler) {
  ltd::TrainModel train;
  train.name = "test train";
  train.vehicles = vehicles;
  for (const rail::Vehicle& vehicle : vehicles) train.inertial_mass_kg.push_back(vehicle.mass_kg);
  train.coupler_types.emplace_back(coupler);
  for (std::size_t i = 0; i + 1 < vehicles.size(); ++i) {
    train.coupler_type.push_back(0);
    train.coupler_distance_m.push_back(0.5 * (vehicles[i].length_m + vehicles[i + 1].length_m));
  }
  train.traction.push_back(paperTraction());
  train.dynamic_brakes.emplace_back();
  train.supplies.emplace_back();
  for (const std::size_t place : locos) train.locomotives.push_back({place, 0, 0, 0.35, "1d", "train"});
  train.notch_groups = {"lead"};
  return train;
}

/// n vehicles of equal mass without resistance, the first one a locomotive.
inline ltd::TrainModel freeTrain(std::size_t n, double mass_kg, const ltd::Coupler::Parameters& coupler) {
  return makeTrain(std::vector<rail::Vehicle>(n, freeVehicle(mass_kg)), {0}, coupler);
}

/// One locomotive of the paper and `wagons` wagons behind it.
inline ltd::TrainModel shortPaperTrain(std::size_t wagons) {
  std::vector<rail::Vehicle> vehicles(wagons + 1, paperWagon());
  vehicles.front() = paperLoco();
  return makeTrain(vehicles, {0}, draftGear());
}

/// 0 to 10 km; `grades` and `curves` as in the YAML lists.
inline rail::Track makeTrack(const std::string& grades = "{from_km: 0, grade_permille: 0}",
                             const std::string& curves = "") {
  return readMap("{name: test line, start_km: 0, end_km: 10, grades: [" + grades + "], curves: [" + curves +
                     "], speed_limits: [{from_km: 0, limit_kmph: 80}]}",
                 rail::Track::read);
}
inline rail::Track uniformGrade(double permille) {
  return makeTrack("{from_km: 0, grade_permille: " + std::to_string(permille) + "}");
}

/// Notches over time for the group `lead`, e.g. "[0, 1], [10, 2]".
inline ltd::Driver makeDriver(const std::string& notches, const std::string& over = "time") {
  const std::string text = "{over: " + over + ", notches: [" + notches + "], groups: {lead: {follows: lead}}}";
  return readMap(text,
                 [](rail::YamlReader reader) { return ltd::Driver::read(reader, {"lead"}, {8}, {8}, 2000000, {}); });
}
inline ltd::Driver idleDriver() { return makeDriver("[0, 0]"); }

/// A train on its track whose locomotives answer what the test says.
class Rig {
 public:
  Rig(ltd::TrainModel train_model, rail::Track track_model, double step_s, double location_m, double speed_mps,
      const ltd::Driver& driver_model = idleDriver())
      : train(std::move(train_model)),
        track(std::move(track_model)),
        driver(driver_model),
        H(step_s),
        dynamics(train, track, driver, air_brake, rail::wholeNanoseconds(step_s).value()),
        state(dynamics.initialState(location_m, speed_mps)),
        answers(train.locomotives.size()) {
    for (const loco::LocoTraction& answer : answers) pointers_.push_back(&answer);
  }
  Rig(const Rig&) = delete;
  Rig& operator=(const Rig&) = delete;

  /// One step with these tractions, 0 for locomotives not named. @return what became of which vehicle, if anything
  std::string step(const std::vector<double>& traction_N = {}) {
    if (state.step == 0) dynamics.updateStoredEnergies(state);
    dynamics.computeForces(state, forces);
    for (std::size_t i = 0; i < answers.size(); ++i)
      answers[i].traction_N = i < traction_N.size() ? traction_N[i] : 0.0;
    return commit(pointers_);
  }
  /// The end of a step: with `forces` as they are and these answers.
  std::string commit(const std::vector<const loco::LocoTraction*>& given) {
    std::string fault = dynamics.computeSpeeds(state, forces, given);
    if (fault.empty()) dynamics.advance(state, forces, given);
    return fault;
  }

  double momentum() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < state.v_mps.size(); ++i) sum += train.inertial_mass_kg[i] * state.v_mps[i];
    return sum;
  }

  const ltd::TrainModel train;
  const rail::Track track;
  const ltd::Driver driver;
  const ltd::AirBrake air_brake;
  const double H;
  ltd::TrainDynamics dynamics;
  ltd::TrainState state;
  ltd::TrainForces forces;
  std::vector<loco::LocoTraction> answers;  ///< step() sets the tractions in them

 private:
  std::vector<const loco::LocoTraction*> pointers_;
};

/// A scenario that needs no files: 3.0 to 3.1 km, notch 8 from the start, H = 2 ms.
inline ltd::Scenario makeScenario(const ltd::TrainModel& train, const rail::Track& track,
                                  const ltd::Driver& driver = makeDriver("[0, 8]")) {
  ltd::Scenario scenario;
  scenario.name = "test";
  scenario.locomotive_model = "1d";
  scenario.train = train;
  scenario.track = track;
  scenario.driver = driver;
  scenario.run = {3000.0, 5.0 / rail::kKmphPerMps,         3100.0, 600 * rail::kNanosecondsPerSecond,
                  0.05,   20 * rail::kNanosecondsPerSecond};
  scenario.lock = {60.0, 60.0, 1e-9};
  scenario.output.timeseries_interval = 100000000;
  scenario.output.telemetry_interval = 20000000;
  scenario.macro_step = scenario.micro_step = 2000000;
  return scenario;
}

/// Two locomotives and four wagons on level track.
inline ltd::Scenario smallScenario() {
  std::vector<rail::Vehicle> vehicles(6, paperWagon());
  vehicles[0] = vehicles[3] = paperLoco();
  return makeScenario(makeTrain(vehicles, {0, 3}, draftGear()), makeTrack());
}

/// 1D locomotives in this process, one for each of the scenario's.
struct Fleet {
  std::vector<std::unique_ptr<loco::LocoPort>> owned;
  std::vector<loco::LocoPort*> ports;

  explicit Fleet(const ltd::Scenario& scenario) {
    for (const ltd::LocoUnit& unit : scenario.train.locomotives) {
      loco::Loco1d::Parameters p;
      p.mass_kg = scenario.train.vehicles[unit.vehicle].mass_kg;
      p.inertial_mass_kg = scenario.train.inertial_mass_kg[unit.vehicle];
      p.adhesion_limit = unit.adhesion_limit;
      add(std::make_unique<loco::LocalPort>(std::make_unique<loco::Loco1d>(p)));
    }
  }
  void add(std::unique_ptr<loco::LocoPort> port) {
    owned.push_back(std::move(port));
    ports.push_back(owned.back().get());
  }
};

inline void runToEnd(ltd::Cosimulation& cosimulation) {
  cosimulation.start();
  while (!cosimulation.outcome().ended()) {
    cosimulation.begin();
    while (!cosimulation.tryCommit()) {
    }
  }
}

/// The scenario run to its end with 1D locomotives.
struct FinishedRun {
  ltd::Outcome outcome;
  ltd::TrainState state;
};
inline FinishedRun run(const ltd::Scenario& scenario, const std::vector<ltd::RunObserver*>& observers = {}) {
  Fleet fleet(scenario);
  ltd::Cosimulation cosimulation(scenario, fleet.ports, observers);
  runToEnd(cosimulation);
  return {cosimulation.outcome(), cosimulation.state()};
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// True if one of the lines has all the parts.
inline bool anyHas(const std::vector<std::string>& lines, const std::vector<std::string>& parts) {
  for (const std::string& line : lines) {
    bool all = true;
    for (const std::string& part : parts) all = all && contains(line, part);
    if (all) return true;
  }
  return false;
}

inline std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

}  // namespace fixtures
