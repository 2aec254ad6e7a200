#include "ltd_sim/offline.hpp"

#include <algorithm>

#include "ltd_sim/progress.hpp"
#include "offline_arguments.hpp"
#include "scratch_directory.hpp"
#include "train_fixtures.hpp"

namespace {

using ltd::OfflineArguments;
using Words = std::vector<std::string>;

TEST(SplitValuesTest, SplitsAtCommasOutsideBracketsBracesAndQuotes) {
  EXPECT_EQ(ltd::splitValues("a"), (Words{"a"}));
  EXPECT_EQ(ltd::splitValues("1,2.5,x"), (Words{"1", "2.5", "x"}));
  EXPECT_EQ(ltd::splitValues("[1,2],{a: 1, b: [2,3]},4"), (Words{"[1,2]", "{a: 1, b: [2,3]}", "4"}));
  EXPECT_EQ(ltd::splitValues("'a,b',\"c,'d\""), (Words{"'a,b'", "\"c,'d\""}));
  EXPECT_EQ(ltd::splitValues("a,,b"), (Words{"a", "", "b"}));
  EXPECT_EQ(ltd::splitValues(""), (Words{""}));
}

TEST(OfflineArgumentsTest, ReadsAWholeCommandLine) {
  OfflineArguments arguments;
  EXPECT_EQ(arguments.parse({"--out", "dir", "s.yaml", "--set", "a.b=1", "--no-bag", "--set", "c=x=y"}), "");
  EXPECT_EQ(arguments.scenario, "s.yaml");
  EXPECT_EQ(arguments.out, "dir");
  EXPECT_FALSE(arguments.bag);
  ASSERT_EQ(arguments.sets.size(), 2u);
  EXPECT_EQ(arguments.sets[0].first, "a.b");
  EXPECT_EQ(arguments.sets[1].second, (Words{"x=y"}));
}

TEST(OfflineArgumentsTest, TellsWhatIsWrong) {
  const auto fault = [](const Words& words) { return OfflineArguments().parse(words); };
  EXPECT_EQ(fault({}), "SCENARIO.yaml is missing");
  EXPECT_EQ(fault({"s.yaml"}), "--out DIR is missing");
  EXPECT_EQ(fault({"s.yaml", "--out"}), "--out: needs a value after it");
  EXPECT_EQ(fault({"s.yaml", "--set"}), "--set: needs a value after it");
  EXPECT_EQ(fault({"s.yaml", "--out", "d", "--set", "a"}), "--set a: must read key=value");
  EXPECT_EQ(fault({"s.yaml", "--out", "d", "--set", "=1"}), "--set =1: must read key=value");
  EXPECT_EQ(fault({"s.yaml", "--outt", "d"}), "--outt: unknown option, did you mean '--out'?");
  EXPECT_EQ(fault({"s.yaml", "--record"}),
            "--record: unknown option; there are: --out, --set, --jobs, --no-bag, --help");
  EXPECT_EQ(fault({"s.yaml", "--out=d"}), "--out=d: unknown option, write '--out', a blank, its value");
  EXPECT_EQ(fault({"s.yaml", "--out", "--no-bag"}), "--out: needs a value after it");
  EXPECT_EQ(fault({"s.yaml", "t.yaml", "--out", "d"}), "t.yaml: one scenario at a time (the first was s.yaml)");
  EXPECT_EQ(fault({"s.yaml", "--out", "d", "--jobs", "3"}), "");
  for (const char* jobs : {"0", "-1", "2.5", "", "1000", "all"})
    EXPECT_EQ(fault({"s.yaml", "--out", "d", "--jobs", jobs}),
              std::string("--jobs ") + jobs + ": must be a whole number from 1 to 999");
  EXPECT_EQ(fault({"--help"}), "");
}

/// What a command line with these arguments of --set announces, and its hints.
std::pair<std::string, std::string> announced(const Words& sets) {
  Words words = {"s.yaml", "--out", "d"};
  for (const std::string& set : sets) words.insert(words.end(), {"--set", set});
  OfflineArguments arguments;
  EXPECT_EQ(arguments.parse(words), "");
  return {arguments.announcement(), arguments.commaHints()};
}

TEST(OfflineArgumentsTest, ASweepIsAnnouncedWithItsValues) {
  EXPECT_EQ(announced({"a=1", "b=[1,2]"}).first, "");
  EXPECT_EQ(announced({"a=1,2", "b=x", "c=0.1,0.2,0.3"}).first,
            "6 runs, one for each combination of the values given to --set (a comma separates values):\n"
            "  a = 1  |  2\n  c = 0.1  |  0.2  |  0.3\n");
}

TEST(OfflineArgumentsTest, WhatLooksLikeADecimalCommaIsSweptWithAHint) {
  EXPECT_EQ(announced({"x=0,25"}).second,
            "ltd_offline: --set x=0,25: is taken as two values, 0 and 25; if one number was meant, write 0.25\n");
  for (const char* const likely : {"x=0,1", "x=-0,5", "x=12,5", "x=-3,2"})
    EXPECT_NE(announced({likely}).second, "") << likely;
  for (const char* const honest : {"x=6,12", "x=0.15,0.3", "x=0,0.5", "x=0,1,2", "x=3,-3", "x=a,b", "x=1,2", "x=0"})
    EXPECT_EQ(announced({honest}).second, "") << honest;
  EXPECT_EQ(announced({"x=12", "x=5"}).second, "");  // given one by one
  // No number is written so: with a comma before it was meant to be a fraction.
  EXPECT_TRUE(fixtures::contains(OfflineArguments().parse({"s.yaml", "--set", "x=1,05"}), "gives the value 05"));
}

TEST(OfflineArgumentsTest, EveryCombinationOfValuesComesOnceTheLastKeyVaryingFastest) {
  OfflineArguments arguments;
  ASSERT_EQ(
      arguments.parse({"s.yaml", "--out", "d", "--set", "a=1,2", "--set", "b=x", "--set", "c=7,8", "--set", "a=3"}),
      "");
  Words all;
  for (const auto& combination : arguments.combinations()) {
    std::string text;
    for (const rail::Override& o : combination) text += o.key + o.value;
    all.push_back(text);
  }
  EXPECT_EQ(all, (Words{"a1bxc7", "a1bxc8", "a2bxc7", "a2bxc8", "a3bxc7", "a3bxc8"}));
  EXPECT_EQ(OfflineArguments().combinations().size(), 1u);
  EXPECT_TRUE(OfflineArguments().combinations().front().empty());
}

const std::string kPaper = std::string(CONFIG_DIR) + "/scenarios/paper_1d.yaml";

class RunOfflineTest : public fixtures::ScratchDirectory {
 protected:
  /// A short run of a short train with these words more on the command line.
  int offline(const Words& more) {
    Words words = {kPaper, "--out", path("out"), "--no-bag", "--set", "train.groups.1.count=3"};
    words.insert(words.end(), more.begin(), more.end());
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    const int status = ltd::runOffline(words, {});
    said_ = ::testing::internal::GetCapturedStdout();
    complained_ = ::testing::internal::GetCapturedStderr();
    return status;
  }
  bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }

