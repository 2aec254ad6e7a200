#include "panels/lock_state.hpp"

#include <gtest/gtest.h>
#include <train_msgs/TrainStatus.h>

namespace viz {
namespace {

using Phase = TrainStatus::Phase;

TrainStatus inPhase(Phase phase) {
  TrainStatus status;
  status.phase = phase;
  return status;
}

TEST(LockStateTest, PhasesAreThoseOfTheMessage) {
  using Msg = train_msgs::TrainStatus;
  EXPECT_EQ(static_cast<int>(Phase::kJoining), Msg::JOINING);
  EXPECT_EQ(static_cast<int>(Phase::kHeld), Msg::HELD);
  EXPECT_EQ(static_cast<int>(Phase::kRunning), Msg::RUNNING);
  EXPECT_EQ(static_cast<int>(Phase::kFinished), Msg::FINISHED);
  EXPECT_EQ(static_cast<int>(Phase::kStopped), Msg::STOPPED);
  EXPECT_EQ(static_cast<int>(Phase::kFailed), Msg::FAILED);
}

TEST(LockStateTest, NothingIsAllowedWithoutATrain) {
  for (const AllowedCommands& a :
       {allowedCommands(std::nullopt, 0.0, false), allowedCommands(inPhase(Phase::kRunning), 10.0, false),
        allowedCommands(inPhase(Phase::kRunning), 0.0, true), allowedCommands(inPhase(Phase::kFinished), 0.0, false),
        allowedCommands(inPhase(Phase::kStopped), 0.0, false), allowedCommands(inPhase(Phase::kFailed), 0.0, false),
        allowedCommands(inPhase(static_cast<Phase>(99)), 0.0, false)}) {
    EXPECT_FALSE(a.hold || a.run || a.pace || a.stop);
  }
}

TEST(LockStateTest, AHeldTrainCanDoAllButHold) {
  const AllowedCommands held = allowedCommands(inPhase(Phase::kHeld), 1.0, false);
  EXPECT_FALSE(held.hold);
  EXPECT_TRUE(held.run && held.pace && held.stop);
  for (const Phase phase : {Phase::kRunning, Phase::kJoining}) {
    const AllowedCommands a = allowedCommands(inPhase(phase), 1.0, false);
    EXPECT_TRUE(a.hold && a.run && a.pace && a.stop);
  }
}

TEST(LockStateTest, FiguresHaveTheirUnits) {
  TrainStatus status;
  status.time_s = 12.5;
  status.place_m = 3456.78;
  status.real_time_factor = 31.44;
  status.time_left_s = 75.4;
  status.joined = {true, false, true, false};
  const StatusWords words = describe(status);
  EXPECT_EQ(words.time, "12.500 s");
  EXPECT_EQ(words.place, "3.4568 km");
  EXPECT_EQ(words.real_time_factor, "31.4 times real time");
  EXPECT_EQ(words.time_left, "1 min 15 s");
  EXPECT_EQ(words.joined, "2 of 4, not 2, 4");
}

TEST(LockStateTest, TimeLeftIsNotKnownOrReadable) {
  TrainStatus status;
  EXPECT_EQ(describe(status).time_left, "not known");
  status.time_left_s = 59.4;
  EXPECT_EQ(describe(status).time_left, "59 s");
  status.time_left_s = 59.6;
  EXPECT_EQ(describe(status).time_left, "1 min 0 s");
  status.time_left_s = 7260.0;
  EXPECT_EQ(describe(status).time_left, "2 h 1 min");
}

TEST(LockStateTest, ARunThatHasEndedHasNoTimeLeft) {
  for (const Phase phase : {Phase::kFinished, Phase::kStopped, Phase::kFailed}) {
    TrainStatus status = inPhase(phase);
    EXPECT_EQ(describe(status).time_left, "ended");
    status.time_left_s = 12.0;
    EXPECT_EQ(describe(status).time_left, "ended");
  }
}

TEST(LockStateTest, SaysThatATrainIsSilentUnlessItHasEnded) {
  EXPECT_EQ(phaseWords(std::nullopt, 0.0), "nothing heard of it");
  TrainStatus status;
  status.phase = TrainStatus::Phase::kRunning;
  EXPECT_EQ(phaseWords(status, 1.0), "runs");
  EXPECT_EQ(phaseWords(status, 12.3), "runs (silent for 12 s)");
  status.phase = TrainStatus::Phase::kFinished;
  EXPECT_EQ(phaseWords(status, 12.3), "finished");
}

}  // namespace
}  // namespace viz
