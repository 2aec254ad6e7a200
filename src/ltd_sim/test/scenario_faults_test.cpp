// Every class of fault in the files of a scenario, and where the message points.

#include <array>

#include "ltd_sim/scenario.hpp"
#include "scratch_directory.hpp"
#include "train_fixtures.hpp"

namespace {

const std::string kConfig = CONFIG_DIR;

/// A copy of config/ in which a test breaks something.
class ScenarioFaultTest : public fixtures::ScratchDirectory {
 protected:
  ScenarioFaultTest() { std::filesystem::copy(kConfig, path("config"), std::filesystem::copy_options::recursive); }

  /// What is refused, without this test's directory.
  std::vector<std::string> faults(const std::vector<rail::Override>& overrides = {},
                                  const std::string& file = "scenarios/paper_1d.yaml") const {
    try {
      ltd::Scenario::load(path("config/" + file), overrides);
    } catch (const rail::ConfigError& error) {
      std::vector<std::string> lines = error.lines();
      for (std::string& line : lines) {
        const std::size_t at = line.find(path("config/"));
        if (at != std::string::npos) line.erase(at, path("config/").size());
      }
      return lines;
    }
    return {};
  }

  /// What is said of a scenario outside the copy.
  static std::vector<std::string> absent(const std::string& file) {
    try {
      ltd::Scenario::load(file, {});
    } catch (const rail::ConfigError& error) {
      return error.lines();
    }
    return {};
  }

