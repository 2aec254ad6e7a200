#include "point_train.hpp"

namespace {

const std::string kDrivers = std::string(CONFIG_DIR) + "/drivers/";

ltd::Driver load(const std::string& name) {
  rail::Problems problems;
  const rail::Document line = rail::Document::load(std::string(CONFIG_DIR) + "/tracks/rolling_line.yaml", {}, problems);
  const rail::Track track = rail::Track::read(rail::YamlReader(line, problems));
  const rail::Document document = rail::Document::load(kDrivers + name, {}, problems);
  ltd::Driver driver = ltd::Driver::read(rail::YamlReader(document, problems), {"lead"}, {8}, {8}, drivers::kStep,
                                         track, drivers::ability());
  for (const std::string& problem : problems.lines()) ADD_FAILURE() << problem;
  return driver;
}

TEST(DriverExamplesTest, TheScheduleCommandsEverything) {
  const ltd::Driver driver = load("brake_test.yaml");
  EXPECT_TRUE(drivers::commandAt(driver, 10.0) == (ltd::DriverCommand{2, 0, 5.0e5, 0.0, false, true}));
  EXPECT_TRUE(drivers::commandAt(driver, 190.0) == (ltd::DriverCommand{0, 6, 4.5e5, 0.0, false, false}));
  EXPECT_TRUE(drivers::commandAt(driver, 305.0) == (ltd::DriverCommand{0, 0, 5.0e5, 0.3, false, false}));
  EXPECT_TRUE(drivers::commandAt(driver, 400.0).emergency);
}

TEST(DriverExamplesTest, TheRecordingIsReplayedWithItsSpeedBeside) {
  const ltd::Driver driver = load("event_recorder.yaml");
  EXPECT_EQ(drivers::commandAt(driver, 0.0, 3000.0).notch, 2);  // the last of the standing rows
  EXPECT_TRUE(drivers::commandAt(driver, 0.0, 5600.0) == (ltd::DriverCommand{0, 5, 4.5e5, 0.0, false, false}));
  EXPECT_NEAR(driver.recordedSpeed(drivers::viewAt(0, 4200.0)).value() * rail::kKmphPerMps, 52.0, 1e-9);
}

TEST(DriverExamplesTest, TheTimetableIsKeptOnTheRollingLine) {
  rail::Problems problems;
  const rail::Document line = rail::Document::load(std::string(CONFIG_DIR) + "/tracks/rolling_line.yaml", {}, problems);
  const rail::Track track = rail::Track::read(rail::YamlReader(line, problems));
  const ltd::Driver driver = load("timetable.yaml");
  drivers::PointTrain train(driver, track, 1000.0, 0.0);
  train.run(3600.0, [](const drivers::PointTrain& x) { return x.state.timetable.waiting && x.s > 7900.0; });
  EXPECT_NEAR(train.seen.time_at_km10[40], 300.0, 5.0);
  EXPECT_NEAR(train.s, 8000.0, 20.0);
  EXPECT_LT(train.seen.largest_excess_mps, 1.0 / rail::kKmphPerMps);
  for (const std::string& note : driver.notes(train.state)) ADD_FAILURE() << note;
}

TEST(DriverExamplesTest, TheExternalDriverIsAskedEverySecond) {
  const ltd::Driver driver = load("external.yaml");
  EXPECT_TRUE(driver.asksAt(0));
  EXPECT_FALSE(driver.asksAt(drivers::kSecond / 2));
  EXPECT_TRUE(driver.asksAt(7 * drivers::kSecond));
}

}  // namespace
