#include "ltd_sim/scenario.hpp"

#include "scratch_directory.hpp"
#include "train_fixtures.hpp"

namespace {

const std::string kConfig = CONFIG_DIR;
const std::string kPaper = kConfig + "/scenarios/paper_1d.yaml";

TEST(ScenarioTest, ReadsThePapersScenario) {
  const ltd::Scenario scenario = ltd::Scenario::load(kPaper, {});
  EXPECT_EQ(scenario.name, "paper_1d");
  EXPECT_EQ(scenario.locomotive_model, "1d");
  EXPECT_FALSE(scenario.rotary_inertia);
  EXPECT_EQ(scenario.train.vehicles.size(), 108u);
  EXPECT_EQ(scenario.train.locomotives.size(), 3u);
  EXPECT_EQ(scenario.macro_step, 2000000);
  EXPECT_EQ(scenario.micro_step, 1000000);
  EXPECT_EQ(scenario.run.start_location_m, 3000.0);
  EXPECT_DOUBLE_EQ(scenario.run.start_speed_mps, 5.0 / 3.6);
  EXPECT_EQ(scenario.run.end_location_m, 4500.0);
  EXPECT_EQ(scenario.run.end_time, 3600 * rail::kNanosecondsPerSecond);
  EXPECT_EQ(scenario.run.stall_speed_mps, 0.05);
  EXPECT_EQ(scenario.run.stall_time, 60 * rail::kNanosecondsPerSecond);
  EXPECT_EQ(scenario.lock.synchronisation_tolerance_mps, 1e-9);
  EXPECT_EQ(scenario.output.report_locations_m, (std::vector<double>{3150, 3200, 3300, 3400, 3450, 3500, 3600, 4500}));
  EXPECT_EQ(scenario.output.timeseries_interval, 100000000);
  EXPECT_EQ(scenario.output.telemetry_interval, 20000000);
  EXPECT_NEAR(scenario.track.at(3400.0).curvature_1pm, 1.0 / 300.0, 1e-12);
}

TEST(ScenarioTest, ReadsDistributedPowerWithTablesForTrackDriverAndTraction) {
  const ltd::Scenario scenario = ltd::Scenario::load(kConfig + "/scenarios/empties_distributed_power.yaml", {});
  EXPECT_EQ(scenario.train.vehicles.size(), 84u);
  ASSERT_EQ(scenario.train.locomotives.size(), 4u);
  EXPECT_EQ(scenario.train.locomotives[2].vehicle, 42u);
  EXPECT_EQ(scenario.train.notch_groups, (std::vector<std::string>{"lead", "remote"}));
}

TEST(ScenarioTest, OverridesReachIntoIncludedFiles) {
  const ltd::Scenario scenario = ltd::Scenario::load(kPaper, {{"train.groups.1.count", "7"},
                                                              {"train.groups.1.vehicle.mass_kg", "22000"},
                                                              {"steps.macro_step_s", "0.0005"},
                                                              {"steps.micro_step_s", "0.0005"}});
  EXPECT_EQ(scenario.train.vehicles.size(), 10u);
  EXPECT_EQ(scenario.train.vehicles.back().mass_kg, 22000.0);
  EXPECT_EQ(scenario.macro_step, 500000);
}

class ResolvedScenarioTest : public fixtures::ScratchDirectory {};

TEST_F(ResolvedScenarioTest, LoadsAgainAndRunsTheSameBits) {
  const std::vector<rail::Override> overrides = {{"run.end_time_s", "20"}, {"train.groups.1.count", "20"}};
  const ltd::Scenario scenario = ltd::Scenario::load(kPaper, overrides);
  write("resolved.yaml", scenario.document.text());
  const ltd::Scenario again = ltd::Scenario::load(path("resolved.yaml"), {});
  const fixtures::FinishedRun a = fixtures::run(scenario), b = fixtures::run(again);
  EXPECT_EQ(a.state.step, 10000u);
  EXPECT_EQ(a.outcome.exchange_digest, b.outcome.exchange_digest);
  EXPECT_EQ(a.state.s_m, b.state.s_m);
  EXPECT_EQ(again.document.text(), scenario.document.text());
}

}  // namespace
