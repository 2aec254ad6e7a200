#include "ltd_sim/coupler.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rail_core/testing/verification.hpp"
#include "train_fixtures.hpp"

namespace {

using fixtures::draftGear;
using ltd::Coupler;

// The draft gear: 10 mm of slack each way, then 4 MN/m to 30 mm, 30 MN/m to 80 mm, 80 MN/m. Loading force and its
// integral at the knots (deflection from the end of the slack), by hand.
constexpr double kSlackEnd = 0.010;
constexpr double kForce30 = 4e6 * 0.030;                                         // 120 kN
constexpr double kForce80 = kForce30 + 30e6 * 0.050;                             // 1620 kN
constexpr double kEnergy30 = 0.5 * kForce30 * 0.030;                             // 1.8 kJ
constexpr double kEnergy80 = kEnergy30 + 0.5 * (kForce30 + kForce80) * 0.050;    // 45.3 kJ
constexpr double kForce100 = kForce80 + 80e6 * 0.020;                            // 3220 kN
constexpr double kEnergy100 = kEnergy80 + 0.5 * (kForce80 + kForce100) * 0.020;  // 93.7 kJ
constexpr double kFast = 10.0;  // m/s: tanh(500) is 1 in double precision

// Knot forces to round-off: |x| - slack/2 is off by an ulp of 0.1 m, times 80 MN/m.
constexpr double kForceTolerance_N = 1e-8;

TEST(CouplerTest, HasNoForceWithinTheSlackWhateverTheSpeed) {
  const Coupler coupler(draftGear());
  for (const double x : {-0.010, -0.005, 0.0, 0.005, 0.010}) {
    for (const double speed : {-1.0, 0.0, 1.0}) {
      const Coupler::Force force = coupler.computeForce(x, speed);
      EXPECT_EQ(force.force_N, 0.0);
      EXPECT_EQ(force.mean_N, 0.0);
      EXPECT_EQ(force.friction_N_s_per_m, 0.0);
    }
    EXPECT_EQ(coupler.computeStoredEnergy(x), 0.0);
  }
}

TEST(CouplerTest, LoadsAndUnloadsThroughTheKnots) {
  const Coupler coupler(draftGear());
  const struct {
    double deflection_m, force_N;
  } knots[] = {{0.015, 60e3}, {0.030, kForce30}, {0.080, kForce80}, {0.100, kForce100}};
  for (const auto& knot : knots) {
    const double x = kSlackEnd + knot.deflection_m;
    EXPECT_NEAR(coupler.computeForce(x, kFast).force_N, knot.force_N, kForceTolerance_N);
    EXPECT_NEAR(coupler.computeForce(x, -kFast).force_N, 0.45 * knot.force_N, kForceTolerance_N);
    EXPECT_NEAR(coupler.computeForce(x, 0.0).force_N, 0.725 * knot.force_N, kForceTolerance_N);
    EXPECT_NEAR(coupler.computeForce(x, 0.0).mean_N, 0.725 * knot.force_N, kForceTolerance_N);
  }
}

TEST(CouplerTest, TensionIsPositiveAndTheForceIsOddInElongationAndSpeed) {
  const Coupler coupler(draftGear());
  EXPECT_GT(coupler.computeForce(0.02, 0.0).force_N, 0.0);
  for (const double x : {0.005, 0.012, 0.04, 0.06, 0.2}) {
    for (const double speed : {-0.3, -0.01, 0.0, 0.01, 0.3}) {
      EXPECT_EQ(coupler.computeForce(-x, -speed).force_N, -coupler.computeForce(x, speed).force_N);
      EXPECT_EQ(coupler.computeForce(-x, -speed).mean_N, -coupler.computeForce(x, speed).mean_N);
      EXPECT_EQ(coupler.computeForce(-x, speed).friction_N_s_per_m, coupler.computeForce(x, speed).friction_N_s_per_m);
    }
  }
}

TEST(CouplerTest, SmoothingTurnsTheFrictionRoundWithinItsSpeed) {
  const Coupler coupler(draftGear());
  const double x = kSlackEnd + 0.030;
  EXPECT_NEAR(coupler.computeForce(x, 0.02).force_N, kForce30 * (0.725 + 0.275 * std::tanh(1.0)), kForceTolerance_N);
}

TEST(CouplerTest, FrictionCoefficientIsTheLargestSlopeOverSpeed) {
  const Coupler coupler(draftGear());
  const double x = kSlackEnd + 0.080;
  const double analytic = 0.5 * (1.0 - 0.45) * kForce80 / 0.02;
  EXPECT_NEAR(coupler.computeForce(x, 0.0).friction_N_s_per_m, analytic, 1e-9 * analytic);
  const double e = 1e-6;  // central difference of tanh: error (e/vs)^2/3 = 8e-10
  const double slope = (coupler.computeForce(x, e).force_N - coupler.computeForce(x, -e).force_N) / (2.0 * e);
  EXPECT_NEAR(slope, analytic, 1e-8 * analytic);
}

TEST(CouplerTest, StoredEnergyIsTheIntegralOfTheMeanForce) {
  const Coupler coupler(draftGear());
  EXPECT_NEAR(coupler.computeStoredEnergy(kSlackEnd + 0.100), 0.725 * kEnergy100, 1e-8);  // round-off of 68 kJ
  for (const double x : {-0.16, -0.075, -0.02, 0.02, 0.03, 0.06, 0.12}) {
    const double e = 1e-6;  // within a straight piece a central difference of a parabola is exact: round-off only,
    const double slope = (coupler.computeStoredEnergy(x + e) - coupler.computeStoredEnergy(x - e)) / (2.0 * e);
    EXPECT_NEAR(slope, coupler.computeForce(x, 0.0).mean_N, 1e-2) << x;  // 1e-11 J of 70 kJ over 2e-6 m: 1e-5 N
  }
}

/// Energy that goes into the coupler in one cycle from rest to `amplitude` and back, at constant speed.
double energyOfCycle(const Coupler& coupler, double amplitude, double speed) {
  constexpr int kPieces = 200000;  // midpoint rule, the kinks lie on boundaries: exact but for round-off
  double energy_J = 0.0;
  const double dx = amplitude / kPieces;
  for (int i = 0; i < kPieces; ++i) {
    const double x = (i + 0.5) * dx;
    const double outwards = amplitude > 0.0 ? speed : -speed;
    energy_J += (coupler.computeForce(x, outwards).force_N - coupler.computeForce(x, -outwards).force_N) * dx;
  }
  return energy_J;
}

TEST(CouplerTest, ACycleInBuffAndOneInDraftDissipateTheSamePositiveEnergy) {
  const Coupler coupler(draftGear());
  const double draft_J = energyOfCycle(coupler, kSlackEnd + 0.100, kFast);
  const double buff_J = energyOfCycle(coupler, -kSlackEnd - 0.100, kFast);
  rail::verify({"2", "the paper's coupler, drawn 100 mm and back: loss", "(1 - u) times the loading integral", "J",
                (1.0 - 0.45) * kEnergy100, draft_J, 1e-6 * kEnergy100, "the sum of 200000 pieces"});
  rail::verify({"2", "the paper's coupler, pushed 100 mm and back: loss", "the same in draft", "J", draft_J, buff_J,
                1e-9 * draft_J, "round-off"});
}

TEST(CouplerTest, NeverMakesEnergyWhateverTheMotion) {
  const Coupler coupler(draftGear());
  for (double x = -0.15; x <= 0.15; x += 0.0037) {
    for (double speed = -0.5; speed <= 0.5; speed += 0.0131) {
      const Coupler::Force force = coupler.computeForce(x, speed);
      EXPECT_GE((force.force_N - force.mean_N) * speed, 0.0) << x << " " << speed;
      EXPECT_GE(force.force_N * x, 0.0);  // it never pushes out in draft
    }
  }
}

TEST(CouplerTest, DeflectionAtInvertsTheLoadingCurve) {
  const Coupler coupler(draftGear());
  EXPECT_EQ(coupler.deflectionAt(0.0), 0.0);
  EXPECT_NEAR(coupler.deflectionAt(kForce30), 0.030, 1e-15);
  EXPECT_NEAR(coupler.deflectionAt(kForce80), 0.080, 1e-15);
  for (const double force_N : {1e3, 119e3, 121e3, 1e6, 1.7e6, 5e6})
    EXPECT_NEAR(coupler.computeForce(kSlackEnd + coupler.deflectionAt(force_N), kFast).force_N, force_N, 1e-7);
}

TEST(CouplerTest, StiffnessUpToAForceIsThatOfThePiecesBelowIt) {
  const Coupler coupler(draftGear());
  EXPECT_EQ(coupler.stiffnessUpTo(0.0), 4e6);
  EXPECT_EQ(coupler.stiffnessUpTo(100e3), 4e6);
  EXPECT_EQ(coupler.stiffnessUpTo(121e3), 30e6);
  EXPECT_EQ(coupler.stiffnessUpTo(1.7e6), 80e6);
}

std::string text(const std::string& loading, const std::string& rest = "unloading_ratio: 0.45") {
  return "{name: test, slack_m: 0.02, smoothing_speed_mps: 0.02, " + rest + ", loading: [" + loading + "]}";
}
const std::string kGoodLoading = "{up_to_m: 0.03, stiffness_N_per_m: 4.0e6}, {stiffness_N_per_m: 30.0e6}";

TEST(CouplerReadTest, ReadsWhatStandsThere) {
  const Coupler::Parameters p = fixtures::readMap(text(kGoodLoading), Coupler::read);
  EXPECT_EQ(p.slack_m, 0.02);
  EXPECT_EQ(p.unloading_ratio, 0.45);
  EXPECT_EQ(p.smoothing_speed_mps, 0.02);
  ASSERT_EQ(p.loading.size(), 2u);
  EXPECT_EQ(p.loading[0].up_to_m, 0.03);
  EXPECT_EQ(p.loading[0].stiffness_N_per_m, 4e6);
  EXPECT_EQ(p.loading[1].stiffness_N_per_m, 30e6);
}

void expectFault(const std::string& map, const std::vector<std::string>& parts) {
  const std::vector<std::string> faults = fixtures::faultsIn(map, Coupler::read);
  EXPECT_EQ(faults.size(), 1u) << fixtures::joined(faults);
  EXPECT_TRUE(fixtures::anyHas(faults, parts)) << fixtures::joined(faults);
}

TEST(CouplerReadTest, RefusesWhatNoCouplerCanBe) {
  expectFault(text(""), {"loading", "at least one piece"});
  expectFault(text("{up_to_m: 0.03, stiffness_N_per_m: 4.0e6}"), {"loading.0.up_to_m = 0.03", "must have no end"});
  expectFault(text("{up_to_m: 0.03, stiffness_N_per_m: 4.0e6}, {up_to_m: 0.02, stiffness_N_per_m: 4.0e6}, "
                   "{stiffness_N_per_m: 4.0e6}"),
              {"loading.1.up_to_m = 0.02", "> 0.03"});
  expectFault(text("{up_to_m: 50, stiffness_N_per_m: 4.0e6}, {stiffness_N_per_m: 30.0e6}"),
              {"loading.0.up_to_m = 50", "> 0 and <= 1"});
  expectFault(text("{stiffness_N_per_m: 4.0e6}, {stiffness_N_per_m: 30.0e6}"), {"loading.0.up_to_m", "is missing"});
  expectFault(text("{stiffness_N_per_m: -4.0e6}"), {"loading.0.stiffness_N_per_m = -4.0e6", "> 0"});
  expectFault(text(kGoodLoading, "unloading_ratio: 0"), {"unloading_ratio = 0", "> 0"});
  expectFault(text(kGoodLoading, "unloading_ratio: 1.1"), {"unloading_ratio = 1.1", "<= 1"});
  expectFault(
      "{name: test, slack_m: -0.02, smoothing_speed_mps: 0.02, unloading_ratio: 1, loading: [" + kGoodLoading + "]}",
      {"slack_m = -0.02", ">= 0"});
  expectFault(
      "{name: test, slack_m: 0.02, smoothing_speed_mps: 0, unloading_ratio: 1, loading: [" + kGoodLoading + "]}",
      {"smoothing_speed_mps = 0", "> 0"});
}

}  // namespace
