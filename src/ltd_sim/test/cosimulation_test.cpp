#include "ltd_sim/cosimulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "train_fixtures.hpp"

namespace {

using fixtures::Fleet;
using fixtures::run;
using Kind = ltd::Outcome::Kind;

constexpr rail::Nanoseconds kSecond = rail::kNanosecondsPerSecond;

/// Two locomotives and four wagons on level track.
ltd::Scenario smallScenario() {
  std::vector<rail::Vehicle> vehicles(6, fixtures::paperWagon());
  vehicles[0] = vehicles[3] = fixtures::paperLoco();
  return fixtures::makeScenario(fixtures::makeTrain(vehicles, {0, 3}, fixtures::draftGear()), fixtures::makeTrack());
}

TEST(CosimulationTest, FinishesInTheStepInWhichTheLeadingLocomotiveReachesTheEnd) {
  const ltd::Scenario scenario = smallScenario();
  const fixtures::FinishedRun end = run(scenario);
  EXPECT_EQ(end.outcome.kind, Kind::kFinished);
  EXPECT_EQ(end.outcome.reason, "reached 3.100 km");
  EXPECT_EQ(end.outcome.exitStatus(), 0);
  EXPECT_GE(end.state.s_m[0], 3100.0);
  EXPECT_LT(end.state.s_m[0] - 0.002 * end.state.v_mps[0], 3100.0);
}

TEST(CosimulationTest, FinishesAtTheEndTimeExactly) {
  ltd::Scenario scenario = smallScenario();
  scenario.run.end_time = 5 * kSecond / 2;
  const fixtures::FinishedRun end = run(scenario);
  EXPECT_EQ(end.outcome.kind, Kind::kFinished);
  EXPECT_EQ(end.outcome.reason, "reached the end time 2.5 s");
  EXPECT_EQ(end.state.step, 1250u);
}

TEST(CosimulationTest, FailsWhenTheFirstVehicleLeavesTheTrack) {
  ltd::Scenario scenario = smallScenario();
  for (ltd::LocoUnit& unit : scenario.train.locomotives) unit.vehicle += 1;  // a wagon is pushed in front
  std::swap(scenario.train.vehicles[0], scenario.train.vehicles[5]);
  scenario.run.start_location_m = 9900.0;
  scenario.run.end_location_m = 9999.0;
  const fixtures::FinishedRun end = run(scenario);
  EXPECT_EQ(end.outcome.kind, Kind::kFailed);
  EXPECT_EQ(end.outcome.reason, "vehicle 1 left the track at 10.000 km");
  EXPECT_EQ(end.outcome.exitStatus(), 1);
}

TEST(CosimulationTest, FailsWhenTheLastVehicleRollsBackOffTheTrack) {
  ltd::Scenario scenario = smallScenario();
  scenario.track = fixtures::uniformGrade(20.0);
  scenario.driver = fixtures::idleDriver();
  scenario.run.start_location_m = 150.0;
  const fixtures::FinishedRun end = run(scenario);
  EXPECT_EQ(end.outcome.kind, Kind::kFailed);
  EXPECT_TRUE(fixtures::contains(end.outcome.reason, "vehicle 6 left the track")) << end.outcome.reason;
}

TEST(CosimulationTest, StallsWhenTractionDoesNotKeepTheTrainMoving) {
  // 2 kN/t of resistance on 748 t is more than the locomotives' 920 kN.
  ltd::Scenario scenario = smallScenario();
  for (rail::Vehicle& vehicle : scenario.train.vehicles) vehicle.resistance.per_mass_N_per_t = 2000.0;
  const fixtures::FinishedRun end = run(scenario);
  EXPECT_EQ(end.outcome.kind, Kind::kFailed);
  EXPECT_TRUE(fixtures::contains(end.outcome.reason, "stalled at 3.0")) << end.outcome.reason;
  // From 1.39 m/s at about 2 m/s^2 it stands within 0.7 s; from then on stall.for_s = 20 s.
  EXPECT_NEAR(static_cast<double>(end.state.step) * 0.002, 20.7, 0.3);
}

TEST(CosimulationTest, StandingWithoutTractionIsNoStall) {
  ltd::Scenario scenario = smallScenario();
  scenario.driver = fixtures::idleDriver();
  scenario.run.start_speed_mps = 0.0;
  scenario.run.end_time = 60 * kSecond;
  EXPECT_EQ(run(scenario).outcome.kind, Kind::kFinished);
}

TEST(CosimulationTest, ATrainMayStandUnderTractionForLessThanTheStallTimeTwiceAndStartAgain) {
  // 30 kN a vehicle: notch 1 (2 x 70 kN) does not move it, notch 8 does. It stands under traction for 15 s and 15 s.
  ltd::Scenario scenario = smallScenario();
  for (rail::Vehicle& vehicle : scenario.train.vehicles) vehicle.resistance.per_mass_N_per_t = 30e6 / vehicle.mass_kg;
  scenario.run.start_speed_mps = 0.0;
  scenario.driver = fixtures::makeDriver("[0, 1], [15, 0], [16, 1], [31, 8]");
  EXPECT_EQ(run(scenario).outcome.reason, "reached 3.100 km");
  scenario.driver = fixtures::makeDriver("[0, 1], [31, 8]");
  EXPECT_TRUE(fixtures::contains(run(scenario).outcome.reason, "stalled"));
}

/// A locomotive in this process that is not what it should be.
class OddPort : public loco::LocoPort {
 public:
  using Change = std::function<void(loco::LocoTraction&)>;
  OddPort(loco::LocoPort& inner, std::uint64_t from_step, Change change)
      : inner_(inner), from_step_(from_step), change_(std::move(change)) {}
  void send(const loco::LocoForce& force, const std::vector<double>& state) override {
    inner_.send(force, state);
    answer_ = *inner_.answer();
    if (force.step >= from_step_) change_(answer_);
  }
  const loco::LocoTraction* answer() override { return &answer_; }