  /// The one line that breaking `file` gives.
  std::string faultOf(const std::string& file, const std::string& from, const std::string& to) const {
    replace("config/" + file, from, to);
    const std::vector<std::string> lines = faults();
    EXPECT_EQ(lines.size(), 1u) << fixtures::joined(lines);
    return lines.empty() ? "accepted" : lines.front();
  }
  std::string faultOf(const std::vector<rail::Override>& overrides) const {
    const std::vector<std::string> lines = faults(overrides);
    EXPECT_EQ(lines.size(), 1u) << fixtures::joined(lines);
    return lines.empty() ? "accepted" : lines.front();
  }
};

TEST_F(ScenarioFaultTest, TheCopyItselfIsSound) { EXPECT_EQ(faults(), std::vector<std::string>()); }

TEST_F(ScenarioFaultTest, AScenarioThatDoesNotExistIsAnsweredWithThoseThatDo) {
  const std::string folder = path("config/scenarios");
  const std::string misspelt = faults({}, "scenarios/emergncy.yaml").at(0);
  EXPECT_EQ(misspelt.rfind("scenarios/emergncy.yaml: scenario emergncy does not exist, did you mean " + folder +
                               "/emergency_stop.yaml?; in " + folder + " there are: emergency_stop, ",
                           0),
            0u)
      << misspelt;
  EXPECT_FALSE(fixtures::contains(faults({}, "scenarios/wagons.yaml").at(0), "did you mean"));
  const std::vector<std::string> lines = faults({}, "scenarios/paper_4d.yaml");
  ASSERT_EQ(lines.size(), 1u);
  for (const auto& entry : std::filesystem::directory_iterator(kConfig + "/scenarios"))
    EXPECT_TRUE(fixtures::contains(lines.front(), entry.path().stem().string())) << lines.front();
  // What lies beside a scenario and is none is not offered as one.
  std::filesystem::copy(path("config/trains/paper.yaml"), path("config/scenarios/paper_train.yaml"));
  write("config/scenarios/broken.yaml", "a: [\n");
  const std::string beside = faults({}, "scenarios/paper_train_1.yaml").at(0);
  EXPECT_FALSE(fixtures::contains(beside, "paper_train,")) << beside;
  EXPECT_FALSE(fixtures::contains(beside, "broken")) << beside;
  // Who calls from the checkout need not say where scenarios are.
  const std::filesystem::path here = std::filesystem::current_path();
  std::filesystem::current_path(path(""));
  const std::string bare = fixtures::joined(absent("emergncy.yaml"));
  std::filesystem::current_path(here);
  EXPECT_TRUE(fixtures::contains(bare, "did you mean config/scenarios/emergency_stop.yaml?")) << bare;
  // Nor is what lies in a folder of other things.
  EXPECT_TRUE(fixtures::contains(faults({}, "locomotives/bo_bo_8t.yaml").at(0), "there are none in "));
  const std::vector<std::string> nowhere = faults({}, "absent/paper_1d.yaml");
  ASSERT_EQ(nowhere.size(), 1u);
  EXPECT_TRUE(fixtures::contains(nowhere.front(), "scenario paper_1d does not exist; there are none in "));
}

TEST_F(ScenarioFaultTest, RefusesAMisspeltKeyWithTheOneThatWasMeant) {
  replace("config/vehicles/wagon_120t.yaml", "mass_kg:", "mas_kg:");
  EXPECT_EQ(faults(), (std::vector<std::string>{
                          "vehicles/wagon_120t.yaml: mass_kg: is missing: must be a number >= 1000 and <= 1000000",
                          "vehicles/wagon_120t.yaml: mas_kg = 120000: unknown key, did you mean 'mass_kg'?"}));
}

TEST_F(ScenarioFaultTest, RefusesAnUnknownKeyAtTheRoot) {
  EXPECT_EQ(faultOf("scenarios/paper_1d.yaml", "name: paper_1d", "name: paper_1d\nrotary_inertias: true"),
            "scenarios/paper_1d.yaml: rotary_inertias = true: unknown key, did you mean 'rotary_inertia'?");
}

TEST_F(ScenarioFaultTest, RefusesAMissingKey) {
  EXPECT_EQ(faultOf("vehicles/wagon_120t.yaml", "axles: 4\n", ""),
            "vehicles/wagon_120t.yaml: axles: is missing: must be an integer >= 2 and <= 32");
}

TEST_F(ScenarioFaultTest, RefusesAnIllTypedValue) {
  EXPECT_EQ(faultOf("vehicles/wagon_120t.yaml", "length_m: 15 ", "length_m: 15m "),
            "vehicles/wagon_120t.yaml: length_m = 15m: must be a number > 0 and <= 100, without unit or other text");
}

TEST_F(ScenarioFaultTest, RefusesAnImpossibleValue) {
  EXPECT_EQ(faultOf("vehicles/wagon_120t.yaml", "mass_kg: 120000", "mass_kg: -120000"),
            "vehicles/wagon_120t.yaml: mass_kg = -120000: must be a number >= 1000 and <= 1000000");
}

TEST_F(ScenarioFaultTest, RefusesATractionTableThatFalls) {
  replace("config/locomotives/bo_bo_88t_traction.csv", "5,27000,68000,", "5,27000,26000,");
  const auto lines = faults({}, "scenarios/empties_distributed_power.yaml");
  ASSERT_FALSE(lines.empty());
  EXPECT_EQ(lines.front(),
            "locomotives/bo_bo_88t_traction.csv: line 5: notch_2_N = 26000: must not fall with the notch");
}

TEST_F(ScenarioFaultTest, RefusesAChainageThatGoesBack) {
  replace("config/tracks/rolling_line.csv", "2.90, 6.0,", "2.30, 6.0,");
  const auto lines = faults({}, "scenarios/empties_distributed_power.yaml");
  EXPECT_EQ(lines.size(), 1u);
  EXPECT_TRUE(fixtures::anyHas(lines, {"tracks/rolling_line.csv: line 6: chainage_km = 2.3", "must not go back"}))
      << fixtures::joined(lines);
}

TEST_F(ScenarioFaultTest, RefusesACurveBeyondTheTrack) {
  const std::string fault = faultOf("tracks/paper.yaml", "start_km: 3.3,", "start_km: 9.9,");
  EXPECT_TRUE(fixtures::contains(fault, "tracks/paper.yaml: curves.0")) << fault;
}

TEST_F(ScenarioFaultTest, RefusesANotchGroupThatTheDriverDoesNotKnow) {
  replace("config/trains/paper.yaml", "notch_group: lead", "notch_group: head");
  const auto lines = faults();
  EXPECT_TRUE(fixtures::anyHas(lines, {"scenarios/paper_1d.yaml: driver.groups.head", "is missing"}));
  EXPECT_TRUE(fixtures::anyHas(lines, {"scenarios/paper_1d.yaml: driver.groups.lead", "unknown key"}));
  EXPECT_EQ(lines.size(), 2u) << fixtures::joined(lines);
}

TEST_F(ScenarioFaultTest, RefusesAMacroStepThatIsNoMultipleOfTheMicroStep) {
  EXPECT_EQ(faultOf({{"steps.micro_step_s", "0.0015"}}),
            "scenarios/paper_1d.yaml: steps.macro_step_s = 0.002: must be a whole multiple of micro_step_s = 0.0015");
}

TEST_F(ScenarioFaultTest, RefusesAStepThatIsNoWholeNumberOfNanoseconds) {
  const auto lines = faults({{"steps.macro_step_s", "0.00033333333333"}, {"steps.micro_step_s", "0.00033333333333"}});
  EXPECT_TRUE(fixtures::anyHas(lines, {"steps.macro_step_s", "whole number of nanoseconds"}));
  EXPECT_TRUE(fixtures::anyHas(lines, {"steps.micro_step_s", "whole number of nanoseconds"}));
}

TEST_F(ScenarioFaultTest, RefusesTimesThatRoundToNoNanosecondAtAll) {
  for (const char* key : {"steps.macro_step_s", "steps.micro_step_s", "output.timeseries_interval_s",
                          "output.telemetry_interval_s", "run.end_time_s", "run.stall.for_s"})
    EXPECT_TRUE(fixtures::anyHas(faults({{key, "1.0e-13"}}), {key, "whole number of nanoseconds"})) << key;
}

TEST_F(ScenarioFaultTest, RefusesAStepTooLongForTheTrainAndNamesTheLargest) {
  // 3 x 460.09 kN on the paper's coupler between wagons of 120 t: friction alone allows 3.162 ms, with
  // stiffness 3.1537.
  const std::string fault = faultOf({{"steps.macro_step_s", "0.004"}});
  EXPECT_TRUE(fixtures::contains(fault, "steps.macro_step_s = 0.004: must be below 0.003153 for this train")) << fault;
  EXPECT_TRUE(fixtures::contains(fault, "vehicle 4 (wagon 120 t, 120 t) with a coupler force of 1.38 MN")) << fault;
}

TEST_F(ScenarioFaultTest, RefusesOutputIntervalsThatAreNoMultipleOfTheStep) {
  EXPECT_TRUE(fixtures::contains(faultOf({{"output.timeseries_interval_s", "0.101"}}),
                                 "output.timeseries_interval_s = 0.101: must be a whole multiple"));
  EXPECT_TRUE(fixtures::contains(faultOf({{"output.telemetry_interval_s", "0.003"}}),
                                 "output.telemetry_interval_s = 0.003: must be a whole multiple"));
}

TEST_F(ScenarioFaultTest, RefusesATrainThatWouldStandBeyondTheTracksStart) {
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

TEST_F(ScenarioFaultTest, AStartOffTheTrackIsToldAloneAndWithThePlacesThatAreRight) {
  const std::vector<std::string> metres = faults({{"run.start_location_km", "3000"}});
  ASSERT_EQ(metres.size(), 1u) << fixtures::joined(metres);
  EXPECT_TRUE(fixtures::contains(metres.front(), "run.start_location_km = 3000: must be 1.6225 to 10 for this train"));
  const std::vector<std::string> lines = faults({{"train.groups.1.count", "700"}});
  ASSERT_EQ(lines.size(), 1u) << fixtures::joined(lines);
  EXPECT_TRUE(fixtures::contains(lines.front(), "the track is from 0 to 10 km: the train is longer than the track"))
      << lines.front();
}

TEST_F(ScenarioFaultTest, RefusesAnEndBeyondTheTrackOrBehindTheStart) {
  EXPECT_TRUE(fixtures::anyHas({faultOf({{"run.end_location_km", "10.001"}})},
                               {"run.end_location_km = 10.001: must be at most 10, ", "beyond the track, 0 to 10 km"}));
  const auto lines = faults({{"run.end_location_km", "2.9"}});
  EXPECT_TRUE(fixtures::anyHas(lines, {"run.end_location_km = 2.9", "must be ahead of start_location_km = 3"}));
}

TEST_F(ScenarioFaultTest, RefusesAnEndAtWhichPushedWagonsWouldHaveLeftTheTrack) {
  replace("config/trains/paper.yaml", "groups:\n",
          "groups:\n  - {kind: wagon, count: 2, vehicle_file: ../vehicles/wagon_120t.yaml}\n");
  // The first wagon runs 15 + 18.5 m ahead of the leading locomotive.
  EXPECT_EQ(faults({{"run.end_location_km", "9.966"}}), std::vector<std::string>());
  EXPECT_TRUE(fixtures::contains(faultOf({{"run.end_location_km", "9.967"}}),
                                 "run.end_location_km = 9.967: must be at most 9.9665, or"));
}

TEST_F(ScenarioFaultTest, RefusesANameThatNamesNoFile) {
  for (const char* name : {"a/b", ".hidden"})
    EXPECT_TRUE(fixtures::contains(faultOf({{"name", name}}), std::string("name = ") + name + ": ")) << name;
}

TEST_F(ScenarioFaultTest, RefusesReportLocationsThatFallOrLieOutsideTheRun) {
  EXPECT_TRUE(fixtures::contains(faultOf({{"output.report_locations_km", "[3.2, 3.15]"}}),
                                 "output.report_locations_km.1 = 3.15: must be ahead of the one before, 3.2"));
  EXPECT_TRUE(fixtures::contains(faultOf({{"output.report_locations_km", "[2.9, 3.15]"}}),
                                 "output.report_locations_km.0 = 2.9: must be 3 to 10 km, from run.start_location_km"));
  EXPECT_TRUE(fixtures::contains(faultOf({{"output.section_boundaries_km", "[3.0, 10.1]"}}),
                                 "output.section_boundaries_km.1 = 10.1: must be 3 to 10 km"));
}

TEST_F(ScenarioFaultTest, RefusesAModelThatDoesNotExist) {
  EXPECT_TRUE(fixtures::contains(faultOf({{"locomotive_model", "4d"}}), "locomotive_model = 4d: must be one of: 1d"));
}

TEST_F(ScenarioFaultTest, RefusesAFileThatIsNotThereAndOneThatIsNoYaml) {
  EXPECT_TRUE(fixtures::contains(faultOf("trains/paper.yaml", "wagon_120t", "wagon_12Ot"), "cannot read"));
  write("config/vehicles/wagon_12Ot.yaml", "name: [\n");
  EXPECT_TRUE(fixtures::anyHas(faults(), {"vehicles/wagon_12Ot.yaml"}));
}

TEST_F(ScenarioFaultTest, TellsAllFaultsOfAllFilesAtOnce) {
  replace("config/vehicles/wagon_120t.yaml", "mass_kg: 120000", "mass_kg: -1");
  replace("config/locomotives/co_co_134t.yaml", "adhesion_limit: 0.35", "adhesion_limit: 35");
  replace("config/couplers/draft_gear_20mm.yaml", "unloading_ratio: 0.45", "unloading_ratio: 1.45");
  replace("config/resistance/wu_2020.yaml", "per_axle_N: 89.2", "per_axle_N: -89.2");
  replace("config/tracks/paper.yaml", "radius_m: 300", "radius_m: 30");
  replace("config/scenarios/paper_1d.yaml", "end_time_s: 3600", "end_time_s: soon");
  replace("config/scenarios/paper_1d.yaml", "[20, 3]", "[20, 30]");
  const std::vector<std::string> lines = faults();
  for (const std::vector<std::string>& parts :
       std::vector<std::vector<std::string>>{{"vehicles/wagon_120t.yaml: mass_kg = -1: "},
                                             {"locomotives/co_co_134t.yaml: adhesion_limit = 35: "},
                                             {"couplers/draft_gear_20mm.yaml: unloading_ratio = 1.45: "},
                                             {"resistance/wu_2020.yaml: per_axle_N = -89.2: "},
                                             {"tracks/paper.yaml: curves.0", "30"},
                                             {"scenarios/paper_1d.yaml: run.end_time_s = soon: "},
                                             {"scenarios/paper_1d.yaml: driver.notches.2", "30", "0 to 8"}})
    EXPECT_TRUE(fixtures::anyHas(lines, parts)) << parts.front() << "\nin\n" << fixtures::joined(lines);
  EXPECT_EQ(lines.size(), 7u) << fixtures::joined(lines);  // each once, also that of a file which two vehicles name
}

TEST_F(ScenarioFaultTest, TellsARunThatDoesNotFitItsTrackAndAStepThatIsTooLongBesideOtherFaults) {
  const auto lines =
      faults({{"steps.macro_step_s", "0.02"}, {"run.end_location_km", "99"}, {"driver.groups.lead.follows", "nobody"}});
  EXPECT_EQ(lines.size(), 3u) << fixtures::joined(lines);
  EXPECT_TRUE(fixtures::anyHas(lines, {"steps.macro_step_s = 0.02", "must be below"}));
  EXPECT_TRUE(fixtures::anyHas(lines, {"run.end_location_km = 99"}));
  EXPECT_TRUE(fixtures::anyHas(lines, {"driver.groups.lead.follows = nobody"}));
}

TEST_F(ScenarioFaultTest, ATrainThatIsNotThereDoesNotAccuseItsDriver) {
  const std::vector<std::string> lines = faults({{"train", "trains/paper.yaml"}});
  ASSERT_EQ(lines.size(), 1u) << fixtures::joined(lines);
  EXPECT_EQ(lines.front(), "--set: train = trains/paper.yaml: must be a map; a file is named by train_file");
}

TEST_F(ScenarioFaultTest, AFaultDoesNotAccuseWhatIsSoundBesideIt) {
  // Each of these leaves a value unknown; nothing that would be compared with it may be refused.
  for (const auto& [file, from, to] : std::vector<std::array<std::string, 3>>{
           {"scenarios/paper_1d.yaml", "macro_step_s: 0.002", "macro_step_s: x"},
           {"scenarios/paper_1d.yaml", "micro_step_s: 0.001", "micro_step_s: x"},
           {"scenarios/paper_1d.yaml", "start_location_km: 3.0", "start_location_km: x"},
           {"scenarios/paper_1d.yaml", "end_location_km: 4.5", "end_location_km: x"},
           {"scenarios/paper_1d.yaml", "[3.15, 3.2,", "[3.15, x,"},
           {"scenarios/paper_1d.yaml", "\nsteps:", "\nstep:"},
           {"tracks/paper.yaml", "radius_m: 300", "radius_m: x"},
           {"locomotives/co_co_134t.yaml", "notches: 8", "notches: x"}}) {
    SCOPED_TRACE(to);
    const std::string sound = read("config/" + file);
    replace("config/" + file, from, to);
    const std::vector<std::string> lines = faults();
    EXPECT_EQ(lines.size(), to == "\nstep:" ? 2u : 1u) << fixtures::joined(lines);  // misspelt: missing and unknown
    write("config/" + file, sound);
  }
}

TEST_F(ScenarioFaultTest, RefusesARailSectionBeyondTheTrack) {
  const std::vector<std::string> lines = faults({{"rail_sections.0.to_km", "12"}}, "scenarios/wet_stretch.yaml");
  ASSERT_EQ(lines.size(), 1u) << fixtures::joined(lines);
  EXPECT_NE(lines[0].find("rail_sections.0.to_km = 12: is beyond the track, 0 to 10 km"), std::string::npos)
      << lines[0];
}

TEST_F(ScenarioFaultTest, RefusesOptionsOf3dLocomotivesInATrainThatHasNone) {
  replace("config/scenarios/paper_3d_two_point.yaml", "locomotive_model: 3d", "locomotive_model: 2d");
  const auto lines = faults({}, "scenarios/paper_3d_two_point.yaml");
  EXPECT_EQ(lines.size(), 2u) << fixtures::joined(lines);
  EXPECT_TRUE(fixtures::anyHas(lines, {"profiles", "is of use to 3D locomotives only: remove it"}))
      << fixtures::joined(lines);
  EXPECT_TRUE(fixtures::anyHas(lines, {"gravity_stiffness = true", "is of use to 3D locomotives only"}))
      << fixtures::joined(lines);
}

TEST_F(ScenarioFaultTest, RefusesAFaultInTheScenariosProfilesOnceAndWithItsFile) {
  replace("config/profiles/coned_1_20_uic60.yaml", "gauge_mm: 1435", "gauge_mm: 1400");
  const auto lines = faults({}, "scenarios/paper_3d_two_point.yaml");
  EXPECT_EQ(lines.size(), 1u) << fixtures::joined(lines);
  EXPECT_TRUE(fixtures::anyHas(lines, {"profiles/coned_1_20_uic60.yaml: gauge_mm = 1400: gauge too narrow"}))
      << fixtures::joined(lines);
}

TEST_F(ScenarioFaultTest, RefusesContactOptionsInATrainThatHasNoContacts) {
  replace("config/scenarios/wet_stretch.yaml", "locomotive_model: 2d", "locomotive_model: 1d");
  const std::vector<std::string> lines = faults({}, "scenarios/wet_stretch.yaml");
  const std::string rule = ": is of no use to 1D locomotives: remove it, or choose another locomotive_model";
  EXPECT_EQ(lines, (std::vector<std::string>{
                       "scenarios/wet_stretch.yaml: adhesion_file = ../adhesion/paper_table1.yaml" + rule,
                       "scenarios/wet_stretch.yaml: rail_sections = [...]" + rule,
                       "scenarios/wet_stretch.yaml: control_file = ../control/pi_per_axle.yaml" + rule}))
      << fixtures::joined(lines);
}

TEST_F(ScenarioFaultTest, ContactOptionsGoByTheModelsOfTheGroupsNotByTheScenarios) {
  const std::string file = "config/scenarios/paper_2d.yaml";
  replace("config/trains/paper.yaml", "notch_group: lead", "notch_group: lead, locomotive_model: 1d");
  EXPECT_EQ(faults({}, "scenarios/paper_2d.yaml").size(), 2u);  // neither adhesion nor control is of use
  replace(file, "adhesion_file:", "# adhesion_file:");
  replace(file, "control_file:", "# control_file:");
  EXPECT_EQ(faults({}, "scenarios/paper_2d.yaml"), std::vector<std::string>());
}

TEST_F(ScenarioFaultTest, AFaultInTheTrainOrTheModelDoesNotAccuseContactOptions) {
  for (const std::string model : {"1d", "5d"}) {
    const std::vector<std::string> lines =
        faults({{"locomotive_model", model}, {"train.groups.0.count", "0"}}, "scenarios/paper_2d.yaml");
    EXPECT_EQ(lines.size(), model == "1d" ? 1u : 2u) << fixtures::joined(lines);
  }
}

TEST_F(ScenarioFaultTest, AMisspeltKeyThatNamesAFileIsToldAsItIsWritten) {
  replace("config/scenarios/paper_2d.yaml", "control_file:", "contrl_file:");
  const std::vector<std::string> lines = faults({}, "scenarios/paper_2d.yaml");
  EXPECT_EQ(lines, (std::vector<std::string>{
                       "scenarios/paper_2d.yaml: control: is missing: must be a map",
                       "scenarios/paper_2d.yaml: contrl_file = ../control/pi_per_axle.yaml: unknown key, "
                       "did you mean 'control_file'?"}))
      << fixtures::joined(lines);
}

}  // namespace
