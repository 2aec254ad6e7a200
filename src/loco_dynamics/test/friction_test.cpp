#include <gtest/gtest.h>

#include <cmath>

#include "contact_fixtures.hpp"
#include "loco_dynamics/contact/creepage.hpp"
#include "loco_dynamics/contact/friction_law.hpp"
#include "loco_dynamics/contact/reduction_factor.hpp"

namespace {

using loco::computeFriction;
using loco::computeReduction;
using loco::computeStressGradient;
using loco::Creepage;

TEST(FrictionLawTest, IsStaticAtRestAndKineticAtHighSlip) {
  EXPECT_EQ(computeFriction({0.35, 0.4, 0.275}, 0.0), 0.35);
  EXPECT_NEAR(computeFriction({0.35, 0.4, 0.275}, 200.0), 0.4 * 0.35, 1e-15);  // e^-55 of it is left
}

TEST(FrictionLawTest, FallsBy1OverEOfItsRangeAtSlip1OverB) {
  EXPECT_NEAR(computeFriction({0.5, 0.2, 0.25}, 4.0), 0.5 * (0.8 / std::exp(1.0) + 0.2), 1e-15);  // round-off
}

TEST(FrictionLawTest, DoesNotFallWithAOf1) { EXPECT_NEAR(computeFriction({0.3, 1.0, 5.0}, 7.0), 0.3, 1e-16); }

TEST(ReductionTest, GradientOfThePaperContactIs414k0Xi) {
  const loco::ContactPatch patch = loco::makeContactPatch(6.612e-3, 9.525e-3, 109.5e3, 82e9, 0.28);
  const double eps = computeStressGradient(0.075, patch, {0.01, 0.0, 0.0, 0.0}, 0.35);
  EXPECT_NEAR(eps / (0.075 * 0.01), 414.0, 0.5);  // the last digit given
}

TEST(ReductionTest, GradientTakesTheLargerLateralCreepage) {
  const loco::ContactPatch patch = fixtures::tablePatch();
  const auto eps = [&patch](double xi_y, double phi) {
    return computeStressGradient(1.0, patch, Creepage{0.0, xi_y, phi, 0.0}, 0.3);
  };
  EXPECT_NEAR(eps(0.002, 0.5), eps(0.005, 0.0), 1e-12);   // 0.002 + 0.5 x 6 mm
  EXPECT_NEAR(eps(0.002, -0.5), eps(0.002, 0.0), 1e-12);  // 0.002 - 0.003 is smaller
  EXPECT_NEAR(eps(0.002, -1.0), eps(0.004, 0.0), 1e-12);  // 0.002 - 0.006 is larger again
  EXPECT_NEAR(eps(0.0, 1.0), eps(0.006, 0.0), 1e-12);
}

TEST(ReductionTest, FallsFromK0ToK0AlphaInf) {
  const loco::ReductionFactor table1{0.075, 0.0008, 0.30};
  EXPECT_EQ(computeReduction(table1, 0.0), 0.075);
  EXPECT_NEAR(computeReduction(table1, 1e12), 0.075 * 0.0008, 1e-12);
  EXPECT_NEAR(computeReduction(table1, 1.0 / 0.30), 0.075 * (0.0008 + 0.9992 / 2.0), 1e-16);
}

TEST(CreepageTest, SlipSpeedHasNoFloorButCreepageHas) {
  const Creepage slow = loco::computeCreepage({-0.03, 0.04, 0.5}, 0.1);
  EXPECT_NEAR(slow.xi_x, -0.06, 1e-15);  // over 0.5 m/s
  EXPECT_NEAR(slow.xi_y, 0.08, 1e-15);
  EXPECT_NEAR(slow.phi_1pm, 1.0, 1e-15);
  EXPECT_NEAR(slow.slip_speed_mps, 0.05, 1e-15);
  const Creepage fast = loco::computeCreepage({-0.03, 0.04, 0.5}, -10.0);  // a speed's sign does not matter
  EXPECT_NEAR(fast.xi_x, -0.003, 1e-15);
  EXPECT_NEAR(fast.phi_1pm, 0.05, 1e-15);
  EXPECT_NEAR(fast.slip_speed_mps, 0.05, 1e-15);
}

}  // namespace
