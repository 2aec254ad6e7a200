#include <gtest/gtest.h>

#include <limits>

#include "brake_fixtures.hpp"

namespace {

using fixtures::anyHas;
using fixtures::BrakeText;
using fixtures::joined;

std::vector<std::string> faults(const std::string& text, const ltd::TrainModel& train = fixtures::brakedTrain()) {
  return fixtures::faultsIn(text, [&](rail::YamlReader reader) { ltd::AirBrake::read(reader, train); });
}

/// Replaces `what` in the good brake's text, which then must be refused once with these words.
void expectRefused(const std::string& what, const std::string& by, const std::vector<std::string>& words,
                   const BrakeText& good = {}) {
  std::string text = good.text();
  ASSERT_NE(text.find(what), std::string::npos) << what;
  text.replace(text.find(what), what.size(), by);
  const std::vector<std::string> lines = faults(text);
  EXPECT_EQ(lines.size(), 1u) << joined(lines);
  EXPECT_TRUE(anyHas(lines, words)) << joined(lines);
}

TEST(AirBrakeFaultsTest, GoodTextsAreRead) {
  EXPECT_TRUE(faults(BrakeText().text()).empty());
  EXPECT_TRUE(faults(fixtures::electronicBrake().text()).empty());
}

TEST(AirBrakeFaultsTest, FilesOfConfigAreRead) {
  const std::string brakes = std::string(CONFIG_DIR) + "/brakes/";
  for (const std::string name : {"uic_g", "uic_p", "ecp"}) {
    rail::Problems problems;
    const rail::Document document = rail::Document::load(brakes + name + ".yaml", {}, problems);
    EXPECT_TRUE(ltd::AirBrake::read(rail::YamlReader(document, problems), fixtures::brakedTrain()).present());
    EXPECT_TRUE(problems.empty()) << joined(problems.lines());
  }
  for (const std::string name :
       {"composite_shoes", "composite_shoes_empty", "cast_iron_shoes", "cast_iron_shoes_co_co"}) {
    rail::Problems problems;
    const rail::Document document = rail::Document::load(brakes + name + ".yaml", {}, problems);
    EXPECT_TRUE(ltd::VehicleBrake::read(rail::YamlReader(document, problems), fixtures::paperLoco()).present());
    EXPECT_TRUE(problems.empty()) << joined(problems.lines());
  }
}

TEST(AirBrakeFaultsTest, PressuresInPascalsAreRefused) {
  expectRefused("full_service_bar: 3.5", "full_service_bar: 3.5e5", {"pipe.full_service_bar = 3.5e5", "4.5"});
  expectRefused("full_bar: 3.8", "full_bar: 3.8e5", {"cylinder.full_bar = 3.8e5", "7"});
  expectRefused("first_reduction_bar: 0.4", "first_reduction_bar: 40000", {"valve.first_reduction_bar", "1"});
}

TEST(AirBrakeFaultsTest, TimesMustLieInTheirPositionsRangeAndOrder) {
  expectRefused("fill_time_s: 24", "fill_time_s: 4", {"cylinder.fill_time_s = 4", "18"});
  expectRefused("position: G", "position: M", {"cylinder.position = M"});
  expectRefused("emergency_fill_time_s: 18", "emergency_fill_time_s: 29",
                {"emergency_fill_time_s = 29", "fill_time_s"});
  expectRefused("release_time_s: 52", "release_time_s: 20", {"cylinder.release_time_s = 20", "45"});
}

TEST(AirBrakeFaultsTest, EmergencyMustNotBeSlowerThanService) {
  expectRefused("emergency_wave_mps: 250", "emergency_wave_mps: 190",
                {"pipe.emergency_wave_mps = 190", "service_wave"});
  expectRefused("emergency_exhaust_bar_per_s: 2.5", "emergency_exhaust_bar_per_s: 0.2",
                {"pipe.emergency_exhaust_bar_per_s = 0.2", "service_exhaust"});
  expectRefused("service_wave_mps: 200", "service_wave_mps: 2", {"pipe.service_wave_mps = 2", "50"});
}

TEST(AirBrakeFaultsTest, ReductionsMustBeInOrder) {
  expectRefused("full_release_reduction_bar: 0.15", "full_release_reduction_bar: 0.5",
                {"valve.full_release_reduction_bar = 0.5", "first_reduction_bar"});
  BrakeText text;
  text.pipe.replace(text.pipe.find("3.5"), 3, "4.5");
  expectRefused("first_reduction_bar: 0.4", "first_reduction_bar: 0.6", {"first_reduction_bar = 0.6", "full service"},
                text);
}

TEST(AirBrakeFaultsTest, MissingAndUnknownKeysAreNamed) {
  expectRefused(", charging_length_m: 500", "", {"pipe.charging_length_m", "missing"});
  expectRefused("charging_length_m: 500", "charging_length_m: 500, charging_lenght_m: 5", {"charging_lenght_m"});
  expectRefused("start: released", "start: parked", {"start = parked"});
  expectRefused("remote_valves: false", "remote_valves: false, remote_delay_s: 1", {"remote_delay_s"});
  expectRefused("delay_s: 0.2", "delay_s: 0.2, service_wave_mps: 200", {"service_wave_mps"},
                fixtures::electronicBrake());
}

TEST(AirBrakeFaultsTest, RemoteValvesNeedASecondGroupOfLocomotives) {
  expectRefused("remote_valves: false", "remote_valves: true, remote_delay_s: 1",
                {"pipe.remote_valves", "notch_group"});
}

TEST(AirBrakeFaultsTest, AnElectronicBrakeReleasesInSteps) {
  BrakeText text = fixtures::electronicBrake();
  text.valve = "{release: direct, first_reduction_bar: 0.4, release_rise_bar: 0.1, reservoir_charging_bar_per_s: 0.01}";
  const std::vector<std::string> lines = faults(text.text());
  EXPECT_TRUE(anyHas(lines, {"valve.release = direct", "graduated"})) << joined(lines);
}

TEST(AirBrakeFaultsTest, ATrainWithoutShoesIsRefused) {
  ltd::TrainModel train = fixtures::brakedTrain();
  train.brakes.clear();
  EXPECT_TRUE(anyHas(faults(BrakeText().text(), train), {"no vehicle of the train has a brake"}));
}

TEST(AirBrakeFaultsTest, CommandsOutsideTheirRangesAreNamed) {
  const fixtures::BrakeRig rig;
  EXPECT_EQ(rig.brake.refuse(fixtures::pipeAt(3.5)), "");
  EXPECT_EQ(rig.brake.refuse(fixtures::pipeAt(0.0)), "");
  EXPECT_TRUE(
      fixtures::contains(rig.brake.refuse(fixtures::pipeAt(5.1)), "pipe_pressure = 510000: must be 0 to 500000 Pa"));
  EXPECT_TRUE(fixtures::contains(rig.brake.refuse(fixtures::pipeAt(-0.1)), "pipe_pressure = -10000"));
  ltd::DriverCommand command;
  command.pipe_pressure_Pa = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(fixtures::contains(rig.brake.refuse(command), "pipe_pressure = nan"));
  command = ltd::DriverCommand();
  command.independent_brake = 1.1;
  EXPECT_TRUE(fixtures::contains(rig.brake.refuse(command), "independent_brake = 1.1"));
}

std::vector<std::string> shoeFaults(const std::string& text) {
  return fixtures::faultsIn(
      text, [](rail::YamlReader reader) { ltd::VehicleBrake::read(reader, fixtures::freeVehicle(100e3)); });
}

TEST(VehicleBrakeFaultsTest, ForceIsGivenOnceAndInNewtons) {
  const std::string rest = ", shoes: 8, rigging_efficiency: 1, friction: {law: constant, mu: 0.3}}";
  EXPECT_TRUE(shoeFaults("{name: b, brake_ratio: 0.1" + rest).empty());
  EXPECT_TRUE(
      anyHas(shoeFaults("{name: b, brake_ratio: 0.1, shoe_force_N: 1000" + rest), {"brake_ratio", "shoe_force_N"}));
  EXPECT_TRUE(anyHas(shoeFaults("{name: b, brake_ratio: 10" + rest), {"brake_ratio = 10", "3"}));
  EXPECT_TRUE(anyHas(shoeFaults("{name: b" + rest), {"brake_ratio", "missing"}));
}

TEST(VehicleBrakeFaultsTest, FrictionTableMustRiseAndBePossible) {
  const auto table = [](const std::string& points) {
    return shoeFaults("{name: b, brake_ratio: 0.1, shoes: 8, rigging_efficiency: 1, friction: {law: table, points: [" +
                      points + "]}}");
  };
  EXPECT_TRUE(table("[0, 0.4], [50, 0.3]").empty());
  EXPECT_TRUE(anyHas(table("[50, 0.4], [16, 0.3]"), {"friction.points", "must rise"}));
  EXPECT_TRUE(anyHas(table("[0, 0.4], [50, 1.3]"), {"friction.points.1", "mu"}));
  EXPECT_TRUE(anyHas(table("[-5, 0.4]"), {"friction.points.0", "km/h"}));
  EXPECT_TRUE(anyHas(table(""), {"friction.points", "at least one"}));
}

}  // namespace
