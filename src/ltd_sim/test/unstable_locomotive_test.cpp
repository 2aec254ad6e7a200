// A locomotive of bodies whose micro step is too long: refused when the scenario is read, and if it runs all the same,
// ended.

#include <algorithm>

#include "loco_dynamics/loco_2d.hpp"
#include "loco_dynamics/loco_factory.hpp"
#include "ltd_sim/run_outputs.hpp"
#include "scratch_directory.hpp"
#include "train_fixtures.hpp"

namespace {

const std::string kConfig = CONFIG_DIR;
const std::string kScenario = kConfig + "/scenarios/paper_2d.yaml";

std::vector<std::string> faults(const std::vector<rail::Override>& overrides) {
  try {
    ltd::Scenario::load(kScenario, overrides);
  } catch (const rail::ConfigError& error) {
    return error.lines();
  }
  return {};
}

std::vector<rail::Override> withSteps(const std::string& macro_s, const std::string& micro_s) {
  return {{"steps.macro_step_s", macro_s},
          {"steps.micro_step_s", micro_s},
          {"output.timeseries_interval_s", "0.3"},
          {"output.telemetry_interval_s", "0.03"}};
}

using UnstableLocomotiveTest = fixtures::ScratchDirectory;

TEST_F(UnstableLocomotiveTest, AMicroStepThatItsWheelsDoNotBearIsRefusedWithTheModeAndTheLargest) {
  const auto lines = faults({{"steps.micro_step_s", "0.002"}});
  ASSERT_EQ(lines.size(), 1u) << fixtures::joined(lines);
  EXPECT_EQ(
      lines.front(),
      "--set: steps.micro_step_s = 0.002: must be at most 0.001507 s for Co-Co 134 t: mode \"wheelset 1, vertical\" "
      "at 164.8 Hz, damping ratio 0.04924, grows with steps beyond 0.001839 s, of which 0.82 may be used");
  EXPECT_EQ(faults(withSteps("0.003", "0.0015")), std::vector<std::string>());
  EXPECT_EQ(faults({{"steps.micro_step_s", "0.002"}, {"locomotive_model", "1d"}}).size(), 2u)  // adhesion, control
      << "1d has no bodies, so no limit";
}

TEST_F(UnstableLocomotiveTest, AScenarioFileIsRefusedAsWell) {
  std::filesystem::copy(kConfig, path("config"), std::filesystem::copy_options::recursive);
  replace("config/scenarios/paper_2d.yaml", "micro_step_s: 0.001 ", "micro_step_s: 0.002 ");
  try {
    ltd::Scenario::load(path("config/scenarios/paper_2d.yaml"), {});
    FAIL() << "accepted";
  } catch (const rail::ConfigError& error) {
    EXPECT_TRUE(
        fixtures::anyHas(error.lines(), {"paper_2d.yaml: steps.micro_step_s = 0.002: must be at most 0.001507"}));
  }
}

TEST_F(UnstableLocomotiveTest, AStifferContactBearsLess) {
  std::vector<rail::Override> overrides = {{"train.groups.0.vehicle.contact.normal_law", "linear"},
                                           {"train.groups.0.vehicle.contact.linear_stiffness_N_per_m", "1.1e9"}};
  EXPECT_EQ(faults(overrides), std::vector<std::string>());
  overrides[1].value = "8e9";
  EXPECT_TRUE(fixtures::anyHas(faults(overrides), {"steps.micro_step_s = 0.001: must be at most 0.00073", "345.2 Hz"}))
      << fixtures::joined(faults(overrides));
}

TEST_F(UnstableLocomotiveTest, ALocomotiveMadeFromTheScenarioAloneIsRefusedToo) {
  rail::Problems problems;
  const rail::Document document = rail::Document::load(kScenario, {{"steps.micro_step_s", "0.002"}}, problems);
  EXPECT_EQ(loco::makeLocomotive(document, "train.groups.0.vehicle", problems), nullptr);
  EXPECT_TRUE(fixtures::anyHas(problems.lines(), {"steps.micro_step_s = 0.002: must be at most 0.001507"}));
}

/// The scenario's locomotive with a micro step that nobody has checked.
std::unique_ptr<loco::Locomotive> unchecked(const ltd::Scenario& scenario, rail::Nanoseconds micro_step) {
  rail::Problems problems;
  rail::YamlReader root(scenario.document, problems);
  const loco::ModelOptions options = loco::readModelOptions(root, micro_step);
  rail::YamlReader vehicle = root.map("train").maps("groups").front().map("vehicle");
  const loco::LocoDetails details = loco::readLocoDetails(vehicle, "2d", rail::readVehicle(vehicle));
  problems.throwIfAny();
  return std::make_unique<loco::Loco2d>(
      loco::Loco2d::Parameters{details.structure, details.contact, options.rail, options.control, 0.35, micro_step});
}

TEST_F(UnstableLocomotiveTest, ARunThatGrowsAllTheSameEndsWithBodyDegreeOfFreedomStepAndPlace) {
  std::vector<rail::Override> overrides = withSteps("0.003", "0.0015");
  overrides.push_back({"train.groups.0.count", "1"});
  overrides.push_back({"train.groups.1.count", "3"});
  const ltd::Scenario scenario = ltd::Scenario::load(kScenario, overrides);
  loco::LocalPort port(unchecked(scenario, scenario.macro_step));  // 3 ms, 1.84 are stable
  ltd::RunOutputs outputs(scenario, path("out"));
  ltd::Cosimulation cosimulation(scenario, {&port}, {&outputs});
  fixtures::runToEnd(cosimulation);

  EXPECT_EQ(cosimulation.outcome().kind, ltd::Outcome::Kind::kFailed);
  const std::string reason = cosimulation.outcome().reason;
  EXPECT_TRUE(fixtures::contains(reason, "loco_1: wheelset ")) << reason;
  EXPECT_TRUE(fixtures::contains(reason, ": in z is ")) << reason;
  EXPECT_TRUE(fixtures::contains(reason, " m from its place in step ")) << reason;
  EXPECT_TRUE(fixtures::contains(reason, " at 3.0")) << reason;
  EXPECT_TRUE(fixtures::contains(read("out/outcome.yaml"), reason));
  for (const char* file : {"summary.csv", "timeseries.csv", "energy_sections.csv"})
    for (const auto& row : cells(std::string("out/") + file))
      for (const std::string& cell : row)
        EXPECT_TRUE(cell.find("nan") == std::string::npos && cell.find("inf") == std::string::npos) << file << cell;
}

}  // namespace
