#include <gtest/gtest.h>

#include <cmath>

#include "ltd_sim/train_model.hpp"
#include "train_fixtures.hpp"

namespace {

using ltd::TrainModel;

/// Five equal wagons behind a heavier locomotive, whose force is the design force.
TrainModel equalWagons(double mass_kg, ltd::Coupler::Parameters coupler) {
  std::vector<rail::Vehicle> vehicles(6, fixtures::freeVehicle(mass_kg));
  vehicles.front().mass_kg = 1e9;
  return fixtures::makeTrain(vehicles, {0}, coupler);
}

TEST(StepBoundTest, FrictionAloneGivesMassTimesSmoothingSpeedOverFriction) {
  ltd::Coupler::Parameters coupler = fixtures::draftGear();
  coupler.loading = {{0.0, 1.0}};  // 1 N/m: nothing beside the friction
  for (const double mass_kg : {120e3, 22e3}) {
    const double friction_only_s = mass_kg * 0.02 / ((1.0 - 0.45) * 1.38e6);
    const ltd::StepBound bound = computeStepBound(equalWagons(mass_kg, coupler), 1.38e6);
    EXPECT_NEAR(bound.largest_step_s, friction_only_s, 1e-6 * friction_only_s);
    EXPECT_EQ(bound.vehicle, 1u);  // the first of the equal ones between two couplers
  }
}

TEST(StepBoundTest, StiffnessAloneGivesTheStabilityLimitOfTheChainsHighestFrequency) {
  // omega^2 <= 2 (k + k)/m, and semi-implicit Euler is stable up to omega H = 2: H = sqrt(m/k).
  const ltd::StepBound bound = computeStepBound(equalWagons(120e3, fixtures::linearSpring(30e6)), 1e6);
  EXPECT_NEAR(bound.largest_step_s, std::sqrt(120e3 / 30e6), 1e-12);
}

TEST(StepBoundTest, PapersCouplersBear3Point2MillisecondsLoadedAndPoint58Empty) {
  // Friction alone gives 3.162 and 0.580 ms; the draft gear's 30 MN/m takes 0.2 % and less off. Half a percent is the
  // rounding of the quoted figures.
  const double loaded_s = computeStepBound(equalWagons(120e3, fixtures::draftGear()), 1.38e6).largest_step_s;
  const double empty_s = computeStepBound(equalWagons(22e3, fixtures::draftGear()), 1.38e6).largest_step_s;
  EXPECT_NEAR(loaded_s, 3.16e-3, 0.005 * 3.16e-3);
  EXPECT_NEAR(empty_s, 0.58e-3, 0.005 * 0.58e-3);
  EXPECT_LT(loaded_s, 120e3 * 0.02 / (0.55 * 1.38e6));  // stiffness only makes it shorter
}

TEST(StepBoundTest, TheLightestVehicleSetsItAndRotaryInertiaCounts) {
  TrainModel train = equalWagons(120e3, fixtures::draftGear());
  train.inertial_mass_kg[3] = 22e3;
  EXPECT_EQ(computeStepBound(train, 1.38e6).vehicle, 3u);
  const double before_s = computeStepBound(train, 1.38e6).largest_step_s;
  train.inertial_mass_kg[3] = 44e3;
  EXPECT_GT(computeStepBound(train, 1.38e6).largest_step_s, 1.9 * before_s);
}

TEST(StepBoundTest, ASingleVehicleBearsAnyStep) {
  const TrainModel train = fixtures::makeTrain({fixtures::paperLoco()}, {0}, fixtures::draftGear());
  EXPECT_TRUE(std::isinf(computeStepBound(train, 1e6).largest_step_s));
}

}  // namespace
