#include "ltd_sim/run_control.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using ltd::RunControl;

constexpr rail::Nanoseconds kStep = 2000000;  // 2 ms

RunControl::Situation at(std::uint64_t step, double location_m = 3000.0) {
  return {step, static_cast<rail::Nanoseconds>(step) * kStep, location_m};
}

TEST(RunControlTest, StartsAsToldAndRunsAfterRun) {
  EXPECT_TRUE(RunControl(false).mayBegin(at(0), 0.0));
  RunControl control(true);
  EXPECT_FALSE(control.mayBegin(at(0), 0.0));
  EXPECT_TRUE(control.held());
  EXPECT_TRUE(control.request("RUN", 0.0, at(0), 0.0).accepted);
  EXPECT_TRUE(control.mayBegin(at(0), 0.0));
}

TEST(RunControlTest, StepRunsThatManyStepsThenHolds) {
  RunControl control(true);
  ASSERT_TRUE(control.request("STEP", 10.0, at(5), 0.0).accepted);
  std::uint64_t step = 5;
  while (control.mayBegin(at(step), 0.0)) ++step;
  EXPECT_EQ(step, 15u);
  EXPECT_TRUE(control.held());
}

TEST(RunControlTest, RunUntilTimeHoldsAtTheFirstStepThatBeginsThenOrLater) {
  RunControl control(true);
  ASSERT_TRUE(control.request("RUN_UNTIL_TIME", 0.0105, at(0), 0.0).accepted);
  std::uint64_t step = 0;
  while (control.mayBegin(at(step), 0.0)) ++step;
  EXPECT_EQ(step, 6u);  // 12 ms is the first multiple of 2 ms from 10.5 ms on
}

TEST(RunControlTest, RunUntilPlaceHoldsOnceTheLeadingLocomotiveIsThere) {
  RunControl control(true);
  ASSERT_TRUE(control.request("RUN_UNTIL_PLACE", 3.3, at(0), 0.0).accepted);
  EXPECT_TRUE(control.mayBegin(at(1, 3299.999), 0.0));
  EXPECT_FALSE(control.mayBegin(at(2, 3300.0), 0.0));
  EXPECT_TRUE(control.held());
}

TEST(RunControlTest, RefusesWhatIsPassedOrImpossibleAndGoesOnAsBefore) {
  RunControl control(false);
  EXPECT_FALSE(control.request("RUN_UNTIL_PLACE", 3.0, at(0, 3000.0), 0.0).accepted);
  EXPECT_FALSE(control.request("RUN_UNTIL_PLACE", std::nan(""), at(0), 0.0).accepted);
  EXPECT_FALSE(control.request("RUN_UNTIL_TIME", 0.01, at(5), 0.0).accepted);
  EXPECT_FALSE(control.request("RUN_UNTIL_TIME", std::nan(""), at(0), 0.0).accepted);
  EXPECT_FALSE(control.request("STEP", 0.0, at(0), 0.0).accepted);
  EXPECT_FALSE(control.request("STEP", 1.5, at(0), 0.0).accepted);
  EXPECT_FALSE(control.request("STEP", -3.0, at(0), 0.0).accepted);
  EXPECT_FALSE(control.request("STEP", 1e30, at(0), 0.0).accepted);
  EXPECT_FALSE(control.request("PACE", -1.0, at(0), 0.0).accepted);
  EXPECT_FALSE(control.request("step", 1.0, at(0), 0.0).accepted);
  EXPECT_TRUE(control.mayBegin(at(0), 0.0));
}

TEST(RunControlTest, RefusesTargetsBeyondTheScenariosEndWhereItWouldNeverHold) {
  RunControl control(false);
  RunControl::Situation now = at(0);
  now.end_time = 10 * rail::kNanosecondsPerSecond;
  now.end_location_m = 4500.0;
  EXPECT_FALSE(control.request("RUN_UNTIL_PLACE", 4.501, now, 0.0).accepted);
  EXPECT_TRUE(control.request("RUN_UNTIL_PLACE", 4.5, now, 0.0).accepted);
  EXPECT_FALSE(control.request("RUN_UNTIL_TIME", 10.1, now, 0.0).accepted);
  EXPECT_TRUE(control.request("RUN_UNTIL_TIME", 10.0, now, 0.0).accepted);
}

TEST(RunControlTest, AnUnknownCommandIsAnsweredWithTheListOfThoseThatExist) {
  RunControl control(false);
  EXPECT_NE(control.request("GO", 0.0, at(0), 0.0).message.find("RUN_UNTIL_PLACE"), std::string::npos);
}

TEST(RunControlTest, HoldAndStopActBeforeTheNextStep) {
  RunControl control(false);
  EXPECT_TRUE(control.request("HOLD", 0.0, at(3), 0.0).accepted);
  EXPECT_FALSE(control.mayBegin(at(3), 0.0));
  EXPECT_TRUE(control.request("STOP", 0.0, at(3), 0.0).accepted);
  EXPECT_TRUE(control.stopRequested());
  EXPECT_FALSE(control.request("RUN", 0.0, at(3), 0.0).accepted);
}

TEST(RunControlTest, PaceLetsSimulationTimeNotOutrunWallTime) {
  RunControl control(false);
  ASSERT_TRUE(control.request("PACE", 2.0, at(100), 50.0).accepted);
  EXPECT_TRUE(control.mayBegin(at(100), 50.0));
  EXPECT_FALSE(control.mayBegin(at(600), 50.4));            // 1 s simulated is due 0.5 s later
  EXPECT_NEAR(control.paceWait(at(600), 50.4), 0.1, 1e-9);  // 50 + 1/2 - 50.4, round-off of the wall clock
  EXPECT_TRUE(control.mayBegin(at(600), 50.5 + 1e-9));
  ASSERT_TRUE(control.request("PACE", 0.0, at(600), 50.5).accepted);
  EXPECT_TRUE(control.mayBegin(at(100000), 50.5));
}

TEST(RunControlTest, TimeLostToWaitingIsNotCaughtUpByThePace) {
  RunControl control(false);
  ASSERT_TRUE(control.request("PACE", 1.0, at(0), 0.0).accepted);
  EXPECT_TRUE(control.mayBegin(at(1), 60.0));     // a locomotive joined a minute late
  EXPECT_FALSE(control.mayBegin(at(501), 60.5));  // 1 s further on is due at 61 s
  EXPECT_TRUE(control.mayBegin(at(501), 61.0 + 1e-9));
}

TEST(RunControlTest, TimeSpentHeldIsNotCaughtUpByThePace) {
  RunControl control(false);
  ASSERT_TRUE(control.request("PACE", 1.0, at(0), 0.0).accepted);
  control.request("HOLD", 0.0, at(500), 1.0);
  control.request("RUN", 0.0, at(500), 100.0);
  EXPECT_FALSE(control.mayBegin(at(1000), 100.5));
  EXPECT_TRUE(control.mayBegin(at(1000), 101.0 + 1e-9));
}

}  // namespace