 private:
  loco::LocoPort& inner_;
  std::uint64_t from_step_;
  Change change_;
  loco::LocoTraction answer_;
};

/// A run in which the second locomotive answers oddly from step 100 on.
struct OddRun {
  ltd::Outcome outcome;
  std::uint64_t steps;
  double largest_drift_mps;
};
OddRun runOddly(const OddPort::Change& change) {
  const ltd::Scenario scenario = smallScenario();
  Fleet fleet(scenario);
  OddPort odd(*fleet.ports[1], 100, change);
  ltd::Cosimulation cosimulation(scenario, {fleet.ports[0], &odd}, {});
  fixtures::runToEnd(cosimulation);
  return {cosimulation.outcome(), cosimulation.state().step, cosimulation.largestDrift()};
}

TEST(CosimulationTest, SynchronisationCheckFailsALocomotiveWhoseSpeedIsNotLtds) {
  const OddRun end = runOddly([](loco::LocoTraction& answer) { answer.speed_mps += 2e-9; });
  EXPECT_EQ(end.outcome.kind, Kind::kFailed);
  EXPECT_TRUE(fixtures::contains(end.outcome.reason, "loco_2: its speed differs from LTD's by 2e-09 m/s"));
  EXPECT_TRUE(fixtures::contains(end.outcome.reason, "synchronisation_tolerance 1e-09")) << end.outcome.reason;
  EXPECT_TRUE(fixtures::contains(end.outcome.reason, "in step 100 at 3.000 km")) << end.outcome.reason;
  EXPECT_EQ(end.steps, 100u);  // the faulty step is not committed
}

TEST(CosimulationTest, SynchronisationCheckFailsASpeedThatIsNoNumber) {
  const auto change = [](loco::LocoTraction& answer) { answer.speed_mps = std::nan(""); };
  EXPECT_TRUE(fixtures::contains(runOddly(change).outcome.reason, "loco_2: its speed differs"));
}

TEST(CosimulationTest, ADifferenceWithinTheToleranceIsRememberedAndTheRunGoesOn) {
  const OddRun end = runOddly([](loco::LocoTraction& answer) { answer.speed_mps -= 0.9e-9; });
  EXPECT_EQ(end.outcome.kind, Kind::kFinished) << end.outcome.reason;
  EXPECT_NEAR(end.largest_drift_mps, 0.9e-9, 1e-14);  // ulps of some m/s
}

TEST(CosimulationTest, LocomotiveAndLtdKeepTheSameSpeedToRoundOff) {
  EXPECT_LT(runOddly([](loco::LocoTraction&) {}).largest_drift_mps, 1e-12);
}

TEST(CosimulationTest, AModelsFailureIsToldInItsOwnWordsWhateverElseItAnswers) {
  const auto change = [](loco::LocoTraction& answer) {
    answer.traction_N = std::numeric_limits<double>::quiet_NaN();
    answer.failure = "bogie 1 has left the car";
  };
  const OddRun end = runOddly(change);
  EXPECT_EQ(end.outcome.kind, Kind::kFailed);
  EXPECT_EQ(end.outcome.reason, "loco_2: bogie 1 has left the car in step 100 at 3.000 km");
  EXPECT_EQ(end.steps, 100u);
}

TEST(CosimulationTest, TractionThatIsNoNumberIsFoundInItsStepWithTheVehiclesName) {
  const OddRun end = runOddly([](loco::LocoTraction& answer) { answer.traction_N = std::nan(""); });
  EXPECT_EQ(end.outcome.reason, "vehicle 4: its speed is not a number in step 100 at 3.000 km");
}

/// Writes down what it is told.
class Witness : public ltd::RunObserver {
 public:
  Witness(std::string name, std::vector<std::string>& log) : name_(std::move(name)), log_(log) {}
  void onStart(const ltd::TrainState& state) override { note("start", state.step); }
  void onStep(const ltd::StepRecord& record) override {
    EXPECT_EQ(record.after.step, record.before.step + 1);
    EXPECT_EQ(record.loco_forces.size(), 2u);
    EXPECT_EQ(record.answers[1]->step, record.before.step);
    note("step", record.before.step);
  }
  void onEnd(const ltd::TrainState& state, const ltd::Outcome& outcome) override {
    note("end:" + ltd::toString(outcome.kind), state.step);
  }

