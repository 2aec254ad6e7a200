#include <gtest/gtest.h>

#include "brake_fixtures.hpp"
#include "ltd_sim/shoe_friction.hpp"
#include "ltd_sim/vehicle_brake.hpp"
#include "rail_core/testing/verification.hpp"

namespace {

using fixtures::BrakeRig;
using fixtures::BrakeText;
using fixtures::emergencyCommand;
using fixtures::pipeAt;
using ltd::ShoeFriction;
using ltd::VehicleBrake;

constexpr double kStep_s = 0.002;

double mps(double kmph) { return kmph / rail::kKmphPerMps; }

TEST(ShoeFrictionTest, KarwatzkiOf20KilonewtonsIs0Point302StandingAnd0Point130At50) {
  const ShoeFriction friction = ShoeFriction::karwatzki();
  rail::verify({"2", "Karwatzki, 20 kN a shoe, at rest: mu", "by hand", "", 0.302, friction.coefficient(20e3, 0.0),
                0.5e-3, "three digits given"});
  rail::verify({"2", "Karwatzki, 20 kN a shoe, 50 km/h: mu", "by hand", "", 0.130,
                friction.coefficient(20e3, mps(50.0)), 0.5e-3, "three digits given"});
  EXPECT_EQ(friction.coefficient(20e3, mps(-50.0)), friction.coefficient(20e3, mps(50.0)));
  EXPECT_NEAR(friction.coefficient(0.0, 0.0), 0.6, 1e-12);  // its limit
}

TEST(ShoeFrictionTest, TableIsLinearBetweenItsPointsAndConstantBeyond) {
  const ShoeFriction friction =
      fixtures::readMap("{law: table, points: [[16, 0.425], [48, 0.359], [97, 0.321]]}", ShoeFriction::read);
  EXPECT_NEAR(friction.coefficient(1e4, mps(16.0)), 0.425, 1e-12);
  EXPECT_NEAR(friction.coefficient(9e4, mps(48.0)), 0.359, 1e-12);
  EXPECT_NEAR(friction.coefficient(1e4, mps(97.0)), 0.321, 1e-12);
  EXPECT_NEAR(friction.coefficient(1e4, mps(-32.0)), 0.392, 1e-12);
  EXPECT_NEAR(friction.coefficient(1e4, 0.0), 0.425, 1e-12);
  EXPECT_NEAR(friction.coefficient(1e4, mps(150.0)), 0.321, 1e-12);
}

TEST(ShoeFrictionTest, ConstantIsConstant) {
  const ShoeFriction friction = fixtures::readMap("{law: constant, mu: 0.36}", ShoeFriction::read);
  EXPECT_EQ(friction.coefficient(1e3, 0.0), 0.36);
  EXPECT_EQ(friction.coefficient(1e5, 40.0), 0.36);
}

VehicleBrake readBrake(const std::string& force) {
  return fixtures::readMap("{name: b, shoes: 8, " + force + ", friction: {law: karwatzki}}",
                           [](rail::YamlReader r) { return VehicleBrake::read(r, fixtures::freeVehicle(100e3)); });
}

TEST(VehicleBrakeTest, ShoeForceIsGivenAsSuchOrOverTheWeightAndLosesInTheRigging) {
  EXPECT_NEAR(readBrake("shoe_force_N: 160.0e3, rigging_efficiency: 0.9").shoe_force_N, 144e3, 1e-6);
  EXPECT_NEAR(readBrake("brake_ratio: 0.2, rigging_efficiency: 0.8").shoe_force_N, 0.8 * 0.2 * 100e3 * 9.81, 1e-6);
}

TEST(VehicleBrakeTest, FrictionIsThatOfTheForceOnOneShoe) {
  const VehicleBrake brake = readBrake("shoe_force_N: 160.0e3, rigging_efficiency: 1.0");  // 20 kN a shoe
  EXPECT_NEAR(brake.largestRetardation(1.0, 0.0), 0.302 * 160e3, 0.5e-3 * 160e3);
  const double half = ShoeFriction::karwatzki().coefficient(10e3, 5.0);
  EXPECT_NEAR(brake.largestRetardation(0.5, 5.0), half * 80e3, 1e-6);
  EXPECT_EQ(brake.largestRetardation(0.0, 5.0), 0.0);
}

TEST(VehicleBrakeTest, WithoutShoesThereIsNoForce) { EXPECT_EQ(VehicleBrake().largestRetardation(1.0, 0.0), 0.0); }

/// An electronic brake without delay asks for the full pressure at once: the cylinder's times alone.
BrakeText cylinderAlone(const std::string& cylinder) {
  BrakeText text = fixtures::electronicBrake("0.0");
  text.cylinder = cylinder;
  return text;
}

void expectTimes(const std::string& cylinder, double fill_s, double emergency_s, double release_s) {
  BrakeRig service(cylinderAlone(cylinder)), emergency(cylinderAlone(cylinder));
  const auto filled = [](const BrakeRig& rig) { return rig.cylinder(5) >= 0.95 * 3.8 - 1e-9; };
  EXPECT_NEAR(service.runUntil(pipeAt(3.5), [&] { return filled(service); }), fill_s, 1.01 * kStep_s);
  EXPECT_NEAR(emergency.runUntil(emergencyCommand(), [&] { return filled(emergency); }), emergency_s, 1.01 * kStep_s);
  service.run(pipeAt(3.5), 60.0);
  EXPECT_NEAR(service.cylinder(5), 3.8, 1e-12);
  const double at_s = service.runUntil(pipeAt(5.0), [&] { return service.cylinder(5) <= 0.4 + 1e-9; });
  EXPECT_NEAR(at_s, release_s, 1.01 * kStep_s);
}

TEST(BrakeCylinderTest, FillsTo95PercentAndReleasesToPoint4BarInTheTimesOfPositionG) {
  expectTimes("{position: G, full_bar: 3.8, fill_time_s: 24, emergency_fill_time_s: 18, release_time_s: 52}", 24.0,
              18.0, 52.0);
}

TEST(BrakeCylinderTest, AndOfPositionP) {
  expectTimes("{position: P, full_bar: 3.8, fill_time_s: 4, emergency_fill_time_s: 3, release_time_s: 18}", 4.0, 3.0,
              18.0);
}

TEST(BrakeCylinderTest, AVehiclesOwnCylinderGoesBeforeTheTrains) {
  ltd::TrainModel train = fixtures::brakedTrain();
  ltd::BrakeCylinder::Parameters own;
  own.full_Pa = 2e5, own.fill_time_s = 4.0, own.emergency_fill_time_s = 3.0, own.release_time_s = 18.0;
  train.brakes[3].cylinder = ltd::BrakeCylinder(own);
  BrakeRig rig({}, train);
  rig.run(pipeAt(3.5), 60.0);
  EXPECT_NEAR(rig.cylinder(3), 2.0, 1e-12);
  EXPECT_NEAR(rig.cylinder(4), 3.8, 1e-12);
  EXPECT_NEAR(rig.force(3), rig.force(4), 1e-6);  // the shoe force is that of the vehicle's full pressure
}

ltd::Distributor::Parameters graduated() {
  ltd::Distributor::Parameters p;
  p.full_reduction_Pa = 1.5e5, p.first_reduction_Pa = 0.4e5, p.full_release_reduction_Pa = 0.15e5;
  return p;
}

TEST(DistributorTest, AppliesAtTheFirstReductionAndReleasesAtASmallerOne) {
  const ltd::Distributor valve(graduated());
  ltd::Distributor::State state = valve.initialState(5e5);
  EXPECT_EQ(valve.step(4.61e5, false, 0.002, state), 0.0);
  EXPECT_NEAR(valve.step(4.59e5, false, 0.002, state), 0.41 / 1.5, 1e-12);
  EXPECT_NEAR(valve.step(4.80e5, false, 0.002, state), 0.20 / 1.5, 1e-12);
  EXPECT_EQ(valve.step(4.86e5, false, 0.002, state), 0.0);
  EXPECT_EQ(valve.step(4.80e5, false, 0.002, state), 0.0);
}

TEST(DistributorTest, AnEmergencyDoesNotWaitForTheFirstReduction) {
  for (const bool direct : {false, true}) {
    ltd::Distributor::Parameters p = graduated();
    p.direct_release = direct;
    const ltd::Distributor valve(p);
    ltd::Distributor::State state = valve.initialState(5e5);
    EXPECT_NEAR(valve.step(4.85e5, true, 0.002, state), 0.1, 1e-12);
  }
}

}  // namespace
