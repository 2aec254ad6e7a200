#include "ltd_sim/air_brake.hpp"

#include <gtest/gtest.h>

#include "brake_fixtures.hpp"
#include "rail_core/testing/verification.hpp"

namespace {

using fixtures::BrakeRig;
using fixtures::BrakeText;
using fixtures::emergencyCommand;
using fixtures::pipeAt;

constexpr std::size_t kTail = 107;

TEST(AirBrakeTest, ATrainWithoutOneHasNoForceAndObeysOnlyTheReleasedBrake) {
  const ltd::AirBrake none;
  EXPECT_FALSE(none.present());
  ltd::AirBrake::State state = none.initialState();
  none.step(ltd::DriverCommand(), 0, fixtures::kBrakeStep, state);
  EXPECT_EQ(none.shoeForce(5, 10.0, state), 0.0);
  EXPECT_EQ(none.cylinderPressure(5, state), 0.0);
  EXPECT_EQ(none.pipePressure(5, state), 5e5);
  EXPECT_EQ(none.refuse(ltd::DriverCommand()), "");
  EXPECT_TRUE(fixtures::contains(none.refuse(pipeAt(4.5)), "or the scenario must have an air_brake: it has none"));
}

TEST(AirBrakeTest, ReleasedBrakeHasNoForce) {
  BrakeRig rig;
  rig.run(pipeAt(5.0), 20.0);
  for (std::size_t i = 0; i <= kTail; ++i) EXPECT_EQ(rig.force(i), 0.0) << i;
}

TEST(AirBrakeTest, BrakingRatioOfATenthAndFrictionOf036RetardBy0Point353) {
  BrakeRig rig;
  rig.run(pipeAt(3.5), 60.0);
  double force_N = 0.0, mass_kg = 0.0;
  for (std::size_t i = 0; i <= kTail; ++i) {
    force_N += rig.force(i);
    mass_kg += rig.train.vehicles[i].mass_kg;
  }
  EXPECT_NEAR(force_N / mass_kg, 0.1 * 0.36 * 9.81, 1e-9);
  rail::verify({"2", "brake ratio 0.10, mu 0.36: retardation of the train", "by hand", "m/s2", 0.353, force_N / mass_kg,
                0.5e-3, "three digits given"});
}

TEST(AirBrakeTest, EmergencyIsFasterThanServiceEverywhere) {
  BrakeRig service, emergency;
  for (const double until_s : {2.0, 8.0, 15.0}) {
    service.run(pipeAt(3.5), until_s - rail::toSeconds(service.t));
    emergency.run(emergencyCommand(), until_s - rail::toSeconds(emergency.t));
    for (std::size_t i = 0; i <= kTail; ++i) {
      if (emergency.cylinder(i) > 0.0) {
        EXPECT_GT(emergency.cylinder(i), service.cylinder(i)) << i;
      }
    }
    EXPECT_GT(emergency.cylinder(0), 0.0);
  }
  EXPECT_GT(emergency.cylinder(kTail), 0.0);
}

TEST(AirBrakeTest, EmergencyHasTheFullForceOfService) {
  BrakeRig service, emergency;
  service.run(pipeAt(3.5), 60.0);
  emergency.run(emergencyCommand(), 60.0);
  EXPECT_EQ(emergency.force(kTail), service.force(kTail));
  EXPECT_EQ(emergency.pipe(kTail), 0.0);
}

TEST(AirBrakeTest, CylindersFillInProportionToTheReduction) {
  for (const double reduction_bar : {0.4, 0.6, 0.9, 1.2, 1.5}) {
    BrakeRig rig;
    rig.run(pipeAt(5.0 - reduction_bar - 1e-9), 60.0);  // the first step is asked for just so
    EXPECT_NEAR(rig.cylinder(50), 3.8 * reduction_bar / 1.5, 1e-7) << reduction_bar;
  }
  BrakeRig below;
  below.run(pipeAt(4.7), 60.0);
  EXPECT_EQ(below.cylinder(0), 0.0);
}

TEST(AirBrakeTest, GraduatedReleaseGivesUpForceInSteps) {
  BrakeRig rig;
  rig.run(pipeAt(3.5), 60.0);
  rig.run(pipeAt(4.25), 120.0);
  EXPECT_NEAR(rig.cylinder(kTail), 1.9, 1e-9);
  rig.run(pipeAt(4.7), 120.0);
  EXPECT_NEAR(rig.cylinder(kTail), 3.8 * 0.3 / 1.5, 1e-9);
  rig.run(pipeAt(4.9), 120.0);
  EXPECT_EQ(rig.cylinder(kTail), 0.0);
}

TEST(AirBrakeTest, DirectReleaseGivesUpAllAndTooSoonAnApplicationHasLessForce) {
  BrakeText text;
  text.valve = "{release: direct, first_reduction_bar: 0.4, release_rise_bar: 0.1, reservoir_charging_bar_per_s: 0.01}";
  BrakeRig rig(text);
  rig.run(pipeAt(3.5), 60.0);
  EXPECT_NEAR(rig.cylinder(0), 3.8, 1e-12);
  rig.run(pipeAt(4.25), 60.0);
  EXPECT_EQ(rig.cylinder(0), 0.0);
  // The reservoir stood at 3.5 bar when the pipe had risen by 0.1, after 0.5 s, and took up 0.01 bar/s since.
  rig.run(pipeAt(3.5), 60.0);
  const double charged_s = 60.0 - 0.5 + (4.25 - 4.1) / 0.25;  // until the pipe fell below it; 0.6 s rounds the rest
  EXPECT_NEAR(rig.cylinder(0), 3.8 * 0.01 * charged_s / 1.5, 3.8 * 0.01 * 1.0 / 1.5);
  EXPECT_LT(rig.cylinder(0), 1.6);
}

TEST(AirBrakeTest, StartsStandingWithFullServiceAndHoldsIt) {
  BrakeText text;
  text.start = "full_service";
  BrakeRig rig(text);
  EXPECT_NEAR(rig.force(kTail), 0.1 * 0.36 * 9.81 * 120e3, 1e-6);
  rig.run(pipeAt(3.5), 30.0);
  EXPECT_NEAR(rig.force(kTail), 0.1 * 0.36 * 9.81 * 120e3, 1e-6);
  rig.run(pipeAt(5.0), 150.0);
  EXPECT_EQ(rig.force(kTail), 0.0);
}

TEST(AirBrakeTest, IndependentBrakeActsOnLocomotivesOnly) {
  BrakeRig rig;
  ltd::DriverCommand command = pipeAt(5.0);
  command.independent_brake = 0.5;
  rig.run(command, 60.0);
  EXPECT_NEAR(rig.cylinder(0), 1.9, 1e-12);
  for (std::size_t i = 1; i <= kTail; ++i) EXPECT_EQ(rig.cylinder(i), 0.0);
  command.pipe_pressure_Pa = 3.5e5;  // the larger of the two
  rig.run(command, 60.0);
  EXPECT_NEAR(rig.cylinder(0), 3.8, 1e-12);
}

TEST(AirBrakeTest, ACopiedStateGoesOnWithTheSameBits) {
  BrakeRig rig;
  rig.run(pipeAt(3.9), 7.0);
  ltd::AirBrake::State copy = rig.state;
  rail::Nanoseconds t = rig.t;
  for (int k = 0; k < 5000; ++k, t += fixtures::kBrakeStep) {
    const ltd::DriverCommand command = k < 2000 ? pipeAt(5.0) : emergencyCommand();
    rig.step(command);
    rig.brake.step(command, t, fixtures::kBrakeStep, copy);
  }
  for (std::size_t i = 0; i <= kTail; ++i) {
    EXPECT_EQ(rig.brake.pipePressure(i, copy), rig.brake.pipePressure(i, rig.state));
    EXPECT_EQ(rig.brake.cylinderPressure(i, copy), rig.brake.cylinderPressure(i, rig.state));
  }
}

TEST(AirBrakeTest, HalvingTheStepMovesNoCylinderByMoreThanOneStepsFilling) {
  BrakeRig coarse, fine;
  for (const double bar : {4.1, 3.7, 4.6}) {
    coarse.run(pipeAt(bar), 10.0, 4000000);
    fine.run(pipeAt(bar), 10.0, 2000000);
    for (std::size_t i = 0; i <= kTail; ++i)
      EXPECT_NEAR(coarse.cylinder(i), fine.cylinder(i), 0.95 * 3.8 / 24.0 * 0.004) << i;
  }
}

TEST(AirBrakeTest, ABrakeAtRestWakesWithTheNextCommand) {
  BrakeRig rested, fresh;
  rested.run(pipeAt(5.0), 60.0);  // longer than the history: steps do nothing then
  EXPECT_GT(rested.state.quiet_steps, rested.state.pipe.history.size());
  rested.run(pipeAt(3.5), 20.0);
  fresh.run(pipeAt(3.5), 20.0);
  for (std::size_t i = 0; i <= kTail; ++i) EXPECT_EQ(rested.cylinder(i), fresh.cylinder(i)) << i;
}

TEST(AirBrakeTest, AtRestItStillHearsAnEmergencyThatMovesNothingAtOnce) {
  BrakeRig rig(fixtures::electronicBrake("0.2"));
  rig.run(pipeAt(0.0), 60.0);
  EXPECT_EQ(rig.state.pipe.emergency[kTail], 0);
  rig.run(emergencyCommand(), 0.3);
  EXPECT_EQ(rig.state.pipe.emergency[kTail], 1);
}

TEST(AirBrakeTest, AtRestTheReservoirsMustBeFull) {
  BrakeText text;
  text.valve = "{release: direct, first_reduction_bar: 0.4, release_rise_bar: 0.1, reservoir_charging_bar_per_s: 0.01}";
  BrakeRig rig(text);
  rig.run(pipeAt(3.5), 60.0);
  rig.run(pipeAt(5.0), 250.0);  // pipe and cylinders rest after 60 s, the reservoirs after 150 s and the wave
  rig.run(pipeAt(3.5), 60.0);
  EXPECT_NEAR(rig.cylinder(kTail), 3.8, 1e-12);
}

}  // namespace
