#include "ltd_sim/resistance.hpp"

#include <gtest/gtest.h>

#include "rail_core/testing/verification.hpp"
#include "train_fixtures.hpp"

namespace {

using fixtures::paperLoco;
using fixtures::paperWagon;
using ltd::computeCurvingResistance;
using ltd::computeGradeForce;
using ltd::computeHeldResistance;
using ltd::computePropulsionResistance;

// Sums of a few products of decimal numbers: round-off only.
constexpr double kRoundOff = 1e-9;

/// The wagon with one coefficient alone.
rail::Vehicle wagonWith(const rail::ResistanceCoefficients& c) {
  rail::Vehicle vehicle = paperWagon();
  vehicle.resistance = c;
  return vehicle;
}

TEST(ResistanceTest, PaperWagonAtRestHas709Point96N) {
  EXPECT_NEAR(computePropulsionResistance(paperWagon(), 0.0), 120 * 2.943 + 120 * 89.2 / 30, kRoundOff);
  rail::verify({"2", "wagon of 120 t at rest, Eq. (5)", "by hand", "N", 709.96,
                computePropulsionResistance(paperWagon(), 0.0), kRoundOff, "round-off"});
}

TEST(ResistanceTest, WholePaperTrainAtRestHas77Point33kN) {
  const double sum_N =
      105 * computePropulsionResistance(paperWagon(), 0.0) + 3 * computePropulsionResistance(paperLoco(), 0.0);
  rail::verify({"2", "the paper's train at rest, Eq. (5)", "by hand", "N", 77334.486, sum_N, 1e-6, "round-off"});
}

TEST(ResistanceTest, PaperWagonInR300Has2446Point4N) {
  rail::verify({"2", "wagon of 120 t in R300, Eq. (6)", "by hand", "N", 2446.4,
                computeCurvingResistance(paperWagon(), 1.0 / 300.0), kRoundOff, "round-off"});
}

TEST(ResistanceTest, EachTermStandsAloneInItsOwnUnits) {
  const double v_mps = 10.0;  // 36 km/h
  EXPECT_NEAR(computePropulsionResistance(wagonWith({2.943, 0, 0, 0, 0}), v_mps), 120 * 2.943, kRoundOff);
  EXPECT_NEAR(computePropulsionResistance(wagonWith({0, 89.2, 0, 0, 0}), v_mps), 4 * 89.2, kRoundOff);
  EXPECT_NEAR(computePropulsionResistance(wagonWith({0, 0, 0.0306, 0, 0}), v_mps), 120 * 0.0306 * 36, kRoundOff);
  EXPECT_NEAR(computePropulsionResistance(wagonWith({0, 0, 0, 0.122, 0}), v_mps), 0.122 * 36 * 36, kRoundOff);
  EXPECT_EQ(computePropulsionResistance(wagonWith({0, 0, 0, 0, 6116}), v_mps), 0.0);
  EXPECT_EQ(computeCurvingResistance(wagonWith({2.943, 89.2, 0.0306, 0.122, 0}), 1.0 / 300.0), 0.0);
}

TEST(ResistanceTest, PropulsionResistanceIsTheSameInBothDirections) {
  EXPECT_EQ(computePropulsionResistance(paperWagon(), -7.5), computePropulsionResistance(paperWagon(), 7.5));
}

TEST(ResistanceTest, CurvingResistanceIsTheSameInLeftAndRightCurvesAndZeroOnStraightTrack) {
  EXPECT_EQ(computeCurvingResistance(paperWagon(), -1.0 / 400.0), computeCurvingResistance(paperWagon(), 1.0 / 400.0));
  EXPECT_EQ(computeCurvingResistance(paperWagon(), 0.0), 0.0);
}

TEST(ResistanceTest, GradePullsBackUphillAndForwardDownhill) {
  EXPECT_NEAR(computeGradeForce(paperWagon(), 0.01), -120e3 * 9.81 * 0.01, kRoundOff);
  EXPECT_NEAR(computeGradeForce(paperWagon(), -0.01), 120e3 * 9.81 * 0.01, kRoundOff);
  EXPECT_EQ(computeGradeForce(paperWagon(), 0.0), 0.0);
}

constexpr double kMass = 120e3, kStep = 0.002, kLimit = 700.0;

/// Speed at the end of a step with the held resistance.
double speedAfter(double other_N, double v_mps) {
  const double held_N = computeHeldResistance(other_N, kLimit, kMass, v_mps, kStep);
  return v_mps + kStep * (other_N + held_N) / kMass;
}

TEST(HeldResistanceTest, StandingVehicleIsHeldUpToExactlyTheResistance) {
  EXPECT_EQ(computeHeldResistance(699.0, kLimit, kMass, 0.0, kStep), -699.0);
  EXPECT_EQ(computeHeldResistance(700.0, kLimit, kMass, 0.0, kStep), -700.0);
  EXPECT_EQ(speedAfter(699.0, 0.0), 0.0);
  EXPECT_EQ(speedAfter(-699.0, 0.0), 0.0);
}

TEST(HeldResistanceTest, StandingVehicleIsReleasedWithTheExcessAlone) {
  EXPECT_EQ(computeHeldResistance(750.0, kLimit, kMass, 0.0, kStep), -700.0);
  EXPECT_NEAR(speedAfter(750.0, 0.0), kStep * 50.0 / kMass, 1e-18);  // round-off of 8e-7
}

TEST(HeldResistanceTest, MovingVehicleFeelsExactlyTheResistanceWhateverElsePulls) {
  for (const double other_N : {-300.0, 0.0, 300.0, 50e3})
    EXPECT_EQ(computeHeldResistance(other_N, kLimit, kMass, 5.0, kStep), -kLimit) << other_N;
}

TEST(HeldResistanceTest, ComesToRestWithinTheStepAndNotBeyond) {
  // R takes 700 * 0.002 / 120e3 = 11.7 um/s a step: slower than that must stop, not turn round. 120e3 * 1e-5 / 0.002 =
  // 600 N of the 700 do it, up to the round-off of m v / H.
  EXPECT_NEAR(computeHeldResistance(0.0, kLimit, kMass, 1e-5, kStep), -600.0, 1e-9);
  EXPECT_NEAR(speedAfter(0.0, 1e-5), 0.0, 1e-20);
  EXPECT_GT(speedAfter(0.0, 2e-5), 0.0);
}

TEST(HeldResistanceTest, IsOddInForceAndSpeedTogether) {
  for (const double other_N : {-900.0, -50.0, 0.0, 400.0, 2000.0}) {
    for (const double v_mps : {-3.0, -1e-6, 0.0, 1e-5, 0.7}) {
      EXPECT_EQ(computeHeldResistance(-other_N, kLimit, kMass, -v_mps, kStep),
                -computeHeldResistance(other_N, kLimit, kMass, v_mps, kStep));
    }
  }
}

TEST(HeldResistanceTest, WithoutResistanceNothingHolds) {
  EXPECT_EQ(computeHeldResistance(123.0, 0.0, kMass, 0.0, kStep), 0.0);
}

}  // namespace
