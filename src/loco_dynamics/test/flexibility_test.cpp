#include "loco_dynamics/contact/flexibility.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "contact_fixtures.hpp"

namespace {

using loco::Creepage;
using loco::Flexibilities;

constexpr double kMu = 0.35;

Flexibilities three() { return loco::computeFlexibilities(fixtures::tablePatch()); }
Flexibilities blended(const Creepage& creepage) {
  return loco::blendFlexibilities(three(), fixtures::tablePatch(), creepage, kMu);
}

TEST(FlexibilityTest, AreKalkersForTheTablesEllipse) {
  const loco::KalkerCoefficients c = fixtures::tablePatch().kalker;
  EXPECT_NEAR(three().l1, 8.0 * 6e-3 / (3.0 * c.c11 * 82e9), 1e-28);  // round-off of 4e-14
  EXPECT_NEAR(three().l2, 8.0 * 6e-3 / (3.0 * c.c22 * 82e9), 1e-28);
  EXPECT_NEAR(three().l3, 3.14159265358979 * 6e-3 * std::sqrt(1.5) / (4.0 * c.c23 * 82e9), 1e-27);
}

TEST(FlexibilityTest, BlendIsThreeWithoutCreepageAndOneInFullSlip) {
  EXPECT_EQ(blended({}).l1, three().l1);
  EXPECT_NEAR(blended({1e-9, 1e-9, 1e-7, 0}).l2, three().l2, 1e-6 * three().l2);
  const Flexibilities sliding = blended({0.05, 0.03, 1.0, 0});
  EXPECT_NEAR(sliding.l1, sliding.l2, 1e-12 * sliding.l1);  // round-off
  EXPECT_NEAR(sliding.l1, sliding.l3, 1e-12 * sliding.l1);
}

TEST(FlexibilityTest, OneCreepageAloneKeepsItsOwn) {
  for (const double size : {1e-4, 1e-2, 1.0}) {
    EXPECT_NEAR(blended({size, 0, 0, 0}).l1, three().l1, 1e-12 * three().l1);
    EXPECT_NEAR(blended({0, -size, 0, 0}).l2, three().l2, 1e-12 * three().l2);
    EXPECT_NEAR(blended({0, 0, 100.0 * size, 0}).l3, three().l3, 1e-12 * three().l3);
  }
}

/// One third of the way to full slip is the characteristic creepage, here 5.8227e-3 (in mm for spin).
TEST(FlexibilityTest, BlendGoesLinearlyToThreeCharacteristicCreepages) {
  const loco::KalkerCoefficients c = fixtures::tablePatch().kalker;
  const double scale = kMu * 100e3 / (24e-6 * 82e9);
  const double characteristic = std::hypot(scale / c.c11, scale / c.c22, scale / (std::sqrt(24.0) * c.c23));
  EXPECT_NEAR(characteristic, 5.82e-3, 0.01e-3);
  const double a = blended({0.6 * characteristic, 0.8 * characteristic, 0, 0}).l1;
  const double b = blended({1.2 * characteristic, 1.6 * characteristic, 0, 0}).l1;
  const double one = 1.0 / (0.36 / three().l1 + 0.64 / three().l2);
  EXPECT_NEAR(a, three().l1 + (one - three().l1) / 3.0, 1e-12 * one);  // round-off
  EXPECT_NEAR(b, three().l1 + (one - three().l1) * 2.0 / 3.0, 1e-12 * one);
}

TEST(FlexibilityTest, SpinWeighsByItsShareOfTheStress) {
  // xi_x = 3 pi a phi/32 weighs as much as the spin phi
  const double phi = 1000.0, xi = 3.0 * 3.14159265358979 * 6e-3 * phi / 32.0;
  EXPECT_NEAR(blended({xi, 0, phi, 0}).l2, 2.0 / (1.0 / three().l1 + 1.0 / three().l3), 1e-12 * three().l1);
}

}  // namespace
