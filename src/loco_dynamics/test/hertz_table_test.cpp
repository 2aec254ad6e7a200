#include "loco_dynamics/contact/hertz_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

TEST(HertzTableTest, IsHertzsContactForCurvaturesOfAnySizeAndRatio) {
  const loco::Elasticity steel{210e9, 0.28};
  const loco::HertzTable table(steel);
  for (const double along : {1.87, 2.5}) {
    for (const double ratio : {0.011, 0.3, 0.9999, 1.0, 1.37, 20.0, 300.0}) {
      const loco::RelativeCurvature curvature{along, along * ratio};
      const loco::HertzContact exact(curvature, steel);
      const loco::HertzTable::Contact c = table.at(curvature);
      const loco::HertzContact::Ellipse unit = exact.computeEllipse(1.0);
      EXPECT_NEAR(c.a_unit, unit.a_m, 1e-5 * unit.a_m) << ratio;
      EXPECT_NEAR(c.b_unit, unit.b_m, 1e-5 * unit.b_m) << ratio;
      EXPECT_NEAR(c.stiffness, exact.computeNormalForce(1.0), 1e-5 * c.stiffness) << ratio;
      const loco::KalkerCoefficients kalker = loco::computeKalkerCoefficients(exact.aOverB(), steel.poisson);
      EXPECT_NEAR(c.kalker.c11, kalker.c11, 1e-4 * kalker.c11) << ratio;  // the table itself has kinks
      EXPECT_NEAR(c.kalker.c22, kalker.c22, 1e-4 * kalker.c22) << ratio;
      EXPECT_NEAR(c.kalker.c23, kalker.c23, 1e-3 * kalker.c23) << ratio;
    }
  }
}

}  // namespace
