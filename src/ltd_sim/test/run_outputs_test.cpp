#include "ltd_sim/run_outputs.hpp"

#include <yaml-cpp/yaml.h>

#include <stdexcept>

#include "scratch_directory.hpp"
#include "train_fixtures.hpp"

namespace {

const std::string kPaper = std::string(CONFIG_DIR) + "/scenarios/paper_1d.yaml";

class RunOutputsTest : public fixtures::ScratchDirectory {};

TEST_F(RunOutputsTest, LeavesAllFilesOfARunAndItsOutcomeLast) {
  const ltd::Scenario scenario = ltd::Scenario::load(kPaper, {{"run.end_time_s", "2"}, {"train.groups.1.count", "5"}});
  fixtures::FinishedRun end;
  {
    ltd::RunOutputs outputs(scenario, path("a/run"));
    EXPECT_FALSE(std::filesystem::exists(path("a/run/outcome.yaml")));
    end = fixtures::run(scenario, {&outputs});
  }
  EXPECT_EQ(read("a/run/scenario.resolved.yaml"), scenario.document.text());
  EXPECT_GT(cells("a/run/summary.csv").size(), 10u);
  EXPECT_EQ(cells("a/run/timeseries.csv").size(), 22u);  // header, start and every 0.1 s of 2 s
  EXPECT_EQ(cells("a/run/energy_sections.csv").size(), 1u);

  const YAML::Node outcome = YAML::Load(read("a/run/outcome.yaml"));
  EXPECT_EQ(outcome["outcome"].as<std::string>(), "finished");
  EXPECT_EQ(outcome["reason"].as<std::string>(), "reached the end time 2 s");
  EXPECT_EQ(outcome["step"].as<std::uint64_t>(), 1000u);
  EXPECT_EQ(outcome["time_s"].as<double>(), 2.0);
  EXPECT_EQ(outcome["location_km"].as<double>(), end.state.s_m[0] / 1000.0);
  char digest[24];
  std::snprintf(digest, sizeof digest, "%016llx", static_cast<unsigned long long>(end.outcome.exchange_digest));
  EXPECT_EQ(outcome["exchange_digest"].as<std::string>(), digest);
}

TEST_F(RunOutputsTest, AnOutcomeOfAnEarlierRunIsGoneAsSoonAsANewOneBegins) {
  const ltd::Scenario scenario = ltd::Scenario::load(kPaper, {});
  write("run/outcome.yaml", "outcome: finished\n");
  ltd::RunOutputs outputs(scenario, path("run"));
  EXPECT_FALSE(std::filesystem::exists(path("run/outcome.yaml")));
}

TEST_F(RunOutputsTest, AFolderThatCannotBeMadeIsTold) {
  const ltd::Scenario scenario = ltd::Scenario::load(kPaper, {});
  write("file", "");
  EXPECT_THROW(ltd::RunOutputs(scenario, path("file/run")), std::runtime_error);
}

TEST_F(RunOutputsTest, AReasonWithQuotesAndLineEndsComesBackWhole) {
  ltd::Outcome outcome;
  outcome.kind = ltd::Outcome::Kind::kFailed;
  outcome.reason = "loco_2: \"left\": the\ntrack # here";
  outcome.exchange_digest = 0x12ab;
  ltd::writeOutcome(directory(), outcome, 0.1, 3.25, 50);
  const YAML::Node node = YAML::Load(read("outcome.yaml"));
  EXPECT_EQ(node["outcome"].as<std::string>(), "failed");
  EXPECT_EQ(node["reason"].as<std::string>(), outcome.reason);
  EXPECT_EQ(node["exchange_digest"].as<std::string>(), "00000000000012ab");
  EXPECT_EQ(node["time_s"].as<double>(), 0.1);
  EXPECT_FALSE(std::filesystem::exists(path("outcome.yaml.new")));
}

TEST(OutcomeTest, ExitStatusTellsHowItEnded) {
  ltd::Outcome outcome;
  EXPECT_FALSE(outcome.ended());
  EXPECT_EQ(toString(outcome.kind), "running");
  const struct {
    ltd::Outcome::Kind kind;
    int status;
    const char* word;
  } cases[] = {{ltd::Outcome::Kind::kFinished, 0, "finished"},
               {ltd::Outcome::Kind::kFailed, 1, "failed"},
               {ltd::Outcome::Kind::kStopped, 3, "stopped"}};
  for (const auto& expected : cases) {
    outcome.kind = expected.kind;
    EXPECT_TRUE(outcome.ended());
    EXPECT_EQ(outcome.exitStatus(), expected.status);
    EXPECT_EQ(toString(outcome.kind), expected.word);
  }
}

TEST_F(RunOutputsTest, ARefusalLeavesTheFilesOfTheLastRunAlone) {
  for (const char* name : {"outcome.yaml", "summary.csv", "timeseries.csv", "scenario.resolved.yaml"})
    write(std::string("run/") + name, name);
  ltd::writeRefusal(path("run"), ltd::Outcome::Kind::kRefused, "steps.macro_step_s = 1: must be below");
  const YAML::Node outcome = YAML::Load(read("run/outcome.yaml"));
  EXPECT_EQ(outcome["outcome"].as<std::string>(), "refused");
  EXPECT_EQ(outcome["reason"].as<std::string>(), "steps.macro_step_s = 1: must be below");
  EXPECT_EQ(read("run/outcome.before.yaml"), "outcome.yaml");
  for (const char* name : {"summary.csv", "timeseries.csv", "scenario.resolved.yaml"})
    EXPECT_EQ(read(std::string("run/") + name), name);
}

}  // namespace
