#include "loco_dynamics/contact/closed_form.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "contact_fixtures.hpp"
#include "rail_core/testing/verification.hpp"

namespace {

using loco::computeClosedForm;
using loco::CreepMethod;

constexpr double kPi = 3.14159265358979323846;

TEST(ClosedFormTest, HasTheValuesOfAnIndependentComputation) {
  const auto check = [](double x, double expected) {
    char what[48];
    std::snprintf(what, sizeof what, "F/(mu N) at x = %g", x);
    rail::verify(
        {"2", what, "closed form by other hands", "1", expected, computeClosedForm(x), 0.5e-5, "last digit given"});
  };
  check(0.05, 0.06227);
  check(0.2, 0.23286);
  check(0.5, 0.50717);
  check(1.0, 0.79963);
  check(1.3, 0.89889);
  check(2.0, 0.99161);
}

TEST(ClosedFormTest, SlipsFullyFrom8Over3On) {
  rail::verify({"2", "F/(mu N) at x = 8/3, full slip", "exact", "1", 1.0, computeClosedForm(8.0 / 3.0), 0.0, "exact"});
  EXPECT_EQ(computeClosedForm(100.0), 1.0);
  EXPECT_LT(computeClosedForm(8.0 / 3.0 - 0.05), 1.0 - 1e-7);
  EXPECT_NEAR(computeClosedForm(8.0 / 3.0 - 1e-6), 1.0, 1e-12);  // meets full slip with slope 0
}

TEST(ClosedFormTest, StartsWithSlope4Over3TimesSimplifiedTheorysAdhesion) {
  EXPECT_EQ(computeClosedForm(0.0), 0.0);
  // sticking everywhere but at the trailing edge: p = rise (distance from the leading edge); with L1 this is Kalker's
  // force G a b C11 xi = (4/pi) x mu N
  EXPECT_NEAR(computeClosedForm(1e-6) / 1e-6, 4.0 / kPi, 2e-6);  // the slip area takes its share in proportion to x
}

TEST(ClosedFormTest, LateralCreepIsLongitudinalCreepOfAnotherFlexibility) {
  loco::ContactPatch patch = fixtures::tablePatch();
  const loco::Flexibilities flexibility = loco::computeFlexibilities(patch);
  const loco::PlaneForce x =
      loco::computeClosedForce(patch, flexibility, {0.004 * flexibility.l1 / flexibility.l2, 0, 0, 0}, 0.3);
  const loco::PlaneForce y = loco::computeClosedForce(patch, flexibility, {0.0, 0.004, 0, 0}, 0.3);
  EXPECT_NEAR(x.x_N, y.y_N, 1e-9);  // round-off of 20 kN
  EXPECT_EQ(x.y_N, 0.0);
  EXPECT_EQ(y.x_N, 0.0);
  EXPECT_LT(y.y_N, 0.0);  // opposes the slip of the wheel
}

TEST(ClosedFormTest, IsTheLimitOfFastsimWithBothCreepages) {
  const auto closed = fixtures::coulomb(CreepMethod::kClosed, 0.35);
  const auto grid = fixtures::coulomb(CreepMethod::kFastsim, 0.35, 400, 400);
  const loco::CreepLaw exact(closed), fine(grid);
  for (const double xi : {2e-4, 1e-3, 3e-3, 6e-3, 1e-2}) {
    const loco::Creepage creepage{-xi, 0.6 * xi, 0.0, 0.0};
    const loco::CreepForce e = exact.computeForce(fixtures::tablePatch(), creepage);
    const loco::CreepForce f = fine.computeForce(fixtures::tablePatch(), creepage);
    EXPECT_NEAR(e.x_N, f.x_N, 1e-5 * 35e3);  // the grid's error falls with the square of 400 cells
    EXPECT_NEAR(e.y_N, f.y_N, 1e-5 * 35e3);
  }
}

}  // namespace
