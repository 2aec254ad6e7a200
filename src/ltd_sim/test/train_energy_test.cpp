// The energy account of a short train through slack run-in, grade and curve.

#include <gtest/gtest.h>

#include <cmath>

#include "train_fixtures.hpp"

namespace {

using fixtures::Rig;

/// A locomotive and eight wagons that bunch, pull away uphill into a curve, and coast.
rail::EnergyAccount accountOf(double step_s) {
  // The grade changes while the train is on it; the curve's transitions are 40 m.
  const rail::Track track =
      fixtures::makeTrack("{from_km: 0, grade_permille: 0}, {from_km: 2.95, grade_permille: 6}",
                          "{start_km: 3.01, radius_m: 400, direction: left, transition_in_m: 40, circular_m: 60, "
                          "transition_out_m: 40, cant_mm: 0}");
  Rig rig(fixtures::shortPaperTrain(8), track, step_s, 3000.0, 3.0);
  for (std::size_t i = 0; i < rig.state.v_mps.size(); ++i) rig.state.v_mps[i] += 0.04 * static_cast<double>(i);
  const int steps = static_cast<int>(std::lround(30.0 / step_s));
  for (int k = 0; k < steps; ++k) {
    const double t = k * step_s;
    EXPECT_EQ(rig.step({std::min(40e3 * t, t < 20.0 ? 300e3 : 0.0)}), "");
  }
  rig.dynamics.updateStoredEnergies(rig.state);
  return rig.state.account;
}

TEST(TrainEnergyTest, EveryTermOfTheAccountTakesPart) {
  const rail::EnergyAccount a = accountOf(0.001);
  EXPECT_GT(a.traction_rail, 1e7);
  EXPECT_GT(a.propulsion_resistance, 1e5);
  EXPECT_GT(a.curving_resistance, 1e5);
  EXPECT_GT(a.coupler_loss, 1e3);
  EXPECT_GT(a.potential - a.potential_start, 1e6);
  EXPECT_NE(a.coupler_stored, 0.0);
  EXPECT_EQ(a.slip_loss, 0.0);
}

TEST(TrainEnergyTest, AccountClosesAndItsResidualFallsToAQuarterWithTheStepHalved) {
  const double at_2ms = std::abs(accountOf(0.002).residualRelative());
  const double at_1ms = std::abs(accountOf(0.001).residualRelative());
  const double at_half_ms = std::abs(accountOf(0.0005).residualRelative());
  RecordProperty("residual_2ms", std::to_string(1e9 * at_2ms));
  RecordProperty("residual_1ms", std::to_string(1e9 * at_1ms));
  RecordProperty("residual_half_ms", std::to_string(1e9 * at_half_ms));
  EXPECT_LT(at_2ms, 1e-6);
  EXPECT_NEAR(at_2ms / at_1ms, 4.0, 1.0);
  EXPECT_NEAR(at_1ms / at_half_ms, 4.0, 1.0);
}

TEST(TrainEnergyTest, GradeWorkByForceAndByHeightAgree) {
  const rail::EnergyAccount a = accountOf(0.001);
  const double by_height = a.potential - a.potential_start;
  EXPECT_NEAR(a.grade, by_height, 1e-3 * by_height);  // the step in the grade is resolved to v H = 5 mm of 60 m
}

TEST(TrainEnergyTest, CouplerLossIsTheKineticEnergyThatAnInelasticRunInTakes) {
  // Two free vehicles bunch at 1 m/s: 1/2 m_red v^2 comes in; what comes out is u of it, (1 - u) is lost.
  ltd::Coupler::Parameters coupler = fixtures::draftGear();
  coupler.smoothing_speed_mps = 1e-4;  // sharp: the law is its limit curves
  Rig rig(fixtures::makeTrain({fixtures::freeVehicle(100e3), fixtures::freeVehicle(100e3)}, {0}, coupler),
          fixtures::makeTrack(), 1e-6, 3000.0, 0.0);
  rig.state.v_mps = {-0.5, 0.5};
  while (rig.state.v_mps[1] > -0.05 || rig.forces.coupler[0].force_N != 0.0) {
    ASSERT_LT(rig.state.step, 2000000u) << "they never came apart";
    ASSERT_EQ(rig.step(), "");
  }
  rig.dynamics.updateStoredEnergies(rig.state);
  const double came_in_J = 0.5 * 50e3 * 1.0;
  EXPECT_NEAR(rig.state.account.coupler_loss, (1.0 - 0.45) * came_in_J, 2e-3 * came_in_J);  // vs, H
  EXPECT_NEAR(rig.state.account.kinetic, 0.45 * came_in_J, 2e-3 * came_in_J);
}

TEST(TrainEnergyTest, RotaryInertiaCountsInTheKineticEnergyAndNotInTheWeight) {
  ltd::TrainModel train = fixtures::shortPaperTrain(2);
  for (std::size_t i = 0; i < 3; ++i) train.inertial_mass_kg[i] = train.vehicles[i].inertialMass(true);
  Rig rig(train, fixtures::uniformGrade(10.0), 0.002, 3000.0, 6.0);
  rig.dynamics.updateStoredEnergies(rig.state);
  EXPECT_NEAR(rig.state.account.kinetic, 0.5 * (164e3 + 2 * 123e3) * 36.0, 1e-6);
  const double weight_moment = 134e3 * 3000.0 + 120e3 * (2981.5 + 2966.5);
  EXPECT_NEAR(rig.state.account.potential, 9.81 * 0.01 * weight_moment, 1e-4);  // height = 0.01 (s - 0)
}

}  // namespace
