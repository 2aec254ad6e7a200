#include "ltd_sim/command_limits.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using ltd::DriverCommand;
using Largest = ltd::DriverSchedule::Largest;

const Largest kAll = {8, 4, true, true};

DriverCommand withPipe(double pipe_Pa) {
  DriverCommand command;
  command.pipe_pressure_Pa = pipe_Pa;
  return command;
}
DriverCommand withIndependent(double share) {
  DriverCommand command;
  command.independent_brake = share;
  return command;
}

std::string refusal(const DriverCommand& command, const Largest& largest = kAll) {
  return ltd::refuseCommand(command, largest);
}

TEST(CommandLimitsTest, TheEndsOfEachRangeAreObeyed) {
  for (const Largest& largest : {kAll, Largest{8, 4, false, false}}) EXPECT_EQ(refusal({}, largest), "");
  EXPECT_EQ(refusal({8, 0, 0.0, 1.0, true, true}), "");
  EXPECT_EQ(refusal({0, 4, 5.0e5, 0.0, false, false}), "");
}

TEST(CommandLimitsTest, NotchesBeyondTheirRangeOrBothAtOnceAreNamed) {
  EXPECT_EQ(refusal({9, 0, 5.0e5, 0.0, false, false}), "notch = 9: must be 0 to 8");
  EXPECT_EQ(refusal({-1, 0, 5.0e5, 0.0, false, false}), "notch = -1: must be 0 to 8");
  EXPECT_EQ(refusal({0, 5, 5.0e5, 0.0, false, false}), "brake_notch = 5: must be 0 to 4");
  EXPECT_EQ(refusal({1, 1, 5.0e5, 0.0, false, false}), "brake_notch = 1: must be 0 beside a notch: never both at once");
}

TEST(CommandLimitsTest, AirBeyondItsRangeIsNamedAndSoIsANumberThatIsNone) {
  EXPECT_EQ(refusal(withPipe(5.1e5)), "pipe_pressure = 510000: must be 0 to 500000 Pa");
  EXPECT_NE(refusal(withPipe(-1.0)), "");
  EXPECT_NE(refusal(withPipe(std::nan(""))), "");
  EXPECT_EQ(refusal(withIndependent(1.1)), "independent_brake = 1.1: must be 0 to 1");
  EXPECT_NE(refusal(withIndependent(-0.1)), "");
  EXPECT_NE(refusal(withIndependent(std::nan(""))), "");
}

TEST(CommandLimitsTest, AnAirBrakeThatTheScenarioHasNotIsNotCommanded) {
  const Largest none = {8, 4, false, true};
  DriverCommand emergency;
  emergency.emergency = true;
  for (const DriverCommand& command : {withPipe(4.5e5), withIndependent(0.5), emergency})
    EXPECT_NE(refusal(command, none).find("the scenario must have an air_brake"), std::string::npos);
}

TEST(CommandLimitsTest, SandThatWouldChangeNothingIsNotLaid) {
  DriverCommand command;
  command.sanding = true;
  EXPECT_EQ(refusal(command), "");
  EXPECT_EQ(refusal(command, {8, 4, true, false}),
            "sanding = true: must be false: the scenario has no sanded_adhesion");
}

}  // namespace
