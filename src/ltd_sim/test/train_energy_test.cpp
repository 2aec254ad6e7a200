// The energy account of a short train through slack run-in, grade and curve.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rail_core/testing/verification.hpp"
#include "supply_texts.hpp"
#include "train_fixtures.hpp"

namespace {

using fixtures::Rig;

constexpr double kPermille = 6.0;

/// A locomotive and thirty wagons that run in, stretch and pull through a curve for 40 s; steady at the end, where a
/// swinging coupler would hide the account's order behind that of its stored energy.
class Journey {
 public:
  Journey(double step_s, double permille)
      : rig_(
            fixtures::shortPaperTrain(30),
            fixtures::makeTrack("{from_km: 0, grade_permille: " + std::to_string(permille) + "}",
                                "{start_km: 3.01, radius_m: 400, direction: left, transition_in_m: 40, circular_m: 60, "
                                "transition_out_m: 40, cant_mm: 0}"),
            step_s, 3000.0, 3.0) {
    for (std::size_t i = 0; i < rig_.state.v_mps.size(); ++i) rig_.state.v_mps[i] += 0.04 * static_cast<double>(i % 5);
    momentum_start_ = rig_.momentum();
    const int steps = static_cast<int>(std::lround(40.0 / step_s));
    for (int k = 0; k < steps; ++k) {
      EXPECT_EQ(rig_.step({std::min(40e3 * k * step_s, 300e3)}), "");
    }
    rig_.dynamics.updateStoredEnergies(rig_.state);
  }
  const rail::EnergyAccount& account() const { return rig_.state.account; }
  double momentumGained() const { return rig_.momentum() - momentum_start_; }

