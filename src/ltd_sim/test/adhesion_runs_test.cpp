// Whole runs of locomotives with contacts: wet rail, a start on a grade, models mixed in one train.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "loco_dynamics/loco_factory.hpp"
#include "scratch_directory.hpp"
#include "train_fixtures.hpp"

namespace {

const std::string kConfig = CONFIG_DIR;

/// Calls back with every step.
class Watch : public ltd::RunObserver {
 public:
  explicit Watch(std::function<void(const ltd::StepRecord&)> call) : call_(std::move(call)) {}
  void onStep(const ltd::StepRecord& record) override { call_(record); }

 private:
  std::function<void(const ltd::StepRecord&)> call_;
};

fixtures::FinishedRun runScenario(const ltd::Scenario& scenario, std::function<void(const ltd::StepRecord&)> call) {
  rail::Problems problems;
  std::vector<std::unique_ptr<loco::LocalPort>> owned;
  std::vector<loco::LocoPort*> ports;
  for (const ltd::LocoUnit& unit : scenario.train.locomotives) {
    owned.push_back(std::make_unique<loco::LocalPort>(loco::makeLocomotive(scenario.document, unit.key, problems)));
    ports.push_back(owned.back().get());
  }
  problems.throwIfAny();
  Watch watch(std::move(call));
  ltd::Cosimulation cosimulation(scenario, ports, {&watch});
  fixtures::runToEnd(cosimulation);
  return {cosimulation.outcome(), cosimulation.state()};
}

/// Mean and standard deviation of what is added.
struct Spread {
  double n = 0.0, sum = 0.0, square = 0.0;
  void add(double x) { n += 1.0, sum += x, square += x * x; }
  double mean() const { return sum / n; }
  double deviation() const { return std::sqrt(std::max(square / n - mean() * mean(), 0.0)); }
};

TEST(WetStretchTest, EachWheelsetFeelsTheRailAtItsOwnPlaceAndControlHoldsThemAll) {
  const ltd::Scenario scenario = ltd::Scenario::load(kConfig + "/scenarios/wet_stretch.yaml", {});
  double largest_creep = 0.0;
  bool all_wet_seen = false, half_wet_seen = false;
  Spread wet_force, wet_creep, dry_force;
  const fixtures::FinishedRun run = runScenario(scenario, [&](const ltd::StepRecord& record) {
    const loco::LocoTraction& answer = *record.answers[0];
    const auto& axles = answer.adhesion.axles;
    const double front = axles.front().static_friction, rear = axles.back().static_friction;
    half_wet_seen = half_wet_seen || (front == 0.20 && rear == 0.35);
    all_wet_seen = all_wet_seen || (front == 0.20 && rear == 0.20);
    const double s_m = answer.location_m;
    if (s_m > 3300.0)
      for (const loco::AxleAdhesion& axle : axles) largest_creep = std::max(largest_creep, axle.creep);
    if (s_m > 3420.0 && s_m < 3430.0) wet_force.add(answer.traction_N), wet_creep.add(axles[2].creep);
    if (s_m > 3540.0 && s_m < 3550.0) dry_force.add(answer.traction_N);
  });
  EXPECT_EQ(run.outcome.kind, ltd::Outcome::Kind::kFinished) << run.outcome.reason;
  EXPECT_TRUE(half_wet_seen);
  EXPECT_TRUE(all_wet_seen);
  EXPECT_GT(largest_creep, 0.08);               // a wheelset that meets water slips for a moment ...
  EXPECT_LT(largest_creep, 0.15);               // ... and is caught
  EXPECT_NEAR(wet_force.mean(), 236.7e3, 2e3);  // regression: this run; 60 % of the dry rail's force
  EXPECT_LT(wet_force.deviation(), 200.0);      // falls slowly with speed, does not oscillate: 0.1 %
  EXPECT_NEAR(wet_creep.mean(), 0.07, 0.001);
  EXPECT_NEAR(dry_force.mean(), 384e3, 2e3);  // and the rail's force comes back
  EXPECT_LT(std::abs(run.state.account.residualRelative()), 1e-6);
}

TEST(RestartOnAWetGradeTest, HeldByTheAirBrakeItLeavesWithoutRollingBack) {
  const ltd::Scenario scenario = ltd::Scenario::load(kConfig + "/scenarios/restart_wet_grade.yaml", {});
  const std::size_t last = scenario.train.vehicles.size() - 1;
  double lowest_m = 0.0, first_m = 0.0, tail_m = 0.0;
  const double tail_start_m =
      ltd::TrainDynamics(scenario.train, scenario.track, scenario.driver, scenario.air_brake, scenario.macro_step)
          .initialState(3000.0, 0.0)
          .s_m[last];
  const fixtures::FinishedRun run = runScenario(scenario, [&](const ltd::StepRecord& record) {
    lowest_m = std::min(lowest_m, record.after.s_m[0] - 3000.0);
    tail_m = std::min(tail_m, record.after.s_m[last] - tail_start_m);
    if (record.after.step == 5000) first_m = record.after.s_m[last] - tail_start_m;
  });
  EXPECT_EQ(run.outcome.kind, ltd::Outcome::Kind::kFinished) << run.outcome.reason;
  EXPECT_NEAR(first_m, 0.0, 1e-9);  // stands for 10 s under full service, and does not creep
  EXPECT_NEAR(tail_m, 0.0, 1e-9);   // nor rolls back when it is released
  EXPECT_LT(lowest_m, 0.0);         // the locomotives' braked wheels creep on the rail, 0.4 mm/s ...
  EXPECT_GT(lowest_m, -0.010);      // ... in the coupler's slack
  EXPECT_LT(std::abs(run.state.account.residualRelative()), 1e-6);
}

TEST(RestartOnAWetGradeTest, SandGivesTheForceThatTheWetRailHasNot) {
  double force_N[2];
  for (int sand = 0; sand < 2; ++sand) {
    const ltd::Scenario scenario =
        ltd::Scenario::load(kConfig + "/scenarios/restart_wet_grade.yaml",
                            {{"driver.sanding", sand == 0 ? "[[10, 0]]" : "[[10, 1]]"}, {"run.end_time_s", "41"}});
    Spread force;
    runScenario(scenario, [&](const ltd::StepRecord& record) {
      if (record.before.step <= 20000) return;
      force.add(record.answers[0]->traction_N);
      for (const loco::AxleAdhesion& axle : record.answers[0]->adhesion.axles) {
        ASSERT_LT(axle.creep, 0.08);  // control holds it
        ASSERT_LT(axle.adhesion, axle.friction);
      }
    });
    force_N[sand] = force.mean();
  }
  EXPECT_LT(force_N[0], 0.20 * 134e3 * rail::kGravity_mps2);  // friction of the wet rail
  EXPECT_GT(force_N[1], 1.4 * force_N[0]);
}

class MixedModelsTest : public fixtures::ScratchDirectory {
 protected:
  MixedModelsTest() {
    std::filesystem::copy(kConfig, path("config"), std::filesystem::copy_options::recursive);
    replace("config/scenarios/paper_2d.yaml", "../trains/paper.yaml", "../trains/paper_mixed.yaml");
  }
  ltd::Scenario load(const std::vector<rail::Override>& overrides = {}) const {
    return ltd::Scenario::load(path("config/scenarios/paper_2d.yaml"), overrides);
  }
};

TEST_F(MixedModelsTest, EachLocomotiveOfATrainHasTheModelOfItsGroup) {
  const ltd::Scenario scenario = load({{"run.end_location_km", "3.16"}});
  ASSERT_EQ(scenario.train.locomotives.size(), 3u);
  EXPECT_EQ(scenario.train.locomotives[0].model, "2d");
  EXPECT_EQ(scenario.train.locomotives[1].model, "1d");
  double force_N[2] = {0.0, 0.0};
  std::size_t axles[3] = {9, 9, 9};
  const fixtures::FinishedRun run = runScenario(scenario, [&](const ltd::StepRecord& record) {
    for (std::size_t i = 0; i < 3; ++i) axles[i] = record.answers[i]->adhesion.axles.size();
    if (record.after.s_m[0] < 3150.0)
      force_N[0] = record.answers[0]->traction_N, force_N[1] = record.answers[1]->traction_N;
  });
  EXPECT_EQ(run.outcome.kind, ltd::Outcome::Kind::kFinished) << run.outcome.reason;
  EXPECT_EQ(axles[0], 6u);
  EXPECT_EQ(axles[1], 0u);
  EXPECT_EQ(axles[2], 0u);
  EXPECT_NEAR(force_N[1], 460.089e3, 1.0);
  EXPECT_NEAR(force_N[0], 399e3, 2e3);  // a little faster than with three in 2D, so a little less than 399.7
}

TEST_F(MixedModelsTest, AGroupMayNotNameAModelThatDoesNotExistNorAWagonAny) {
  replace("config/trains/paper_mixed.yaml", "locomotive_model: 1d", "locomotive_model: 4d");
  replace("config/trains/paper_mixed.yaml", "{kind: wagon,", "{kind: wagon, locomotive_model: 1d,");
  try {
    load();
    FAIL() << "accepted";
  } catch (const rail::ConfigError& error) {
    ASSERT_EQ(error.lines().size(), 2u) << error.what();
    EXPECT_NE(error.lines()[0].find("groups.1.locomotive_model = 4d: must be one of"), std::string::npos)
        << error.what();
    EXPECT_NE(error.lines()[1].find("groups.2.locomotive_model = 1d: unknown key"), std::string::npos) << error.what();
  }
}

}  // namespace
