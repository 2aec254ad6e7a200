#include "ltd_sim/train_dynamics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "train_fixtures.hpp"

namespace {

using fixtures::Rig;

TEST(TrainDynamicsTest, StartsInMidSlackWithTheLeadingLocomotiveAtItsPlace) {
  std::vector<rail::Vehicle> vehicles = {fixtures::paperWagon(), fixtures::paperLoco(), fixtures::paperLoco(),
                                         fixtures::paperWagon()};
  Rig rig(fixtures::makeTrain(vehicles, {1, 2}, fixtures::draftGear()), fixtures::makeTrack(), 0.002, 3000.0, 2.0);
  EXPECT_EQ(rig.state.s_m, (std::vector<double>{3018.5, 3000.0, 2978.0, 2959.5}));
  EXPECT_EQ(rig.state.v_mps, std::vector<double>(4, 2.0));
  EXPECT_EQ(rig.dynamics.leadingLocation(rig.state), 3000.0);
  rig.step();
  for (const ltd::Coupler::Force& coupler : rig.forces.coupler) EXPECT_EQ(coupler.force_N, 0.0);
}

TEST(TrainDynamicsTest, AtRestOnLevelTrackStaysAtRest) {
  Rig rig(fixtures::shortPaperTrain(5), fixtures::makeTrack(), 0.002, 3000.0, 0.0);
  const std::vector<double> s0 = rig.state.s_m;
  for (int k = 0; k < 1000; ++k) ASSERT_EQ(rig.step(), "");
  EXPECT_EQ(rig.state.s_m, s0);
  EXPECT_EQ(rig.state.v_mps, std::vector<double>(6, 0.0));
}

TEST(TrainDynamicsTest, FreeRollingThroughSlackKeepsItsMomentum) {
  Rig rig(fixtures::freeTrain(8, 90e3, fixtures::draftGear()), fixtures::makeTrack(), 0.001, 3000.0, 5.0);
  for (std::size_t i = 0; i < 8; ++i) rig.state.v_mps[i] += 0.3 * std::sin(2.0 * static_cast<double>(i));
  const double before = rig.momentum();
  double largest_N = 0.0;
  for (int k = 0; k < 20000; ++k) {
    ASSERT_EQ(rig.step(), "");
    for (const ltd::Coupler::Force& coupler : rig.forces.coupler) largest_N = std::max(largest_N, coupler.force_N);
  }
  EXPECT_GT(largest_N, 100e3);                          // it was a run-in, not a train gliding in its slack
  EXPECT_NEAR(rig.momentum(), before, 1e-12 * before);  // round-off of 20000 additions to each of 8 speeds
}

TEST(TrainDynamicsTest, MomentumChangesByTheOutsideForcesTimesTheStepInEveryStep) {
  Rig rig(fixtures::shortPaperTrain(6), fixtures::uniformGrade(4.0), 0.002, 3000.0, 3.0);
  for (int k = 0; k < 3000; ++k) {
    const double traction_N = 1e3 * (k % 400);
    const double before = rig.momentum();
    ASSERT_EQ(rig.step({traction_N}), "");
    double outside_N = traction_N;
    for (std::size_t i = 0; i < rig.train.vehicles.size(); ++i)
      outside_N += rig.forces.grade_N[i] + rig.forces.propulsion_N[i] + rig.forces.curving_N[i];
    ASSERT_NEAR(rig.momentum() - before, rig.H * outside_N, 1e-14 * 3e6) << k;  // ulps of 7 x 3e5 N s
  }
}

TEST(TrainDynamicsTest, TractionPushesItsOwnLocomotiveForwardAndNobodyElse) {
  Rig rig(
      fixtures::makeTrain(std::vector<rail::Vehicle>(5, fixtures::freeVehicle(100e3)), {1, 3}, fixtures::draftGear()),
      fixtures::makeTrack(), 0.002, 3000.0, 1.0);
  ASSERT_EQ(rig.step({0.0, 50e3}), "");
  const double dv = 0.002 * 50e3 / 100e3;
  EXPECT_EQ(rig.state.v_mps, (std::vector<double>{1.0, 1.0, 1.0, 1.0 + dv, 1.0}));
  EXPECT_EQ(rig.state.traction_N, (std::vector<double>{0.0, 50e3}));
  const double work_J = 50e3 * 0.002 * (1.0 + 0.5 * dv);  // Eq. (4) with the mean speed
  EXPECT_EQ(rig.state.loco_energy[0].rail, 0.0);
  EXPECT_NEAR(rig.state.loco_energy[1].rail, work_J, 1e-12 * work_J);
  EXPECT_NEAR(rig.state.account.traction_rail, work_J, 1e-12 * work_J);
}

TEST(TrainDynamicsTest, RimAndSlipWorkAreBookedToTheirLocomotiveAndTheTrain) {
  Rig rig(
      fixtures::makeTrain(std::vector<rail::Vehicle>(3, fixtures::freeVehicle(100e3)), {0, 2}, fixtures::draftGear()),
      fixtures::makeTrack(), 0.002, 3000.0, 1.0);
  rig.answers[0].work_rim_J = 100.0, rig.answers[0].work_slip_J = 7.0;
  rig.answers[1].work_rim_J = 200.0, rig.answers[1].work_slip_J = 13.0;
  for (int k = 0; k < 2; ++k) ASSERT_EQ(rig.step(), "");
  EXPECT_EQ(rig.state.loco_energy[0].rim, 200.0);
  EXPECT_EQ(rig.state.loco_energy[0].slip, 14.0);
  EXPECT_EQ(rig.state.loco_energy[1].rim, 400.0);
  EXPECT_EQ(rig.state.loco_energy[1].slip, 26.0);
  EXPECT_EQ(rig.state.account.traction_rim, 600.0);
  EXPECT_EQ(rig.state.account.slip_loss, 40.0);
}

TEST(TrainDynamicsTest, LocomotivesStateGoesWithTheTrainsState) {
  Rig rig(fixtures::makeTrain({fixtures::freeVehicle(1e5), fixtures::freeVehicle(1e5)}, {0, 1}, fixtures::draftGear()),
          fixtures::makeTrack(), 0.002, 3000.0, 1.0);
  EXPECT_TRUE(rig.state.loco_state[1].empty());
  rig.answers[1].state = {1.0, 2.0, 3.0};
  ASSERT_EQ(rig.step(), "");
  EXPECT_EQ(rig.state.loco_state[1], (std::vector<double>{1.0, 2.0, 3.0}));
  EXPECT_TRUE(rig.state.loco_state[0].empty());
}

TEST(TrainDynamicsTest, LocomotiveIsToldOfTheForcesThatLtdUses) {
  Rig rig(fixtures::makeTrain(std::vector<rail::Vehicle>(3, fixtures::paperWagon()), {1}, fixtures::draftGear()),
          fixtures::makeTrack("{from_km: 0, grade_permille: 5}",
                              "{start_km: 2.5, radius_m: 500, direction: right, transition_in_m: 0, circular_m: 1000, "
                              "transition_out_m: 0, cant_mm: 0}"),
          0.002, 3000.0, 4.0);
  rig.state.s_m[0] += 0.025;  // front coupler 15 mm in draft
  rig.state.s_m[2] += 0.030;  // rear coupler 20 mm in buff
  rig.dynamics.updateStoredEnergies(rig.state);
  rig.dynamics.computeForces(rig.state, rig.forces);
  loco::LocoForce told;
  rig.dynamics.fillLocoForce(0, rig.state, rig.forces, told);
  EXPECT_NEAR(told.coupler_front_N, 0.725 * 60e3, 1e-5);  // + pulls forward; round-off of 3000 m times 4 MN/m
  EXPECT_NEAR(told.coupler_rear_N, 0.725 * 80e3, 1e-5);   // buff from behind pushes forward
  EXPECT_NEAR(told.grade_N, -120e3 * 9.81 * 0.005, 1e-9);
  const double V = 4.0 * 3.6;
  EXPECT_NEAR(told.propulsion_resistance_N, -(709.96 + 120 * 0.0306 * V + 0.122 * V * V), 1e-9);
  EXPECT_NEAR(told.curving_resistance_N, -120 * 6116.0 / 500, 1e-9);
  EXPECT_EQ(told.speed_mps, 4.0);
  EXPECT_EQ(told.location_m, 3000.0);
  EXPECT_EQ(told.step, 0u);
  EXPECT_EQ(told.step_length, 2000000);
}

TEST(TrainDynamicsTest, ASingleVehicleMovesAsAPointMass) {
  Rig rig(fixtures::freeTrain(1, 100e3, fixtures::draftGear()), fixtures::makeTrack(), 0.002, 3000.0, 0.0);
  for (int k = 0; k < 5000; ++k) ASSERT_EQ(rig.step({50e3}), "");
  EXPECT_NEAR(rig.state.v_mps[0], 5.0, 1e-11);          // 10 s at 0.5 m/s^2, round-off of 5000 additions
  EXPECT_NEAR(rig.state.s_m[0], 3025.0 + 0.005, 1e-8);  // semi-implicit: a t (t + H)/2
  rig.dynamics.updateStoredEnergies(rig.state);
  EXPECT_NEAR(rig.state.account.kinetic, 0.5 * 100e3 * 25.0, 1e-5);
  EXPECT_TRUE(rig.forces.coupler.empty());
}

TEST(TrainDynamicsTest, EachVehicleFeelsItsOwnPlaceOnTheTrack) {
  // Vehicles 15 m apart from 3000 m backwards; a curve and a grade of 10 m lie around the third at 2970 m.
  Rig rig(fixtures::makeTrain(std::vector<rail::Vehicle>(5, fixtures::paperWagon()), {0}, fixtures::draftGear()),
          fixtures::makeTrack("{from_km: 0, grade_permille: 0}, {from_km: 2.965, grade_permille: 8}, "
                              "{from_km: 2.975, grade_permille: 0}",
                              "{start_km: 2.965, radius_m: 400, direction: right, transition_in_m: 0, circular_m: 10, "
                              "transition_out_m: 0, cant_mm: 0}"),
          0.002, 3000.0, 2.0);
  ASSERT_EQ(rig.step(), "");
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(rig.forces.curving_N[i], i == 2 ? -120 * 6116.0 / 400 : 0.0, 1e-9) << i;
    EXPECT_NEAR(rig.forces.grade_N[i], i == 2 ? -120e3 * 9.81 * 0.008 : 0.0, 1e-9) << i;
    EXPECT_NEAR(rig.forces.propulsion_N[i], rig.forces.propulsion_N[0], 1e-9) << i;
  }
}

