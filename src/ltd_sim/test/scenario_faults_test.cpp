// Faults of single keys and files of a scenario, and where the message points.

#include "scenario_faults.hpp"

#include <array>

namespace {

using fixtures::ScenarioFaultTest;

const std::string kConfig = CONFIG_DIR;

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

TEST_F(ScenarioFaultTest, RefusesANameThatNamesNoFile) {
  for (const char* name : {"a/b", ".hidden"})
    EXPECT_TRUE(fixtures::contains(faultOf({{"name", name}}), std::string("name = ") + name + ": ")) << name;
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

TEST_F(ScenarioFaultTest, AFaultyTrainDoesNotAccuseTheHabitsOfADriverWhoKeepsATimetable) {
  for (const char* mass : {"-120000", "120000,5"}) {
    const std::string sound = read("config/vehicles/wagon_120t.yaml");
    replace("config/vehicles/wagon_120t.yaml", "mass_kg: 120000", std::string("mass_kg: ") + mass);
    const std::vector<std::string> lines = faults({}, "scenarios/mine_to_port_1d.yaml");
    ASSERT_EQ(lines.size(), 1u) << fixtures::joined(lines);
    EXPECT_TRUE(fixtures::contains(lines[0], "mass_kg")) << lines[0];
    write("config/vehicles/wagon_120t.yaml", sound);
  }
}

TEST_F(ScenarioFaultTest, AMisspeltKeyThatNamesAFileIsToldAsItIsWritten) {
  replace("config/scenarios/paper_2d.yaml", "control_file:", "contrl_file:");
  const std::vector<std::string> lines = faults({}, "scenarios/paper_2d.yaml");
  EXPECT_EQ(
      lines,
      (std::vector<std::string>{
          "scenarios/paper_2d.yaml: control: is missing: must be a map, here or in the file that control_file names",
          "scenarios/paper_2d.yaml: contrl_file = ../control/pi_per_axle.yaml: unknown key, "
          "did you mean 'control_file'?"}))
      << fixtures::joined(lines);
}

}  // namespace
