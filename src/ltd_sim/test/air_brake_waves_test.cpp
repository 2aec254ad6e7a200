#include <gtest/gtest.h>

#include "brake_fixtures.hpp"
#include "rail_core/testing/verification.hpp"

namespace {

using fixtures::BrakeRig;
using fixtures::BrakeText;
using fixtures::emergencyCommand;
using fixtures::pipeAt;

constexpr std::size_t kTail = 107;
constexpr double kStep_s = 0.002;

TEST(AirBrakeWavesTest, EmergencyReachesTheTailOfA1641MetreTrainAfter6Point564Seconds) {
  BrakeRig rig;
  const double at_s = rig.runUntil(emergencyCommand(), [&] { return rig.pipe(kTail) < 5.0; });
  rail::verify({"2", "emergency at 250 m/s: arrives 1641 m away after", "by hand", "s", 1641.0 / 250.0, at_s,
                1.01 * kStep_s, "one macro step"});
}

TEST(AirBrakeWavesTest, ServiceWaveHasItsOwnSpeed) {
  BrakeRig rig;
  const double at_s = rig.runUntil(pipeAt(4.5), [&] { return rig.pipe(kTail) < 5.0; });
  EXPECT_NEAR(at_s, 1641.0 / 200.0, 1.01 * kStep_s);
}

TEST(AirBrakeWavesTest, TheWaveStartsAtTheLeadingLocomotiveAndRunsBothWays) {
  ltd::TrainModel train = fixtures::brakedTrain();
  train.locomotives[0].vehicle = 40;
  BrakeRig rig({}, train);
  const double metres = 1641.0 / 107.0;
  EXPECT_NEAR(rig.runUntil(emergencyCommand(), [&] { return rig.pipe(40) < 5.0; }), kStep_s, 1e-9);
  const double to_head_s = kStep_s + rig.runUntil(emergencyCommand(), [&] { return rig.pipe(0) < 5.0; });
  EXPECT_NEAR(to_head_s, 40.0 * metres / 250.0, 1.01 * kStep_s);
  const double to_tail_s = to_head_s + rig.runUntil(emergencyCommand(), [&] { return rig.pipe(kTail) < 5.0; });
  EXPECT_NEAR(to_tail_s, 67.0 * metres / 250.0, 1.01 * kStep_s);
}

TEST(AirBrakeWavesTest, TheWaveCarriesTheValvesPressureUnchanged) {
  BrakeRig rig;
  rig.run(pipeAt(4.2), 2.0);
  EXPECT_NEAR(rig.pipe(0), 5.0 - 0.25 * 2.0, 1e-9);
  rig.run(pipeAt(4.2), 8.205 - 0.001);  // 8.206 s later the same at the tail
  EXPECT_NEAR(rig.pipe(kTail), 5.0 - 0.25 * (rail::toSeconds(rig.t) - 1641.0 / 200.0), 1e-9);
  rig.run(pipeAt(4.2), 10.0);
  EXPECT_NEAR(rig.pipe(kTail), 4.2, 1e-12);
}

TEST(AirBrakeWavesTest, RechargingIsSlowerTowardsTheTail) {
  BrakeText text;
  text.start = "full_service";
  BrakeRig head(text), tail(text);
  EXPECT_NEAR(head.runUntil(pipeAt(5.0), [&] { return head.pipe(0) >= 5.0; }), 1.5 / 0.2, 1.01 * kStep_s);
  const double rate = 0.2 / (1.0 + 1641.0 / 500.0);
  const double at_s = tail.runUntil(pipeAt(5.0), [&] { return tail.pipe(kTail) >= 5.0; });
  EXPECT_NEAR(at_s, 1641.0 / 200.0 + 1.5 / rate, 3.0 * kStep_s);
}

TEST(AirBrakeWavesTest, ElectronicBrakeActsOnAllVehiclesAtOnceAfterItsDelay) {
  BrakeRig rig(fixtures::electronicBrake("0.2"));
  rig.run(pipeAt(3.5), 0.2);
  for (std::size_t i = 0; i <= kTail; ++i) EXPECT_EQ(rig.cylinder(i), 0.0);
  rig.run(pipeAt(3.5), 0.1);
  EXPECT_NEAR(rig.cylinder(0), 0.95 * 3.8 / 24.0 * 0.1, 0.95 * 3.8 / 24.0 * kStep_s);
  for (std::size_t i = 1; i <= kTail; ++i) EXPECT_EQ(rig.cylinder(i), rig.cylinder(0));
}

TEST(AirBrakeWavesTest, RemoteValvesVentFromTheirPlaceAfterTheirDelay) {
  ltd::TrainModel train = fixtures::brakedTrain();
  train.notch_groups = {"lead", "remote"};
  train.locomotives.push_back({kTail, 1, 0, 0.35, "1d", "train"});
  BrakeText text;
  text.pipe.replace(text.pipe.find("remote_valves: false"), 20, "remote_valves: true, remote_delay_s: 1.0");
  BrakeRig tail(text, train), middle(text, train);
  const double tail_s = tail.runUntil(emergencyCommand(), [&] { return tail.pipe(kTail) < 5.0; });
  EXPECT_NEAR(tail_s, 1.0, 1.01 * kStep_s);
  const double middle_s = middle.runUntil(emergencyCommand(), [&] { return middle.pipe(50) < 5.0; });
  EXPECT_NEAR(middle_s, 1641.0 * 50.0 / 107.0 / 250.0, 1.01 * kStep_s);  // from the head: 3.07 s against 4.50 s
}

TEST(AirBrakeWavesTest, RemoteValvesRechargeFromTheirPlace) {
  ltd::TrainModel train = fixtures::brakedTrain();
  train.notch_groups = {"lead", "remote"};
  train.locomotives.push_back({kTail, 1, 0, 0.35, "1d", "train"});
  BrakeText text;
  text.start = "full_service";
  text.pipe.replace(text.pipe.find("remote_valves: false"), 20, "remote_valves: true, remote_delay_s: 1.0");
  BrakeRig rig(text, train);
  const double at_s = rig.runUntil(pipeAt(5.0), [&] { return rig.pipe(kTail) >= 5.0; });
  EXPECT_NEAR(at_s, 1.0 + 1.5 / 0.2, 3.0 * kStep_s);  // as at the driver's valve, after the delay
}

}  // namespace
