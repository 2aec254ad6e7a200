// What the co-simulation makes of the locomotives' answers: checks, order, digest.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "train_fixtures.hpp"

namespace {

using fixtures::Fleet;
using fixtures::run;
using fixtures::smallScenario;
using Kind = ltd::Outcome::Kind;

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

TEST(LocoAnswersTest, SynchronisationCheckFailsALocomotiveWhoseSpeedIsNotLtds) {
  const OddRun end = runOddly([](loco::LocoTraction& answer) { answer.speed_mps += 2e-9; });
  EXPECT_EQ(end.outcome.kind, Kind::kFailed);
  EXPECT_TRUE(fixtures::contains(end.outcome.reason, "loco_2: its speed differs from LTD's by 2e-09 m/s"));
  EXPECT_TRUE(fixtures::contains(end.outcome.reason, "(lock.synchronisation_tolerance_mps 1e-09)"))
      << end.outcome.reason;
  EXPECT_TRUE(fixtures::contains(end.outcome.reason, "in step 100 at 3.000 km")) << end.outcome.reason;
  EXPECT_EQ(end.steps, 100u);  // the faulty step is not committed
}

TEST(LocoAnswersTest, SynchronisationCheckFailsASpeedThatIsNoNumber) {
  const auto change = [](loco::LocoTraction& answer) { answer.speed_mps = std::nan(""); };
  EXPECT_TRUE(fixtures::contains(runOddly(change).outcome.reason, "loco_2: its speed differs"));
}

TEST(LocoAnswersTest, ADifferenceWithinTheToleranceIsRememberedAndTheRunGoesOn) {
  const OddRun end = runOddly([](loco::LocoTraction& answer) { answer.speed_mps -= 0.9e-9; });
  EXPECT_EQ(end.outcome.kind, Kind::kFinished) << end.outcome.reason;
  EXPECT_NEAR(end.largest_drift_mps, 0.9e-9, 1e-14);  // ulps of some m/s
}

TEST(LocoAnswersTest, LocomotiveAndLtdKeepTheSameSpeedToRoundOff) {
  EXPECT_LT(runOddly([](loco::LocoTraction&) {}).largest_drift_mps, 1e-12);
}

TEST(LocoAnswersTest, AModelsFailureIsToldInItsOwnWordsWhateverElseItAnswers) {
  const auto change = [](loco::LocoTraction& answer) {
    answer.traction_N = std::numeric_limits<double>::quiet_NaN();
    answer.failure = "bogie 1 has left the car";
  };
  const OddRun end = runOddly(change);
  EXPECT_EQ(end.outcome.kind, Kind::kFailed);
  EXPECT_EQ(end.outcome.reason, "loco_2: bogie 1 has left the car in step 100 at 2.948 km");
  EXPECT_EQ(end.steps, 100u);
}

TEST(LocoAnswersTest, TractionThatIsNoNumberIsFoundInItsStepWithTheVehiclesName) {
  const OddRun end = runOddly([](loco::LocoTraction& answer) { answer.traction_N = std::nan(""); });
  EXPECT_EQ(end.outcome.reason, "vehicle 4: its speed is not a number in step 100 at 3.000 km");
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

TEST(CosimulationDigestTest, CoversWhatTheLocomotivesAnswer) {
  const OddRun as_it_is = runOddly([](loco::LocoTraction&) {});
  const OddRun other_slip = runOddly([](loco::LocoTraction& answer) { answer.work_slip_J += 1e-9; });
  EXPECT_EQ(as_it_is.outcome.exchange_digest, run(smallScenario()).outcome.exchange_digest);
  EXPECT_NE(other_slip.outcome.exchange_digest, as_it_is.outcome.exchange_digest);
  EXPECT_EQ(other_slip.steps, as_it_is.steps);
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
