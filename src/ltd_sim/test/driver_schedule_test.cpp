#include "driver_reading.hpp"

namespace {

using drivers::commandAt;
using drivers::expectFault;
using drivers::read;
using drivers::table;
using ltd::DriverCommand;

const std::string kAll =
    "over: time\nnotches: [[0, 3], [20, 0]]\nbrake_notches: [[25, 4], [60, 0]]\npipe_bar: [[30, 4.5], [50, 5]]\n"
    "independent_brake: [[70, 0.25]]\nsanding: [[5, 1], [8, 0]]\nemergency_from: 90\n";

TEST(DriverScheduleTest, CommandsAreTheDefaultBeforeAnyEntry) {
  const DriverCommand command = commandAt(read("over: time\npipe_bar: [[1, 4.5]]\n"), 0.999);
  EXPECT_TRUE(command == DriverCommand{});
  EXPECT_EQ(command.pipe_pressure_Pa, 5.0e5);
}

TEST(DriverScheduleTest, EachChannelHoldsUntilItsOwnNextEntry) {
  const ltd::Driver driver = read(kAll);
  EXPECT_TRUE(commandAt(driver, 4.0) == (DriverCommand{3, 0, 5.0e5, 0.0, false, false}));
  EXPECT_TRUE(commandAt(driver, 5.0) == (DriverCommand{3, 0, 5.0e5, 0.0, false, true}));
  EXPECT_TRUE(commandAt(driver, 8.0) == (DriverCommand{3, 0, 5.0e5, 0.0, false, false}));
  EXPECT_TRUE(commandAt(driver, 24.9) == (DriverCommand{0, 0, 5.0e5, 0.0, false, false}));
  EXPECT_TRUE(commandAt(driver, 40.0) == (DriverCommand{0, 4, 4.5e5, 0.0, false, false}));
  EXPECT_TRUE(commandAt(driver, 75.0) == (DriverCommand{0, 0, 5.0e5, 0.25, false, false}));
  EXPECT_TRUE(commandAt(driver, 90.0) == (DriverCommand{0, 0, 5.0e5, 0.25, true, false}));
}

TEST(DriverScheduleTest, KindScheduleIsWhatAnAbsentKindMeans) {
  EXPECT_EQ(commandAt(read("kind: schedule\nover: time\nnotches: [[0, 3]]\n"), 0.0).notch, 3);
  expectFault("kind: schedul\nover: time\nnotches: [[0, 3]]\n", {"kind = schedul", "recorder, timetable, external"});
}

TEST(DriverScheduleTest, OverPlaceEveryChannelIsInKilometres) {
  const ltd::Driver driver = read("over: place\npipe_bar: [[3.5, 4.2]]\nemergency_from: 4\n");
  EXPECT_EQ(commandAt(driver, 0.0, 3499.9).pipe_pressure_Pa, 5.0e5);
  EXPECT_EQ(commandAt(driver, 0.0, 3500.0).pipe_pressure_Pa, 4.2e5);
  EXPECT_FALSE(commandAt(driver, 0.0, 3999.9).emergency);
  EXPECT_TRUE(commandAt(driver, 0.0, 4000.0).emergency);
}

TEST(DriverScheduleTest, ATableHoldsAnyOfTheColumns) {
  const ltd::Driver driver =
      read("over: place\n" + table("table", {"location_km,pipe_bar,brake_notch,sanding", "1.0,5,0,1", "1.2,4.5,6,0"}));
  EXPECT_TRUE(commandAt(driver, 0.0, 1100.0) == (DriverCommand{0, 0, 5.0e5, 0.0, false, true}));
  EXPECT_TRUE(commandAt(driver, 0.0, 1200.0) == (DriverCommand{0, 6, 4.5e5, 0.0, false, false}));
}

TEST(DriverScheduleReadTest, RefusesWhatIsBeyondItsRange) {
  const std::string begin = "over: time\n";
  expectFault(begin + "brake_notches: [[0, 9]]\n", {"brake_notches.0.1 = 9", "whole brake notch from 0 to 8"});
  expectFault(begin + "brake_notches: [[0, 1.5]]\n", {"brake_notches.0.1 = 1.5", "whole brake notch"});
  expectFault(begin + "pipe_bar: [[0, 5.01]]\n", {"pipe_bar.0.1 = 5.01", "0 to 5 bar"});
  expectFault(begin + "pipe_bar: [[0, 5], [3, -0.1]]\n", {"pipe_bar.1.1 = -0.1", "0 to 5 bar"});
  expectFault(begin + "independent_brake: [[0, 1.1]]\n", {"independent_brake.0.1 = 1.1", "share from 0 to 1"});
  expectFault(begin + "sanding: [[0, 0.5]]\n", {"sanding.0.1 = 0.5", "0 or 1"});
  expectFault(begin + "sanding: [[3, 1], [3, 0]]\n", {"sanding.1.0 = 3", "after the entry before"});
  expectFault(begin + "sanding: []\n", {"sanding", "at least one entry [from, sanding]"});
  expectFault(begin + "emergency_from: now\n", {"emergency_from = now", "number"});
}

TEST(DriverScheduleReadTest, RefusesANotchAndABrakeNotchAtOnceWhereverTheyMeet) {
  expectFault("over: time\nnotches: [[0, 3], [20, 0]]\nbrake_notches: [[19, 4]]\n",
              {"brake_notches.0.1 = 4", "must be 0 while notch is 3", "never both"});
  expectFault("over: time\nnotches: [[0, 0], [30, 2]]\nbrake_notches: [[10, 4], [40, 0]]\n",
              {"notches.1.1 = 2", "must be 0 while brake_notch is 4"});
  expectFault("over: time\n" + table("table", {"time_s,notch,brake_notch", "0,3,0", "9,3,1"}),
              {"line 3: brake_notch = 1", "must be 0 while notch is 3"});
}

TEST(DriverScheduleReadTest, RefusesABadTableWithTheLineNumber) {
  const std::string begin = "over: time\n";
  expectFault(begin + table("table", {"time_s,notch,pipe_bar", "0,1,5", "0,2,5"}), {"line 3: time_s = 0", "after"});
  expectFault(begin + table("table", {"time_s,notch,pipe_bar", "0,1,6"}), {"line 2: pipe_bar = 6", "0 to 5 bar"});
  expectFault(begin + table("table", {"time_s,notch,brake_notsh", "0,1,5"}),
              {"line 1", "unknown column 'brake_notsh', did you mean 'brake_notch'"});
  expectFault(begin + table("table", {"location_km,notch", "0,1"}), {"line 1", "must be 'time_s'"});
  expectFault(begin + table("table", {"# a comment", "time_s,brake_notsh", "0,1"}), {"line 2", "brake_notsh"});
  expectFault(begin + table("table", {"time_s", "0"}), {"line 1", "must have a column beside the first"});
  expectFault(begin + table("table", {"time_s,notch", "0,1"}) + "sanding: [[0, 1]]\n", {"sanding", "beside table"});
  expectFault(begin + table("table", {"time_s,notch", "0,1"}) + table("notches_table", {"time_s,notch", "0,1"}),
              {"notches_table", "beside table"});
}

}  // namespace
