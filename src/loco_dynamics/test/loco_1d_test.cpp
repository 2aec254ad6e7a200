#include "loco_dynamics/loco_1d.hpp"

#include <gtest/gtest.h>

namespace {

constexpr double kMass_kg = 134000.0;  // Table 2 of the paper

loco::Loco1d makeLoco() { return loco::Loco1d({kMass_kg, kMass_kg, 0.35}); }

loco::LocoForce makeForce() {
  loco::LocoForce force;
  force.step = 7;
  force.step_length = 2000000;  // 2 ms
  return force;
}

TEST(Loco1dTest, AtRestWithoutForcesStaysAtRest) {
  loco::Loco1d locomotive = makeLoco();
  loco::LocoTraction answer;
  locomotive.step({3000.0, 0.0}, makeForce(), answer);
  EXPECT_EQ(answer.speed_mps, 0.0);
  EXPECT_EQ(answer.location_m, 3000.0);
  EXPECT_EQ(answer.work_rim_J, 0.0);
}

TEST(Loco1dTest, AdhesionLimitOfThePaperIs460kN) {
  loco::Loco1d locomotive = makeLoco();
  loco::LocoForce force = makeForce();
  force.traction_reference_N = 560e3;
  loco::LocoTraction answer;
  locomotive.step({3000.0, 2.0}, force, answer);
  EXPECT_NEAR(answer.traction_N, 460.089e3, 0.5);  // 0.35 * 134 t * 9.81, to the rounding of the quoted figure
}

TEST(Loco1dTest, BelowTheLimitTheReferencePasses) {
  loco::Loco1d locomotive = makeLoco();
  loco::LocoForce force = makeForce();
  force.traction_reference_N = 123456.0;
  loco::LocoTraction answer;
  locomotive.step({3000.0, 2.0}, force, answer);
  EXPECT_EQ(answer.traction_N, 123456.0);
}

TEST(Loco1dTest, EveryForceOfEquation1ActsWithItsSign) {
  loco::Loco1d locomotive = makeLoco();
  const double H = 0.002;
  double loco::LocoForce::*const forces[] = {
      &loco::LocoForce::traction_reference_N, &loco::LocoForce::coupler_front_N,
      &loco::LocoForce::coupler_rear_N,       &loco::LocoForce::propulsion_resistance_N,
      &loco::LocoForce::curving_resistance_N, &loco::LocoForce::grade_N};
  for (const auto member : forces) {
    loco::LocoForce force = makeForce();
    force.*member = 1000.0;
    loco::LocoTraction answer;
    locomotive.step({0.0, 10.0}, force, answer);
    EXPECT_DOUBLE_EQ(answer.speed_mps, 10.0 + H * 1000.0 / kMass_kg);
    EXPECT_DOUBLE_EQ(answer.location_m, H * answer.speed_mps);  // semi-implicit: the new speed moves it
  }
}

TEST(Loco1dTest, RotaryInertiaSlowsAccelerationButNotTheAdhesionLimit) {
  loco::Loco1d locomotive({kMass_kg, kMass_kg + 6 * 5000.0, 0.35});
  loco::LocoForce force = makeForce();
  force.traction_reference_N = 560e3;
  loco::LocoTraction answer;
  locomotive.step({0.0, 0.0}, force, answer);
  EXPECT_NEAR(answer.traction_N, 460.089e3, 0.5);
  EXPECT_DOUBLE_EQ(answer.speed_mps, 0.002 * answer.traction_N / 164000.0);
}

TEST(Loco1dTest, WorkAtTheRimIsForceTimesMeanSpeed) {
  loco::Loco1d locomotive = makeLoco();
  loco::LocoForce force = makeForce();
  force.traction_reference_N = 200e3;
  loco::LocoTraction answer;
  locomotive.step({0.0, 4.0}, force, answer);
  EXPECT_DOUBLE_EQ(answer.work_rim_J, 200e3 * 0.5 * (4.0 + answer.speed_mps) * 0.002);
  EXPECT_EQ(answer.work_slip_J, 0.0);
}

TEST(Loco1dTest, IsAPureFunctionOfStateAndForce) {
  loco::Loco1d used = makeLoco();
  loco::Loco1d fresh = makeLoco();
  loco::LocoForce force = makeForce();
  force.traction_reference_N = 300e3;
  loco::LocoTraction first, again;
  used.step({5.0, 1.0}, makeForce(), first);
  used.step({17.0, 3.0}, force, first);
  fresh.step({17.0, 3.0}, force, again);
  EXPECT_TRUE(loco::samePayload(first, again));
}

loco::LocoTraction stepOnce(double v_mps, const loco::LocoForce& force) {
  loco::Loco1d locomotive = makeLoco();
  loco::LocoTraction answer;
  locomotive.step({0.0, v_mps}, force, answer);
  return answer;
}

TEST(Loco1dTest, TheDynamicBrakeIsLimitedByAdhesionAndNeverDrivesBackwards) {
  loco::LocoForce force = makeForce();
  force.traction_reference_N = -560e3;
  EXPECT_NEAR(stepOnce(10.0, force).traction_N, -460.089e3, 0.5);
  EXPECT_LT(stepOnce(10.0, force).work_rim_J, 0.0);
  EXPECT_NEAR(stepOnce(0.25, force).traction_N, -0.5 * 460.089e3, 0.5);  // (A11): half of 0.5 m/s
  EXPECT_EQ(stepOnce(0.0, force).traction_N, 0.0);
  EXPECT_EQ(stepOnce(-1.0, force).traction_N, 0.0);
}

TEST(Loco1dTest, ShoesHoldOnAGradeAndBrakeBothWays) {
  loco::LocoForce force = makeForce();
  force.shoe_force_N = 30e3;
  for (const double grade_N : {-20e3, 20e3}) {
    force.grade_N = grade_N;
    const loco::LocoTraction answer = stepOnce(0.0, force);
    EXPECT_EQ(answer.speed_mps, 0.0);
    EXPECT_EQ(answer.traction_N, -grade_N);
    EXPECT_EQ(answer.work_shoes_J, 0.0);
  }
  force.grade_N = 0.0;
  EXPECT_EQ(stepOnce(5.0, force).traction_N, -30e3);
  EXPECT_EQ(stepOnce(-5.0, force).traction_N, 30e3);
  force.grade_N = -40e3;  // more than they have
  EXPECT_DOUBLE_EQ(stepOnce(0.0, force).speed_mps, -0.002 * 10e3 / kMass_kg);
}

TEST(Loco1dTest, ShoesStopItInTheComputedTimeWithoutReversingAndTakeAllOfItsEnergy) {
  loco::Loco1d locomotive = makeLoco();
  loco::LocoForce force = makeForce();
  force.shoe_force_N = 67e3;  // 0.5 m/s^2
  loco::LocoTraction answer;
  std::vector<double> state = {100.0, 10.0};
  double work_J = 0.0;
  int moving = 0;
  for (int i = 0; i < 11000; ++i) {
    locomotive.step(state, force, answer);
    state = answer.state;
    work_J += answer.work_shoes_J;
    ASSERT_GE(answer.speed_mps, 0.0);
    moving += answer.speed_mps > 0.0 ? 1 : 0;
  }
  EXPECT_EQ(answer.speed_mps, 0.0);
  EXPECT_NEAR(0.002 * moving, 20.0, 0.0021);                     // v/a, to a step
  EXPECT_NEAR(answer.location_m - 100.0, 100.0, 0.0101);         // v^2/(2 a); (T5) is late by half a step
  EXPECT_NEAR(work_J, 0.5 * kMass_kg * 100.0, 1e-9 * kMass_kg);  // round-off
}

TEST(Loco1dTest, ShoesAndMotorsTogetherFindTheSameAdhesion) {
  loco::LocoForce force = makeForce();
  force.shoe_force_N = 300e3;
  force.traction_reference_N = -400e3;
  EXPECT_NEAR(stepOnce(10.0, force).traction_N, -460.089e3, 0.5);
  force.traction_reference_N = 460e3;  // against each other the rail feels the difference
  EXPECT_NEAR(stepOnce(10.0, force).traction_N, 160e3, 0.5);
  force.traction_reference_N = 0.0;
  force.shoe_force_N = 900e3;
  EXPECT_NEAR(stepOnce(10.0, force).traction_N, -460.089e3, 0.5);
}

}  // namespace
