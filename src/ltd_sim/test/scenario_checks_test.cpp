// What the maps of a scenario must be to each other.

#include "scenario_faults.hpp"

namespace {

class ScenarioChecksTest : public fixtures::ScenarioFaultTest {};

TEST_F(ScenarioChecksTest, RefusesAMacroStepThatIsNoMultipleOfTheMicroStep) {
  EXPECT_EQ(faultOf({{"steps.micro_step_s", "0.0015"}}),
            "scenarios/paper_1d.yaml: steps.macro_step_s = 0.002: must be a whole multiple of micro_step_s = 0.0015");
}

TEST_F(ScenarioChecksTest, RefusesAStepTooLongForTheTrainAndNamesTheLargest) {
  // 3 x 460.09 kN on the paper's coupler between wagons of 120 t: friction alone allows 3.162 ms, with
  // stiffness 3.1537.
  const std::string fault = faultOf({{"steps.macro_step_s", "0.004"}});
  EXPECT_TRUE(fixtures::contains(fault, "steps.macro_step_s = 0.004: must be below 0.003153 for this train")) << fault;
  EXPECT_TRUE(fixtures::contains(fault, "vehicle 4 (wagon 120 t, 120 t) with a coupler force of 1.38 MN")) << fault;
}

TEST_F(ScenarioChecksTest, RefusesOutputIntervalsThatAreNoMultipleOfTheStep) {
  EXPECT_TRUE(fixtures::contains(faultOf({{"output.timeseries_interval_s", "0.101"}}),
                                 "output.timeseries_interval_s = 0.101: must be a whole multiple"));
  EXPECT_TRUE(fixtures::contains(faultOf({{"output.telemetry_interval_s", "0.003"}}),
                                 "output.telemetry_interval_s = 0.003: must be a whole multiple"));
}

TEST_F(ScenarioChecksTest, RefusesATrainThatWouldStandBeyondTheTracksStart) {
  // 2 x 22 + 18.5 + 104 x 15 = 1622.5 m from the leading locomotive to the last wagon.
  const std::vector<std::string> lines =
      faults({{"run.start_location_km", "1.6"}, {"output.section_boundaries_km", "[3.0, 4.5]"}});
  ASSERT_EQ(lines.size(), 1u) << fixtures::joined(lines);
  EXPECT_TRUE(fixtures::contains(lines.front(),
                                 "run.start_location_km = 1.6: must be 1.6225 to 10 for this train: the train would "
                                 "stand from -0.0225 to 1.6 km, the track is from 0 to 10 km"))
      << lines.front();
  EXPECT_EQ(faults({{"run.start_location_km", "1.6225"}}), std::vector<std::string>());
}

TEST_F(ScenarioChecksTest, RefusesAnEndBeyondTheTrackOrBehindTheStart) {
  EXPECT_TRUE(fixtures::anyHas({faultOf({{"run.end_location_km", "10.001"}})},
                               {"run.end_location_km = 10.001: must be at most 10, ", "beyond the track, 0 to 10 km"}));
  const auto lines = faults({{"run.end_location_km", "2.9"}});
  EXPECT_TRUE(fixtures::anyHas(lines, {"run.end_location_km = 2.9", "must be ahead of start_location_km = 3"}));
}

TEST_F(ScenarioChecksTest, RefusesAnEndAtWhichPushedWagonsWouldHaveLeftTheTrack) {
  replace("config/trains/paper.yaml", "groups:\n",
          "groups:\n  - {kind: wagon, count: 2, vehicle_file: ../vehicles/wagon_120t.yaml}\n");
  // The first wagon runs 15 + 18.5 m ahead of the leading locomotive.
  EXPECT_EQ(faults({{"run.end_location_km", "9.966"}}), std::vector<std::string>());
  EXPECT_TRUE(fixtures::contains(faultOf({{"run.end_location_km", "9.967"}}),
                                 "run.end_location_km = 9.967: must be at most 9.9665, or"));
}

TEST_F(ScenarioChecksTest, RefusesReportLocationsThatFallOrLieOutsideTheRun) {
  EXPECT_TRUE(fixtures::contains(faultOf({{"output.report_locations_km", "[3.2, 3.15]"}}),
                                 "output.report_locations_km.1 = 3.15: must be ahead of the one before, 3.2"));
  EXPECT_TRUE(fixtures::contains(faultOf({{"output.report_locations_km", "[2.9, 3.15]"}}),
                                 "output.report_locations_km.0 = 2.9: must be 3 to 10 km, from run.start_location_km"));
  EXPECT_TRUE(fixtures::contains(faultOf({{"output.section_boundaries_km", "[3.0, 10.1]"}}),
                                 "output.section_boundaries_km.1 = 10.1: must be 3 to 10 km"));
}

TEST_F(ScenarioChecksTest, TellsARunThatDoesNotFitItsTrackAndAStepThatIsTooLongBesideOtherFaults) {
  const auto lines =
      faults({{"steps.macro_step_s", "0.02"}, {"run.end_location_km", "99"}, {"driver.groups.lead.follows", "nobody"}});
  EXPECT_EQ(lines.size(), 3u) << fixtures::joined(lines);
  EXPECT_TRUE(fixtures::anyHas(lines, {"steps.macro_step_s = 0.02", "must be below"}));
  EXPECT_TRUE(fixtures::anyHas(lines, {"run.end_location_km = 99"}));
  EXPECT_TRUE(fixtures::anyHas(lines, {"driver.groups.lead.follows = nobody"}));
}

TEST_F(ScenarioChecksTest, RefusesARailSectionBeyondTheTrack) {
  const std::vector<std::string> lines = faults({{"rail_sections.0.to_km", "12"}}, "scenarios/wet_stretch.yaml");
  ASSERT_EQ(lines.size(), 1u) << fixtures::joined(lines);
  EXPECT_NE(lines[0].find("rail_sections.0.to_km = 12: is beyond the track, 0 to 10 km"), std::string::npos)
      << lines[0];
}

TEST_F(ScenarioChecksTest, RefusesANotchGroupThatTheDriverDoesNotKnow) {
  replace("config/trains/paper.yaml", "notch_group: lead", "notch_group: head");
  const auto lines = faults();
  EXPECT_TRUE(fixtures::anyHas(lines, {"scenarios/paper_1d.yaml: driver.groups.head", "is missing"}));
  EXPECT_TRUE(fixtures::anyHas(lines, {"scenarios/paper_1d.yaml: driver.groups.lead", "unknown key"}));
  EXPECT_EQ(lines.size(), 2u) << fixtures::joined(lines);
}

TEST_F(ScenarioChecksTest, AStartOffTheTrackIsToldAloneAndWithThePlacesThatAreRight) {
  const std::vector<std::string> metres = faults({{"run.start_location_km", "3000"}});
  ASSERT_EQ(metres.size(), 1u) << fixtures::joined(metres);
  EXPECT_TRUE(fixtures::contains(metres.front(), "run.start_location_km = 3000: must be 1.6225 to 10 for this train"));
  const std::vector<std::string> lines = faults({{"train.groups.1.count", "700"}});
  ASSERT_EQ(lines.size(), 1u) << fixtures::joined(lines);
  EXPECT_TRUE(fixtures::contains(lines.front(), "the track is from 0 to 10 km: the train is longer than the track"))
      << lines.front();
}

TEST_F(ScenarioChecksTest, ATrainThatIsNotThereDoesNotAccuseItsDriver) {
  const std::vector<std::string> lines = faults({{"train", "trains/paper.yaml"}});
  ASSERT_EQ(lines.size(), 1u) << fixtures::joined(lines);
  EXPECT_EQ(lines.front(), "--set: train = trains/paper.yaml: must be a map; a file is named by train_file");
}

}  // namespace
