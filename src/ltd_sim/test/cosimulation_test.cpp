#include "ltd_sim/cosimulation.hpp"

#include <gtest/gtest.h>

#include "train_fixtures.hpp"

namespace {

using fixtures::Fleet;
using fixtures::run;
using fixtures::smallScenario;
using Kind = ltd::Outcome::Kind;

constexpr rail::Nanoseconds kSecond = rail::kNanosecondsPerSecond;

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

/// A locomotive that can fall silent.
class FallingSilent : public loco::LocoPort {
 public:
  explicit FallingSilent(loco::LocoPort& port) : port_(port) {}
  void send(const loco::LocoForce& force, const std::vector<double>& state) override { port_.send(force, state); }
  const loco::LocoTraction* answer() override { return silent ? nullptr : port_.answer(); }
  bool silent = false;

 private:
  loco::LocoPort& port_;
};

struct HoldsSeen : ltd::RunObserver {
  void onHold(const ltd::StepRecord& record) override {
    steps.push_back(record.after.step);
    for (const loco::LocoTraction* answer : record.answers) ASSERT_NE(answer, nullptr);
  }
  std::vector<std::uint64_t> steps;
};

TEST(CosimulationTest, AHeldRunIsShownAfterAWholeStepAndNotAfterOneThatWasGivenUp) {
  const ltd::Scenario scenario = smallScenario();
  Fleet fleet(scenario);
  ASSERT_EQ(fleet.ports.size(), 2u);
  FallingSilent second(*fleet.ports[1]);
  HoldsSeen seen;
  ltd::Cosimulation run(scenario, {fleet.ports[0], &second}, {&seen});
  run.start();
  run.hold();
  for (int i = 0; i < 3; ++i) {
    run.begin();
    ASSERT_TRUE(run.tryCommit());
  }
  run.hold();
  EXPECT_EQ(seen.steps, std::vector<std::uint64_t>{3});
  second.silent = true;
  run.begin();
  EXPECT_FALSE(run.tryCommit());
  run.end(Kind::kFailed, "loco_2 has not answered");
  run.hold();
  EXPECT_EQ(seen.steps.size(), 1u);
}

}  // namespace