/// Speeds after a minute behind an idle locomotive from rest.
std::vector<double> speedsAfterAMinuteOn(double permille) {
  Rig rig(fixtures::shortPaperTrain(20), fixtures::uniformGrade(permille), 0.002, 3000.0, 0.0);
  for (int k = 0; k < 30000; ++k) EXPECT_EQ(rig.step(), "");
  return rig.state.v_mps;
}

// A wagon's resistance is 709.96 N of 1177.2 kN: it holds up to 0.603 permille; the locomotive up to 0.707.
TEST(TrainDynamicsTest, TrainStandsOnHalfAPermilleWithoutCreeping) {
  EXPECT_EQ(speedsAfterAMinuteOn(0.5), std::vector<double>(21, 0.0));
  EXPECT_EQ(speedsAfterAMinuteOn(-0.5), std::vector<double>(21, 0.0));
}

TEST(TrainDynamicsTest, TrainRollsAwayOnSevenTenthsOfAPermilleDownhill) {
  for (const double v_mps : speedsAfterAMinuteOn(0.7)) EXPECT_LT(v_mps, -0.02);
  for (const double v_mps : speedsAfterAMinuteOn(-0.7)) EXPECT_GT(v_mps, 0.02);
}

TEST(TrainDynamicsTest, StandingLocomotiveIsHeldAgainstSmallTractionToo) {
  Rig rig(fixtures::makeTrain({fixtures::paperLoco()}, {0}, fixtures::draftGear()), fixtures::makeTrack(), 0.002,
          3000.0, 0.0);
  // 900 of the 929.6 N that hold it. The first step does not know of the traction yet and gains 13 um/s, which the
  // 29.6 N that are left take away again within 31 steps.
  for (int k = 0; k < 1000; ++k) ASSERT_EQ(rig.step({900.0}), "");
  EXPECT_NEAR(rig.state.v_mps[0], 0.0, 1e-15);
  for (int k = 0; k < 1000; ++k) ASSERT_EQ(rig.step({5000.0}), "");
  EXPECT_NEAR(rig.state.v_mps[0], 2.0 * (5000.0 - 929.6) / 134e3, 2e-4);  // 2 s; 0.2 % more resistance at 0.2 km/h
}

