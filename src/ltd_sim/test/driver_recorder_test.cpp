#include "driver_reading.hpp"

namespace {

using drivers::commandAt;
using drivers::expectFault;
using drivers::read;
using drivers::table;

const std::string kColumns =
    "columns: {location_km: km, notch: notch, brake_notch: db, pipe_bar: pressure, speed_kmph: v}\n";

/// A recorder's file as it comes: more columns than are of use, one of them no number, standing rows at 12.5 km.
const std::vector<std::string> kRecording = {
    "clock,km,v,notch,db,pressure", "08:00:01,12.0,36,3,0,5", "08:00:31,12.3,54,0,4,4.5", "08:01:07,12.5,0,0,0,3.6",
    "08:02:00,12.5,0,0,0,5",        "08:02:10,12.5,0,2,0,5",  "08:03:00,13.0,36,5,0,5"};

std::string recorder(const std::vector<std::string>& lines) {
  return "kind: recorder\nover: place\n" + kColumns + table("recording", lines);
}

TEST(DriverRecorderTest, ReplaysItsColumnsOverPlaceUnderTheNamesOfTheFile) {
  const ltd::Driver driver = read(recorder(kRecording));
  EXPECT_TRUE(commandAt(driver, 0.0, 12000.0) == (ltd::DriverCommand{3, 0, 5.0e5, 0.0, false, false}));
  EXPECT_TRUE(commandAt(driver, 0.0, 12300.0) == (ltd::DriverCommand{0, 4, 4.5e5, 0.0, false, false}));
  EXPECT_TRUE(commandAt(driver, 0.0, 13000.0) == (ltd::DriverCommand{5, 0, 5.0e5, 0.0, false, false}));
}

TEST(DriverRecorderTest, OfStandingRowsTheLastHoldsWithWhichTheTrainLeft) {
  EXPECT_EQ(commandAt(read(recorder(kRecording)), 0.0, 12500.0).notch, 2);
}

TEST(DriverRecorderTest, OverTimeAStopKeepsItsWait) {
  const ltd::Driver driver =
      read("kind: recorder\nover: time\nstart_time_s: 100\ncolumns: {time_s: t, location_m: x, pipe_kPa: p}\n" +
           table("recording", {"t,x,p", "100,7,500", "110,8,360", "170,8,500"}));
  EXPECT_EQ(commandAt(driver, 9.0).pipe_pressure_Pa, 5.0e5);
  EXPECT_EQ(commandAt(driver, 10.0).pipe_pressure_Pa, 3.6e5);
  EXPECT_EQ(commandAt(driver, 69.0).pipe_pressure_Pa, 3.6e5);
  EXPECT_EQ(commandAt(driver, 70.0).pipe_pressure_Pa, 5.0e5);
}

TEST(DriverRecorderTest, TellsTheRecordedSpeedForComparison) {
  const ltd::Driver driver = read(recorder(kRecording));
  EXPECT_NEAR(driver.recordedSpeed(drivers::viewAt(0, 12150.0)).value(), 12.5, 1e-9);  // half-way from 36 to 54 km/h
  EXPECT_NEAR(driver.recordedSpeed(drivers::viewAt(0, 13000.0)).value(), 10.0, 1e-9);
  EXPECT_FALSE(driver.recordedSpeed(drivers::viewAt(0, 13000.1)));
  EXPECT_FALSE(driver.recordedSpeed(drivers::viewAt(0, 11999.9)));
  EXPECT_FALSE(read("over: time\nnotches: [[0, 1]]\n").recordedSpeed(drivers::viewAt(0, 0.0)));
}

TEST(DriverRecorderReadTest, RefusesABadRecordingWithTheLineNumber) {
  const std::string header = "km,v,notch,db,pressure";
  expectFault(recorder({header, "12,0,1,0,5", "11.9,0,1,0,5"}), {"line 3: km = 11.9", "not be behind the row before"});
  expectFault(recorder({header, "12,0,9,0,5"}), {"line 2: notch = 9", "whole notch from 0 to 8"});
  expectFault(recorder({header, "12,0,1,2,5"}), {"line 2: db = 2", "never both at once"});
  expectFault(recorder({header, "12,0,1,0,5.2"}), {"line 2: pressure = 5.2", "0 to 5 bar"});
  expectFault(recorder({header, "12,0,idle,0,5"}), {"line 2: notch = idle", "must be a number"});
  expectFault(recorder({"km,v,notch,pressure", "12,0,1,5"}), {"line 1", "column 'db' is missing"});
  const std::string time = "kind: recorder\nover: time\ncolumns: {time_s: t, notch: n}\n";
  expectFault(time + table("recording", {"t,n", "0,1", "0,2"}), {"line 3: t = 0", "after the entry before"});
}

/// Bars read as kilopascals would be a pipe all but empty: the train would brake from the start, and nobody be told
/// why.
TEST(DriverRecorderReadTest, RefusesAPipeInAnotherUnitOnce) {
  const auto pipe = [](const std::string& key, const std::vector<std::string>& lines) {
    return "kind: recorder\nover: time\ncolumns: {time_s: t, " + key + ": p}\n" + table("recording", lines);
  };
  expectFault(pipe("pipe_kPa", {"t,p", "0,5.0", "10,3.6", "20,0"}),
              {"p = 5: the largest value must be >= 20 kPa: are these bar? then the key is pipe_bar"});
  expectFault(pipe("pipe_kPa", {"t,p", "0,0", "10,0"}), {"p = 0: the largest value must be >= 20 kPa"});
  expectFault(pipe("pipe_bar", {"t,p", "0,500", "10,360"}),
              {"p = 500: the largest value must be <= 5 bar: are these kPa? then the key is pipe_kPa"});
  // A vented pipe may follow a charged one, and half a bar is one.
  const ltd::Driver vented = read(pipe("pipe_kPa", {"t,p", "0,500", "10,0", "20,3"}));
  EXPECT_EQ(commandAt(vented, 15.0).pipe_pressure_Pa, 0.0);
  EXPECT_EQ(commandAt(read(pipe("pipe_kPa", {"t,p", "0,20"})), 1.0).pipe_pressure_Pa, 2.0e4);
}

TEST(DriverRecorderReadTest, RefusesColumnsThatDoNotMakeADriver) {
  const std::string begin = "kind: recorder\nover: place\n";
  const std::string rest = table("recording", {"km,notch", "12,1"});
  expectFault(begin + "columns: {notch: notch}\n" + rest, {"columns.location_km", "is missing"});
  expectFault(begin + "columns: {location_km: km}\n" + rest, {"columns", "must name the column of a command"});
  expectFault(begin + "columns: {location_km: km, notch: notch, location_m: m}\n" + rest,
              {"columns.location_m = m", "beside location_km"});
  expectFault(begin + "columns: {location_km: km, notsh: notch, pipe_bar: p}\n" + rest, {"columns.notsh", "notch"});
  expectFault(begin + "start_time_s: 3\ncolumns: {location_km: km, notch: notch}\n" + rest,
              {"start_time_s = 3", "over: time only"});
}

}  // namespace