  std::string said_, complained_;
};

TEST_F(RunOfflineTest, AFinishedRunGives0AndItsFolder) {
  EXPECT_EQ(offline({"--set", "run.end_time_s=1"}), 0);
  for (const char* file :
       {"scenario.resolved.yaml", "summary.csv", "timeseries.csv", "energy_sections.csv", "outcome.yaml"})
    EXPECT_TRUE(exists(std::string("out/") + file)) << file;
  EXPECT_FALSE(exists("out/sweep.csv"));
  EXPECT_TRUE(fixtures::contains(said_, "paper_1d: finished: reached the end time 1 s")) << said_;
}

TEST_F(RunOfflineTest, AFailedRunGives1AndStillItsFolder) {
  EXPECT_EQ(offline({"--set", "run.start_speed_kmph=0", "--set", "run.stall.for_s=2", "--set",
                     "driver.notches=[[0, 1]]", "--set", "track.grades.0.grade_permille=50"}),
            1);
  EXPECT_TRUE(fixtures::contains(read("out/outcome.yaml"), "outcome: failed"));
  EXPECT_TRUE(fixtures::contains(said_, "failed:")) << said_;
}

TEST_F(RunOfflineTest, ALocomotiveThatCannotStandAtItsStartFailsTheRunWithWheelCauseAndPlace) {
  EXPECT_EQ(
      offline({"--set", "locomotive_model=3d", "--set",
               "adhesion_file=" + std::string(CONFIG_DIR) + "/adhesion/paper_table1.yaml", "--set",
               "control_file=" + std::string(CONFIG_DIR) + "/control/pi_per_axle.yaml", "--set",
               "train.groups.0.count=1", "--set", "run.start_location_km=3.45", "--set", "run.start_speed_kmph=126",
               "--set", "output.report_locations_km=[3.5]", "--set", "output.section_boundaries_km=[3.45, 3.5]"}),
      1)
      << complained_;
  EXPECT_TRUE(fixtures::contains(read("out/outcome.yaml"), "outcome: failed"));
  EXPECT_TRUE(fixtures::contains(
      read("out/outcome.yaml"),
      "loco_1: cannot start at 3.450000 km with 35 m/s: wheelset 1, left wheel, at 3.458496 km: wheel lift, no "
      "contact with its rail in step 0 at 3.450 km"))
      << read("out/outcome.yaml");
}

