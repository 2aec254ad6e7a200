// What a scenario must say for its locomotives' models, and must not.

#include "scenario_faults.hpp"

namespace {

class ScenarioModelsTest : public fixtures::ScenarioFaultTest {};

TEST_F(ScenarioModelsTest, RefusesAModelThatDoesNotExist) {
  EXPECT_TRUE(fixtures::contains(faultOf({{"locomotive_model", "4d"}}), "locomotive_model = 4d: must be one of: 1d"));
}

TEST_F(ScenarioModelsTest, RefusesOptionsOf3dLocomotivesInATrainThatHasNone) {
  replace("config/scenarios/paper_3d_two_point.yaml", "locomotive_model: 3d", "locomotive_model: 2d");
  const auto lines = faults({}, "scenarios/paper_3d_two_point.yaml");
  EXPECT_EQ(lines.size(), 2u) << fixtures::joined(lines);
  EXPECT_TRUE(fixtures::anyHas(lines, {"profiles", "is of use to 3D locomotives only: remove it"}))
      << fixtures::joined(lines);
  EXPECT_TRUE(fixtures::anyHas(lines, {"gravity_stiffness = true", "is of use to 3D locomotives only"}))
      << fixtures::joined(lines);
}

TEST_F(ScenarioModelsTest, RefusesAFaultInTheScenariosProfilesOnceAndWithItsFile) {
  replace("config/profiles/coned_1_20_uic60.yaml", "gauge_mm: 1435", "gauge_mm: 1400");
  const auto lines = faults({}, "scenarios/paper_3d_two_point.yaml");
  EXPECT_EQ(lines.size(), 1u) << fixtures::joined(lines);
  EXPECT_TRUE(fixtures::anyHas(lines, {"profiles/coned_1_20_uic60.yaml: gauge_mm = 1400: gauge too narrow"}))
      << fixtures::joined(lines);
}

TEST_F(ScenarioModelsTest, RefusesContactOptionsInATrainThatHasNoContacts) {
  replace("config/scenarios/wet_stretch.yaml", "locomotive_model: 2d", "locomotive_model: 1d");
  const std::vector<std::string> lines = faults({}, "scenarios/wet_stretch.yaml");
  const std::string rule = ": is of no use to 1D locomotives: remove it, or choose another locomotive_model";
  EXPECT_EQ(lines, (std::vector<std::string>{
                       "scenarios/wet_stretch.yaml: adhesion_file = ../adhesion/paper_table1.yaml" + rule,
                       "scenarios/wet_stretch.yaml: rail_sections = [...]" + rule,
                       "scenarios/wet_stretch.yaml: control_file = ../control/pi_per_axle.yaml" + rule}))
      << fixtures::joined(lines);
}

TEST_F(ScenarioModelsTest, ContactOptionsGoByTheModelsOfTheGroupsNotByTheScenarios) {
  const std::string file = "config/scenarios/paper_2d.yaml";
  replace("config/trains/paper.yaml", "notch_group: lead", "notch_group: lead, locomotive_model: 1d");
  EXPECT_EQ(faults({}, "scenarios/paper_2d.yaml").size(), 2u);  // neither adhesion nor control is of use
  replace(file, "adhesion_file:", "# adhesion_file:");
  replace(file, "control_file:", "# control_file:");
  EXPECT_EQ(faults({}, "scenarios/paper_2d.yaml"), std::vector<std::string>());
}

TEST_F(ScenarioModelsTest, AFaultInTheTrainOrTheModelDoesNotAccuseContactOptions) {
  for (const std::string model : {"1d", "5d"}) {
    const std::vector<std::string> lines =
        faults({{"locomotive_model", model}, {"train.groups.0.count", "0"}}, "scenarios/paper_2d.yaml");
    EXPECT_EQ(lines.size(), model == "1d" ? 1u : 2u) << fixtures::joined(lines);
  }
}

}  // namespace
