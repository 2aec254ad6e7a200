#include "loco_dynamics/contact/creep_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "contact_fixtures.hpp"

namespace {

using loco::ContactPatch;
using loco::CreepForce;
using loco::CreepLaw;
using loco::CreepLawParameters;
using loco::CreepMethod;

/// Table 1 of the paper with the identified B.
CreepLawParameters table1(CreepMethod method) {
  CreepLawParameters parameters;
  parameters.method = method;
  parameters.friction = {0.35, 0.40, 0.275};
  parameters.reduction = {0.075, 0.0008, 0.30};
  parameters.polach = {0.3, 0.1};
  return parameters;
}

constexpr CreepMethod kAllMethods[] = {CreepMethod::kModfastsim, CreepMethod::kFastsim, CreepMethod::kClosed,
                                       CreepMethod::kPolach};

TEST(CreepLawTest, NoLoadAndNoCreepageGiveNoForce) {
  for (const CreepMethod method : kAllMethods) {
    const CreepLaw law(table1(method));
    ContactPatch unloaded = fixtures::tablePatch();
    unloaded.normal_N = 0.0;
    const CreepForce no_load = law.computeForce(unloaded, {0.01, 0.02, 0.0, 0.1});
    EXPECT_EQ(no_load.x_N, 0.0);
    EXPECT_EQ(no_load.y_N, 0.0);
    const CreepForce rolling = law.computeForce(fixtures::tablePatch(), {});
    EXPECT_EQ(rolling.x_N, 0.0);
    EXPECT_EQ(rolling.y_N, 0.0);
    EXPECT_EQ(rolling.friction, 0.35);
  }
}

TEST(CreepLawTest, RacingWheelsPullAMu0N) {
  for (const CreepMethod method : kAllMethods) {
    CreepLawParameters parameters = table1(method);
    parameters.reduction.alpha_inf = 1.0;  // with Table 1's the contact does not slip fully even at 80
    const CreepForce force = CreepLaw(parameters).computeForce(fixtures::tablePatch(), {-80.0, 0.0, 0.0, 800.0});
    // Polach's arc tangent comes within 2e-4 at this creepage
    EXPECT_NEAR(force.x_N, 0.40 * 0.35 * 100e3, method == CreepMethod::kPolach ? 3.0 : 1e-9);
  }
}

TEST(CreepLawTest, MirroredCreepageGivesTheMirroredForce) {
  for (const CreepMethod method : kAllMethods) {
    const double phi = method == CreepMethod::kClosed ? 0.0 : 0.7;
    const CreepLaw law(table1(method));
    const CreepForce left = law.computeForce(fixtures::tablePatch(), {0.004, 0.003, phi, 0.05});
    const CreepForce right = law.computeForce(fixtures::tablePatch(), {0.004, -0.003, -phi, 0.05});
    EXPECT_EQ(left.x_N, right.x_N);
    EXPECT_EQ(left.y_N, -right.y_N);
    EXPECT_LT(left.x_N, 0.0);
    EXPECT_LT(left.y_N, 0.0);
  }
}

TEST(CreepLawTest, ForceIsOddInCreepage) {
  for (const CreepMethod method : kAllMethods) {
    const CreepLaw law(table1(method));
    const CreepForce plus = law.computeForce(fixtures::tablePatch(), {0.004, 0.003, 0.2, 0.05});
    const CreepForce minus = law.computeForce(fixtures::tablePatch(), {-0.004, -0.003, -0.2, 0.05});
    EXPECT_EQ(plus.x_N, -minus.x_N);
    EXPECT_EQ(plus.y_N, -minus.y_N);
  }
}

TEST(CreepLawTest, ClosedFormIsModfastsimWithoutItsGrid) {
  CreepLawParameters fine = table1(CreepMethod::kModfastsim);
  fine.cells = fine.strips = 400;
  const CreepLaw grid(fine), closed(table1(CreepMethod::kClosed));
  for (const double xi : {-0.3, -0.07, -0.01, 0.002, 0.05}) {
    const loco::Creepage creepage{xi, 0.0, 0.0, 10.0 * std::abs(xi)};
    const CreepForce a = grid.computeForce(fixtures::tablePatch(), creepage);
    const CreepForce b = closed.computeForce(fixtures::tablePatch(), creepage);
    EXPECT_NEAR(a.x_N, b.x_N, 2e-5 * 35e3);  // a grid of 400
    EXPECT_EQ(a.reduction, b.reduction);
    EXPECT_EQ(a.friction, b.friction);
  }
}

TEST(CreepLawTest, LongitudinalForceDoesNotDependOnTheFlexibilityRule) {
  CreepLawParameters three = table1(CreepMethod::kModfastsim);
  three.flexibility = loco::FlexibilityRule::kThree;
  const loco::Creepage creepage{-0.02, 0.0, 0.0, 0.2};
  EXPECT_NEAR(CreepLaw(three).computeForce(fixtures::tablePatch(), creepage).x_N,
              CreepLaw(table1(CreepMethod::kModfastsim)).computeForce(fixtures::tablePatch(), creepage).x_N, 1e-9);
}

TEST(CreepLawTest, BlendedFlexibilityTurnsTheForceAgainstTheSlipInFullSlip) {
  const loco::Creepage sliding{0.05, 0.02, 0.0, 0.0};
  CreepLawParameters parameters = fixtures::coulomb(CreepMethod::kFastsim, 0.35);
  const CreepForce blended = CreepLaw(parameters).computeForce(fixtures::tablePatch(), sliding);
  EXPECT_NEAR(blended.y_N / blended.x_N, 0.4, 1e-12);
  parameters.flexibility = loco::FlexibilityRule::kThree;
  const CreepForce three = CreepLaw(parameters).computeForce(fixtures::tablePatch(), sliding);
  const loco::KalkerCoefficients& c = fixtures::tablePatch().kalker;
  EXPECT_NEAR(three.y_N / three.x_N, 0.4 * c.c22 / c.c11, 1e-12);
}

/// With Table 1 the 7 % of the paper are below the peak of the curve at all speeds of its run. The peaks' places are
/// those of a second implementation of Eqs. (2), (3) and (C10) with eps/(k0 xi) = 414. (physics.md has them 6 % higher;
/// they belong to a patch with 382.)
TEST(CreepLawTest, PaperContactPeaksBeyond7PercentCreep) {
  const CreepLaw law(table1(CreepMethod::kClosed));
  const ContactPatch patch = loco::makeContactPatch(6.612e-3, 9.525e-3, 109.5e3, 82e9, 0.28);
  const auto peakAt = [&](double v) {
    double best = 0.0, at = 0.0;
    for (double s = 0.01; s < 0.4; s += 0.0001) {
      const double force = law.computeForce(patch, {-s, 0.0, 0.0, v * s}).x_N;
      if (force > best) best = force, at = s;
    }
    return 100.0 * at;
  };
  EXPECT_NEAR(peakAt(1.4), 15.68, 0.03);  // 414 has three digits
  EXPECT_NEAR(peakAt(4.4), 11.47, 0.03);
  EXPECT_NEAR(peakAt(8.3), 9.39, 0.03);
  EXPECT_NEAR(peakAt(14.8), 7.69, 0.03);
}

}  // namespace