TEST_F(RunOfflineTest, RefusedInputGives2AndNothingIsWritten) {
  EXPECT_EQ(offline({"--set", "steps.macro_step_s=0.02", "--set", "run.end_location_km=99"}), 2);
  EXPECT_TRUE(fixtures::contains(complained_, "steps.macro_step_s = 0.02: must be below"));
  EXPECT_TRUE(fixtures::contains(complained_, "run.end_location_km = 99: "));
  EXPECT_EQ(offline({"--set", "stepps.macro_step_s=1"}), 2);
  EXPECT_TRUE(fixtures::contains(complained_, "stepps")) << complained_;
  EXPECT_EQ(offline({"--frobnicate"}), 2);
  EXPECT_TRUE(fixtures::contains(complained_, "usage: ltd_offline")) << complained_;
  EXPECT_FALSE(exists("out"));
}

TEST_F(RunOfflineTest, ARefusedRunDoesNotLeaveTheOutcomeOfTheOneBeforeAsItsOwn) {
  ASSERT_EQ(offline({"--set", "run.end_time_s=1"}), 0);
  EXPECT_EQ(offline({"--set", "run.end_location_km=99"}), 2);
  EXPECT_TRUE(fixtures::contains(read("out/outcome.yaml"), "outcome: refused"));
  EXPECT_TRUE(fixtures::contains(read("out/outcome.yaml"), "run.end_location_km = 99: "));
  EXPECT_TRUE(fixtures::contains(read("out/outcome.before.yaml"), "outcome: finished"));
}

TEST_F(RunOfflineTest, AFolderThatCannotBeWrittenGives1) {
  write("out", "a file");
  EXPECT_EQ(offline({"--set", "run.end_time_s=1"}), 1);
  EXPECT_TRUE(fixtures::contains(complained_, "cannot be made"));
}

TEST_F(RunOfflineTest, ASweepHasAFolderAndARowForEveryCombination) {
  EXPECT_EQ(offline({"--set", "run.end_time_s=1,2", "--set", "train.groups.0.count=1,2,3", "--set",
                     "driver.notches=[[0, 8]]"}),
            0);
  const auto rows = cells("out/sweep.csv");
  ASSERT_EQ(rows.size(), 7u);
  EXPECT_EQ(Words(rows[0].begin(), rows[0].begin() + 5),
            (Words{"run", "train.groups.1.count", "run.end_time_s", "train.groups.0.count", "driver.notches"}));
  const char* const names[] = {"001", "002", "003", "004", "005", "006"};
  const char* const times[] = {"1", "1", "1", "2", "2", "2"};
  const char* const locos[] = {"1", "2", "3", "1", "2", "3"};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(Words(rows[i + 1].begin(), rows[i + 1].begin() + 4), (Words{names[i], "3", times[i], locos[i]}));
    EXPECT_TRUE(exists(std::string("out/") + names[i] + "/outcome.yaml"));
  }
  // The list is one quoted cell of CSV, two for this test's simple splitting; then outcome and final time.
  EXPECT_EQ(rows[1][4] + "," + rows[1][5], "\"[[0, 8]]\"");
  EXPECT_EQ(rows[6][6] + " " + rows[6][7], "finished 2");
}

TEST_F(RunOfflineTest, ASweepInWhichARunFailsGives1AndGoesOn) {
  EXPECT_EQ(offline({"--set", "driver.notches=[[0, 0]]", "--set", "run.end_location_km=3.01", "--set",
                     "track.grades.0.grade_permille=50,0"}),
            1);
  const auto rows = cells("out/sweep.csv");
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[1][6], "failed");  // it rolled back off the track
  EXPECT_EQ(rows[2][6], "finished");
}

