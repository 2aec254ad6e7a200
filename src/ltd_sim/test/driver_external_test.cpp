#include "driver_reading.hpp"

namespace {

using drivers::expectFault;
using drivers::kSecond;
using drivers::kStep;
using drivers::viewAt;
using ltd::DriverCommand;

const std::string kExternal = "kind: external\nperiod_s: 0.5\nanswer_deadline_s: 3\non_silence: {pipe_bar: 3.5}\n";

TEST(DriverExternalTest, AsksEveryPeriodAndHoldsTheAnswerBetween) {
  const ltd::Driver driver = drivers::read(kExternal);
  ltd::Driver::State state;
  std::vector<int> notches;
  int questions = 0;
  for (rail::Nanoseconds t = 0; t <= kSecond; t += kStep) {
    if (driver.asksAt(t)) {
      DriverCommand answer;
      answer.notch = ++questions;
      EXPECT_EQ(driver.give(answer, state), "");
    }
    driver.command(viewAt(t, 0.0), state);
    if (t == 0 || t == kSecond / 2 - kStep || t == kSecond / 2 || t == kSecond)
      notches.push_back(driver.lead(state).notch);
  }
  EXPECT_EQ(questions, 3);
  EXPECT_EQ(notches, (std::vector<int>{1, 1, 2, 3}));
}

TEST(DriverExternalTest, SilenceIsWhatTheUserSaidWithTractionOff) {
  const ltd::Driver driver = drivers::read(kExternal);
  ltd::Driver::State state;
  DriverCommand answer;
  answer.notch = 5;
  EXPECT_EQ(driver.give(answer, state), "");
  driver.command(viewAt(0, 0.0), state);
  driver.giveSilence(state);
  driver.command(viewAt(kSecond / 2, 0.0), state);
  EXPECT_TRUE(driver.lead(state) == (DriverCommand{0, 0, 3.5e5, 0.0, false, false}));
  EXPECT_EQ(driver.external()->answer_deadline_s, 3.0);
}

TEST(DriverExternalTest, ARefusedAnswerIsNamedAndChangesNothing) {
  const ltd::Driver driver = drivers::read(kExternal);
  ltd::Driver::State state;
  const auto refusal = [&](const DriverCommand& answer) { return driver.give(answer, state); };
  EXPECT_EQ(refusal({9, 0, 5.0e5, 0.0, false, false}), "notch = 9: must be 0 to 8");
  EXPECT_EQ(refusal({0, -1, 5.0e5, 0.0, false, false}), "brake_notch = -1: must be 0 to 8");
  EXPECT_EQ(refusal({1, 1, 5.0e5, 0.0, false, false}), "brake_notch = 1: must be 0 beside a notch: never both at once");
  EXPECT_TRUE(fixtures::contains(refusal({0, 0, std::nan(""), 0.0, false, false}),
                                 "pipe_pressure = nan: must be 0 to 500000 Pa"));
  EXPECT_TRUE(fixtures::contains(refusal({0, 0, 6.0e5, 0.0, false, false}), "pipe_pressure = 600000: "));
  EXPECT_TRUE(fixtures::contains(refusal({0, 0, 5.0e5, 1.5, false, false}), "independent_brake = 1.5: must be 0 to 1"));
  EXPECT_TRUE(state.given == DriverCommand{});
}

/// Answers notch 1 to the first questions and then nothing.
class MutePort : public ltd::DriverPort {
 public:
  explicit MutePort(int answers, double pipe_Pa = ltd::kChargedPipe_Pa) : answers_(answers) {
    command_.pipe_pressure_Pa = pipe_Pa;
  }
  void ask(std::uint64_t, const ltd::DriverView&) override { ++asked_; }
  const DriverCommand* answer() override { return asked_ <= answers_ && refused_.empty() ? &command_ : nullptr; }
  void refuse(const std::string& why) override { refused_ = why; }
  double deadline_s() const override { return asked_ > 1 ? 3.0 : 60.0; }
  bool silent() override { return true; }

 private:
  int answers_, asked_ = 0;
  std::string refused_;
  DriverCommand command_{1, 0, ltd::kChargedPipe_Pa, 0.0, false, false};
};

std::vector<std::string> notesOfASilentDriver(int answers, double pipe_Pa = ltd::kChargedPipe_Pa) {
  ltd::Scenario scenario = fixtures::makeScenario(
      fixtures::makeTrain({fixtures::paperLoco(), fixtures::paperWagon()}, {0}, fixtures::draftGear()),
      fixtures::makeTrack(), drivers::read(kExternal));
  scenario.run.end_time = 2 * kSecond;
  fixtures::Fleet fleet(scenario);
  MutePort port(answers, pipe_Pa);
  ltd::Cosimulation cosimulation(scenario, fleet.ports, {}, &port);
  fixtures::runToEnd(cosimulation);
  EXPECT_EQ(cosimulation.state().driver.lead.notch, 0);
  EXPECT_EQ(cosimulation.state().driver.lead.pipe_pressure_Pa, 3.5e5);
  return cosimulation.outcome().notes;
}

TEST(DriverExternalTest, OfASilentDriverTheQuestionIsToldAndTheDeadlineThatHeldForIt) {
  const std::vector<std::string> never = notesOfASilentDriver(0), later = notesOfASilentDriver(2);
  ASSERT_EQ(never.size(), 1u);
  ASSERT_EQ(later.size(), 1u);
  EXPECT_TRUE(fixtures::contains(never[0], "no answer within 60 s to the question of 0.000 s")) << never[0];
  EXPECT_TRUE(fixtures::contains(later[0], "no answer within 3 s to the question of 1.000 s")) << later[0];
}

TEST(DriverExternalTest, ARefusedAnswerIsNotedWithItsFieldInTheOutcome) {
  const std::vector<std::string> notes = notesOfASilentDriver(3, 6.0e5);
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_EQ(notes[0],
            "driver: answer to the question of 0.000 s refused: pipe_pressure = 600000: must be 0 to 500000 Pa");
  EXPECT_TRUE(fixtures::contains(notes[1], "no answer within ")) << notes[1];
}

TEST(DriverExternalReadTest, RefusesAPeriodThatIsNoMultipleOfTheMacroStepAndOtherFaults) {
  const std::string rest = "answer_deadline_s: 3\non_silence: {pipe_bar: 3.5}\n";
  expectFault("kind: external\nperiod_s: 0.003\n" + rest, {"period_s = 0.003", "multiple of steps.macro_step_s"});
  expectFault("kind: external\nperiod_s: 0\n" + rest, {"period_s = 0", "> 0"});
  expectFault("kind: external\nperiod_s: 1\nanswer_deadline_s: 3\n", {"on_silence", "is missing"});
  expectFault("kind: external\nperiod_s: 1\nanswer_deadline_s: 3\non_silence: {notch: 3}\n",
              {"on_silence.notch", "unknown key"});
  expectFault("kind: external\nperiod_s: 1\nanswer_deadline_s: 3\non_silence: {pipe_bar: 6}\n",
              {"on_silence.pipe_bar = 6", "<= 5"});
}

}  // namespace
