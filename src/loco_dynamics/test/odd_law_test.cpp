#include "loco_dynamics/odd_law.hpp"

#include <gtest/gtest.h>

namespace {

/// The centre pin's lateral law: nothing to 2 mm, stiffness rising to 60 kN/m at 40 mm, to 1 GN/m at 41 mm.
loco::OddLaw pin() { return loco::OddLaw({{0.002, 0.0}, {0.040, 0.0, 60e3}, {0.041, 60e3, 1e9 - 60e3}, {0.0, 1e9}}); }

TEST(OddLawTest, AStiffnessThatRisesLinearlyMakesAParabola) {
  EXPECT_EQ(pin()(0.002), 0.0);
  EXPECT_NEAR(pin()(0.021), 0.5 * 30e3 * 0.019, 1e-9);
  EXPECT_NEAR(pin().slope(0.021), 30e3, 1e-9);
  EXPECT_NEAR(pin()(0.040), 1140.0, 1e-9);
  EXPECT_NEAR(pin()(0.041), 1140.0 + 0.5 * (60e3 + 1e9) * 1e-3, 1e-6);
  EXPECT_NEAR(pin()(0.042), pin()(0.041) + 1e6, 1e-6);
  EXPECT_EQ(pin().largestSlope(), 1e9);
}

TEST(OddLawTest, IsOdd) {
  for (const double x : {0.001, 0.03, 0.0405, 0.05}) EXPECT_EQ(pin()(-x), -pin()(x));
}

TEST(OddLawTest, ItsIntegralHasItAsDerivative) {
  for (const double x : {0.01, 0.039, 0.0403, 0.0407, 0.045}) {
    const double d = 1e-7;  // pieces are parabolas: a central difference errs by slope_rise/length d^2/6
    EXPECT_NEAR((pin().integral(x + d) - pin().integral(x - d)) / (2.0 * d), pin()(x), 1e-6 * pin()(x) + 1e-2) << x;
    EXPECT_NEAR((pin()(x + d) - pin()(x - d)) / (2.0 * d), pin().slope(x), 1e-6 * pin().slope(x) + 1e-3) << x;
  }
}

TEST(OddLawTest, StraightPiecesAddUp) {
  const loco::OddLaw damper({{0.032, 143.75e3}, {0.0, 2.2e3}});
  EXPECT_NEAR(damper(0.032), 4600.0, 1e-9);
  EXPECT_NEAR(damper(1.032), 6800.0, 1e-9);
}

}  // namespace