TEST_F(RunOfflineTest, ASweepIsAnnouncedBeforeItsValuesAreRefused) {
  EXPECT_EQ(offline({"--set", "train.groups.0.vehicle.adhesion_limit=0,25"}), 2);
  EXPECT_TRUE(fixtures::contains(said_, "2 runs, one for each combination")) << said_;
  EXPECT_TRUE(fixtures::contains(said_, "  train.groups.0.vehicle.adhesion_limit = 0  |  25")) << said_;
  EXPECT_TRUE(fixtures::contains(complained_, "if one number was meant, write 0.25")) << complained_;
}

/// After one step on 3 permille it rolls back with 0.05 mm/s.
TEST_F(RunOfflineTest, ATrainThatAllButStandsHasNoNegativeSpeed) {
  EXPECT_EQ(offline({"--set", "run.end_time_s=0.002", "--set", "run.start_speed_kmph=0", "--set",
                     "driver.notches=[[0, 0]]", "--set", "track.grades.0.grade_permille=3"}),
            0);
  EXPECT_TRUE(fixtures::contains(said_, "time 0.002 s, speed 0.000 km/h")) << said_;
  const auto rows = cells("out/summary.csv");
  EXPECT_TRUE(std::any_of(rows.begin(), rows.end(),
                          [](const Words& row) { return row[2] == "final_speed" && row.back()[0] == '-'; }));
}

TEST(ProgressTest, IsOneLineWithoutNegativeZeros) {
  EXPECT_EQ(toString(ltd::Progress{96.26, 3412.4, 6.61, 8, 41.234, 12.4}),
            "3.412 km  96.3 s  23.8 km/h  notch 8  41.23 x real time  12 s left");
  EXPECT_EQ(toString(ltd::Progress{0.0, -0.2, -1e-9, 0, 0.5, -1.0}),
            "0.000 km  0.0 s  0.0 km/h  notch 0  0.5 x real time");
}

TEST_F(RunOfflineTest, ASweepIsRefusedAsAWholeBeforeItsFirstRun) {
  EXPECT_EQ(offline({"--set", "run.end_time_s=1,-2"}), 2);
  EXPECT_FALSE(exists("out"));
}

TEST_F(RunOfflineTest, RunsInOneProcessAndInAnotherSweepHaveTheSameBits) {
  ASSERT_EQ(offline({"--set", "run.end_time_s=1"}), 0);
  const std::string alone = read("out/outcome.yaml");
  ASSERT_EQ(offline({"--set", "run.end_time_s=2,1"}), 0);
  EXPECT_EQ(read("out/002/outcome.yaml"), alone);
}

/// Counts what it is told.
class Counter : public ltd::RunObserver {
 public:
  explicit Counter(int& steps) : steps_(steps) {}
  void onStep(const ltd::StepRecord&) override { ++steps_; }

 private:
  int& steps_;
};

TEST_F(RunOfflineTest, TheBagFactoryMakesAnObserverForEachRunUnlessToldNotTo) {
  int steps = 0;
  Words folders;
  const ltd::BagFactory factory = [&](const ltd::Scenario&, const std::string& folder) {
    folders.push_back(folder);
    return std::make_unique<Counter>(steps);
  };
  Words words = {kPaper, "--out", path("out"), "--set", "train.groups.1.count=3", "--set", "run.end_time_s=1,2"};
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(ltd::runOffline(words, factory), 0);
  EXPECT_EQ(folders, (Words{path("out/001"), path("out/002")}));
  EXPECT_EQ(steps, 1500);
  words.push_back("--no-bag");
  EXPECT_EQ(ltd::runOffline(words, factory), 0);
  ::testing::internal::GetCapturedStdout();
  EXPECT_EQ(steps, 1500);
}

TEST_F(RunOfflineTest, ASweepsRunsBesideEachOtherLeaveTheSameRowsInTheSameOrder) {
  const Words sweep = {"--set", "run.end_time_s=9,1,5,2,7,3"};
  EXPECT_EQ(offline(sweep), 0);
  const std::string alone = read("out/sweep.csv"), alone_said = said_;
  std::filesystem::remove_all(path("out"));
  Words beside = sweep;
  beside.insert(beside.end(), {"--jobs", "3"});
  EXPECT_EQ(offline(beside), 0);
  EXPECT_EQ(read("out/sweep.csv"), alone);
  EXPECT_EQ(said_, alone_said);
}

TEST_F(RunOfflineTest, WhatIsWrongWithARunBesideOthersIsTold) {
  std::filesystem::create_directories(path("out"));
  write("out/002", "a file");
  EXPECT_EQ(offline({"--set", "run.end_time_s=1,2,3,4", "--jobs", "2"}), 1);
  EXPECT_TRUE(fixtures::contains(complained_, "002")) << complained_;
}

}  // namespace