 private:
  Rig rig_;
  double momentum_start_ = 0.0;
};

TEST(TrainEnergyTest, EveryTermOfTheAccountTakesPart) {
  const rail::EnergyAccount a = Journey(0.001, kPermille).account();
  EXPECT_GT(a.traction_rail, 1e7);
  EXPECT_GT(a.propulsion_resistance, 1e5);
  EXPECT_GT(a.curving_resistance, 1e5);
  EXPECT_GT(a.coupler_loss, 1e3);
  EXPECT_GT(a.potential - a.potential_start, 1e6);
  EXPECT_EQ(a.slip_loss, 0.0);
}

TEST(TrainEnergyTest, AccountClosesOnTheLevelAndItsResidualFallsToAQuarterWithTheStepHalved) {
  const double at_2ms = Journey(0.002, 0.0).account().residualRelative();
  const double at_1ms = Journey(0.001, 0.0).account().residualRelative();
  const double at_half_ms = Journey(0.0005, 0.0).account().residualRelative();
  rail::verify({"7", "1D train of 31 vehicles, 40 s on the level, 2 ms: residual over the traction work", "exact", "1",
                0.0, at_2ms, 1e-6, "asked for"});
  rail::verify({"7", "the same, 2 ms over 1 ms", "second order", "1", 4.0, at_2ms / at_1ms, 1.0,
                "where in a step a knot of a coupler is passed is chance"});
  EXPECT_NEAR(at_1ms / at_half_ms, 4.0, 1.0);
}

TEST(TrainEnergyTest, AccountClosesOnAGradeAndItsResidualFallsToAQuarterWithTheStepHalved) {
  // Heights are taken where works and speeds are, H v/2 behind s (T9): at s the residual would be of first
  // order, 1.5e-5.
  const double at_2ms = Journey(0.002, kPermille).account().residualRelative();
  const double at_1ms = Journey(0.001, kPermille).account().residualRelative();
  rail::verify({"7", "1D train of 31 vehicles, 40 s on 6 permille, 2 ms: residual over the traction work", "exact", "1",
                0.0, at_2ms, 1e-6, "asked for"});
  EXPECT_NEAR(at_2ms / at_1ms, 4.0, 1.0);
}

TEST(TrainEnergyTest, GradeWorkByForceAndByHeightAgree) {
  const rail::EnergyAccount a = Journey(0.001, kPermille).account();
  const double by_height = a.potential - a.potential_start;
  EXPECT_NEAR(a.grade, by_height, 1e-9 * by_height);  // both are of the same distances on an even grade
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
  const double behind_m = 0.5 * 0.002 * 6.0;  // (T9)
  const double weight_moment = 134e3 * (3000.0 - behind_m) + 120e3 * (2981.5 - behind_m) + 120e3 * (2966.5 - behind_m);
  EXPECT_NEAR(rig.state.account.potential, 9.81 * 0.01 * weight_moment, 1e-4);  // height = 0.01 (s - 0)
}

/// One step of a lone locomotive at 10 m/s, 10 ms, whose reference and answer are given.
ltd::TrainState bookedStep(double reference_N, const loco::LocoTraction& answer) {
  fixtures::Rig rig(fixtures::freeTrain(1, 100e3, fixtures::linearSpring(1e6)), fixtures::makeTrack(), 0.01, 5000.0,
                    10.0);
  rig.dynamics.computeForces(rig.state, rig.forces);
  rig.forces.reference_N[0] = reference_N;
  EXPECT_EQ(rig.commit({&answer}), "");
  return rig.state;
}

TEST(LocoEnergyTest, WorkOfABrakingLocomotiveIsBookedAsItsBrakesNotAsTraction) {
  loco::LocoTraction answer;
  answer.traction_N = -50e3, answer.work_rim_J = -4700.0, answer.work_slip_J = 200.0, answer.work_shoes_J = 30.0;
  const ltd::TrainState state = bookedStep(-50e3, answer);
  const ltd::LocoEnergy& energy = state.loco_energy[0];
  EXPECT_NEAR(energy.brake_rail, 50e3 * 0.01 * (10.0 - 0.5 * 50e3 * 0.01 / 100e3), 1e-9);
  EXPECT_EQ(energy.recovered_rim, 4700.0);
  EXPECT_EQ(energy.slip, 200.0);
  EXPECT_EQ(energy.shoes, 30.0);
  EXPECT_EQ(energy.rail, 0.0);
  EXPECT_EQ(energy.rim, 0.0);
  EXPECT_EQ(state.account.brake_rail, energy.brake_rail);
  EXPECT_EQ(state.account.recovered_rim, 4700.0);
  EXPECT_EQ(state.account.shoes, 30.0);
  EXPECT_EQ(state.account.traction_rail, 0.0);
  EXPECT_EQ(state.account.traction_rim, 0.0);
}

TEST(LocoEnergyTest, WorkOfADrivingLocomotiveIsTraction) {
  loco::LocoTraction answer;
  answer.traction_N = 50e3, answer.work_rim_J = 5300.0;
  const ltd::TrainState state = bookedStep(50e3, answer);
  EXPECT_GT(state.loco_energy[0].rail, 5000.0);
  EXPECT_EQ(state.loco_energy[0].rim, 5300.0);
  EXPECT_EQ(state.loco_energy[0].brake_rail, 0.0);
  EXPECT_EQ(state.loco_energy[0].recovered_rim, 0.0);
}

/// A locomotive with a battery that pulls while the train rolls back down 20 permille, in the real order of calls.
ltd::TrainState rolledBack() {
  ltd::TrainModel train = fixtures::freeTrain(1, 100e3, fixtures::linearSpring(1e6));
  const std::string text = fixtures::supplyHead("storage") + fixtures::storageText();
  train.supplies = {
      fixtures::readMap(text, [](rail::YamlReader reader) { return ltd::PowerSupply::read(reader, 0.0); })};
  fixtures::Rig rig(train, fixtures::uniformGrade(20.0), 0.01, 5000.0, -1.0, fixtures::makeDriver("[0, 1]"));
  loco::LocoTraction answer;
  for (int k = 0; k < 200; ++k) {
    rig.dynamics.computeForces(rig.state, rig.forces);
    const double v = rig.state.v_mps[0], next = v + 0.01 * (rig.forces.grade_N[0] + rig.forces.reference_N[0]) / 100e3;
    answer.traction_N = rig.forces.reference_N[0];
    answer.work_rim_J = answer.traction_N * 0.01 * 0.5 * (v + next);  // 1D: rim = rail
    EXPECT_EQ(rig.commit({&answer}), "");
  }
  EXPECT_GT(rig.state.reference_N[0], 0.0);
  EXPECT_LT(rig.state.v_mps[0], 0.0);
  return rig.state;
}

TEST(LocoEnergyTest, RollingBackUnderTractionIsRecoveredInTheAccountAndInTheSupplyAlike) {
  const ltd::TrainState state = rolledBack();
  const ltd::LocoEnergy& energy = state.loco_energy[0];
  EXPECT_GT(energy.recovered_rim, 1000.0);
  EXPECT_EQ(energy.recovered_rim, state.supply[0].recovered_rim_J);
  EXPECT_EQ(energy.rim, state.supply[0].motored_rim_J);
  EXPECT_EQ(energy.rim, 0.0);
  EXPECT_NEAR(energy.brake_rail, energy.recovered_rim, 1e-9 * energy.recovered_rim);
  EXPECT_EQ(energy.rail, 0.0);
  EXPECT_GT(state.supply[0].storage_in_J, 0.0);
}

TEST(LocoEnergyTest, WhatTheWheelsOfACoastingLocomotiveTakeIsNoBrakes) {
  loco::LocoTraction answer;
  answer.traction_N = -100.0;
  EXPECT_LT(bookedStep(0.0, answer).loco_energy[0].rail, 0.0);
  EXPECT_EQ(bookedStep(0.0, answer).loco_energy[0].brake_rail, 0.0);
}

}  // namespace