TEST(TrainDynamicsTest, ANumberThatIsNoneIsCaughtInItsStepWithTheVehiclesName) {
  Rig rig(fixtures::makeTrain(std::vector<rail::Vehicle>(4, fixtures::paperWagon()), {0, 2}, fixtures::draftGear()),
          fixtures::makeTrack(), 0.002, 3000.0, 1.0);
  ASSERT_EQ(rig.step({1e3, 1e3}), "");
  EXPECT_EQ(rig.step({1e3, std::numeric_limits<double>::quiet_NaN()}), "vehicle 3: its speed is not a number");
}

TEST(TrainDynamicsTest, StepUseIsTheShareOfTheFrictionsStabilityLimitWithItsVehicle) {
  // Couplers 0-1 and 1-2 at 90 mm: 1.62 MN. c = 0.275 F/vs each, limit H (c1 + c2)/m = 1.
  ltd::TrainModel train = fixtures::freeTrain(4, 120e3, fixtures::draftGear());
  train.inertial_mass_kg[1] = 22e3;
  Rig rig(train, fixtures::makeTrack(), 0.001, 3000.0, 1.0);
  EXPECT_EQ((rig.step(), rig.forces.step_use), 0.0);
  rig.state.s_m = {3000.09, 2990.0, 2979.91, 2969.91};
  rig.state.v_mps.assign(4, 1.0);
  rig.dynamics.computeForces(rig.state, rig.forces);
  const double use = 0.001 * 2.0 * 0.275 * 1.62e6 / 0.02 / 22e3;
  EXPECT_NEAR(rig.forces.step_use, use, 1e-6 * use);  // round-off of 3000 m times 80 MN/m
  EXPECT_GT(rig.forces.step_use, 1.0);
  EXPECT_EQ(rig.forces.step_use_vehicle, 1u);
}

TEST(TrainDynamicsTest, NamesTheVehicleThatLeavesTheTrack) {
  Rig rig(fixtures::shortPaperTrain(3), fixtures::makeTrack(), 0.002, 3000.0, 1.0);
  EXPECT_EQ(rig.dynamics.vehicleOffTrack(rig.state), -1);
  rig.state.s_m[0] = 10000.001;
  EXPECT_EQ(rig.dynamics.vehicleOffTrack(rig.state), 0);
  rig.state.s_m[0] = 9999.0;
  rig.state.s_m[3] = -0.001;
  EXPECT_EQ(rig.dynamics.vehicleOffTrack(rig.state), 3);
}

}  // namespace