 private:
  void note(const std::string& what, std::uint64_t step) { log_.push_back(name_ + what + std::to_string(step)); }
  std::string name_;
  std::vector<std::string>& log_;
};

TEST(CosimulationTest, ObserversAreToldOfStartStepsAndEndInOrder) {
  ltd::Scenario scenario = smallScenario();
  scenario.run.end_time = 2 * scenario.macro_step;
  std::vector<std::string> log;
  Witness a("a:", log), b("b:", log);
  run(scenario, {&a, &b});
  EXPECT_EQ(log, (std::vector<std::string>{"a:start0", "b:start0", "a:step0", "b:step0", "a:step1", "b:step1",
                                           "a:end:finished2", "b:end:finished2"}));
}

TEST(CosimulationTest, EndedFromOutsideItGivesUpTheStepUnderWayAndEndsOnce) {
  const ltd::Scenario scenario = smallScenario();
  Fleet fleet(scenario);
  std::vector<std::string> log;
  Witness witness("", log);
  ltd::Cosimulation cosimulation(scenario, fleet.ports, {&witness});
  cosimulation.start();
  cosimulation.begin();
  ASSERT_TRUE(cosimulation.tryCommit());
  cosimulation.begin();
  cosimulation.end(Kind::kStopped, "enough");
  cosimulation.end(Kind::kFailed, "too late");
  EXPECT_FALSE(cosimulation.tryCommit());
  EXPECT_EQ(cosimulation.outcome().kind, Kind::kStopped);
  EXPECT_EQ(cosimulation.outcome().reason, "enough");
  EXPECT_EQ(cosimulation.outcome().exitStatus(), 3);
  EXPECT_EQ(log, (std::vector<std::string>{"start0", "step0", "end:stopped1"}));
}

TEST(CosimulationDigestTest, TheSameRunHasTheSameDigest) {
  const ltd::Scenario scenario = smallScenario();
  const fixtures::FinishedRun a = run(scenario), b = run(scenario);
  EXPECT_EQ(a.outcome.exchange_digest, b.outcome.exchange_digest);
  EXPECT_NE(a.outcome.exchange_digest, 0u);
  EXPECT_EQ(a.state.s_m, b.state.s_m);
  EXPECT_EQ(a.state.v_mps, b.state.v_mps);
}

TEST(CosimulationDigestTest, ChangesIfAnyInputChangesInItsLastDigit) {
  const ltd::Scenario scenario = smallScenario();
  const std::uint64_t digest = run(scenario).outcome.exchange_digest;
  ltd::Scenario speed = scenario, place = scenario, grip = scenario, wagon = scenario, resistance = scenario;
  // What is sent as it stands: the last binary digit.
  speed.run.start_speed_mps = std::nextafter(scenario.run.start_speed_mps, 9.0);
  place.run.start_location_m = std::nextafter(scenario.run.start_location_m, 9e9);
  grip.train.locomotives[1].adhesion_limit = std::nextafter(0.35, 1.0);
  // What acts through the speeds, where an ulp of it would be rounded off: the last digit as it is written.
  wagon.train.inertial_mass_kg[5] += 1.0;
  resistance.train.vehicles[4].resistance.per_mass_N_per_t += 0.001;
  for (const ltd::Scenario* changed : {&speed, &place, &grip, &wagon, &resistance})
    EXPECT_NE(run(*changed).outcome.exchange_digest, digest);
}

/// Has its answer only when it is asked for it once more.
class LatePort : public loco::LocoPort {
 public:
  explicit LatePort(loco::LocoPort& inner) : inner_(inner) {}
  void send(const loco::LocoForce& force, const std::vector<double>& state) override {
    polls_ = 0;
    inner_.send(force, state);
  }
  const loco::LocoTraction* answer() override { return ++polls_ > 1 ? inner_.answer() : nullptr; }

 private:
  loco::LocoPort& inner_;
  int polls_ = 0;
};

TEST(CosimulationDigestTest, DoesNotDependOnWhoAnswersFirst) {
  const ltd::Scenario scenario = smallScenario();
  const std::uint64_t digest = run(scenario).outcome.exchange_digest;
  for (const std::size_t late : {0u, 1u}) {
    Fleet fleet(scenario);
    LatePort late_port(*fleet.ports[late]);
    fleet.ports[late] = &late_port;
    ltd::Cosimulation cosimulation(scenario, fleet.ports, {});
    cosimulation.begin();
    EXPECT_FALSE(cosimulation.tryCommit());
    EXPECT_TRUE(cosimulation.stepUnderWay());
    EXPECT_EQ(cosimulation.state().step, 0u);
    EXPECT_TRUE(cosimulation.tryCommit());
    EXPECT_FALSE(cosimulation.stepUnderWay());
    EXPECT_EQ(cosimulation.state().step, 1u);
    fixtures::runToEnd(cosimulation);
    EXPECT_EQ(cosimulation.outcome().exchange_digest, digest);
  }
}

}  // namespace
