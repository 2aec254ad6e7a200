#include "loco_dynamics/contact/hertz.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using loco::HertzContact;

constexpr double kPi = 3.14159265358979323846;

/// Wheel radius 0.5335 m, hollow by 2.25 1/m, on a crown of 0.3 m: the 2D locomotive's contact.
HertzContact paperContact() { return {{1.0 / 0.5335, 1.0 / 0.3 - 2.25}, {210e9, 0.28}}; }
constexpr double kLoad = 134e3 * 9.81 / 12.0;  // the 109.5 kN of physics.md, to whose last digit the ellipse is given

TEST(HertzTest, PaperContactHasTheEllipseOfPhysicsSection4) {
  const HertzContact::Ellipse ellipse = paperContact().computeEllipse(kLoad);
  EXPECT_NEAR(ellipse.a_m, 6.612e-3, 0.5e-6);  // the last digit given
  EXPECT_NEAR(ellipse.b_m, 9.525e-3, 0.5e-6);
}

TEST(HertzTest, PaperContactHasTheApproachAndStiffnessOfPhysicsSection4) {
  const double delta = paperContact().computeApproach(kLoad);
  EXPECT_NEAR(delta, 0.0901e-3, 0.05e-6);  // the last digit given
  EXPECT_NEAR(paperContact().computeTangentStiffness(delta), 1.82e9, 0.005e9);
}

TEST(HertzTest, SphereOnPlaneIsACircleOfRadiusCubeRootOf3NROver4E) {
  const double radius = 0.4, reduced = 210e9 / (2.0 * (1.0 - 0.28 * 0.28)), load = 5e4;
  const HertzContact contact({1.0 / radius, 1.0 / radius}, {210e9, 0.28});
  const double a = std::cbrt(3.0 * load * radius / (4.0 * reduced));
  // round-off of some 50 operations
  EXPECT_NEAR(contact.computeEllipse(load).a_m, a, 1e-13 * a);
  EXPECT_NEAR(contact.computeEllipse(load).b_m, a, 1e-13 * a);
  EXPECT_NEAR(contact.computeApproach(load), a * a / radius, 1e-12 * a * a / radius);
}

/// Gap h = A x^2 + B y^2 and pressure must agree: by integrals found by quadrature, not by the mean that the code uses.
TEST(HertzTest, EllipseSatisfiesTheIntegralsOfTheEllipticPressure) {
  const double along = 1.0 / 0.46, across = 0.3;
  const HertzContact contact({along, across}, {200e9, 0.3});
  const auto [a, b] = contact.computeEllipse(8e4);
  const double reduced = 200e9 / (2.0 * (1.0 - 0.09)), p0 = 3.0 * 8e4 / (2.0 * kPi * a * b);
  // Johnson Eqs. (3.41), (3.42) with w = (b tan t)^2
  const int steps = 400;
  double A = 0.0, B = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double t = (i + 0.5) * 0.5 * kPi / steps;
    const double cos2 = std::cos(t) * std::cos(t), sin2 = std::sin(t) * std::sin(t);
    const double part = p0 * a * b / reduced * 0.5 * kPi / steps / std::pow(a * a * cos2 + b * b * sin2, 1.5);
    A += cos2 * part;
    B += sin2 * part;
  }
  EXPECT_NEAR(A, 0.5 * along, 1e-12 * along);  // the midpoint rule is exact for a smooth periodic integrand
  EXPECT_NEAR(B, 0.5 * across, 1e-12 * across);
}

TEST(HertzTest, TurningBothCurvaturesSwapsTheAxes) {
  const HertzContact one({2.0, 0.5}, {}), other({0.5, 2.0}, {});
  EXPECT_EQ(one.computeEllipse(1e5).a_m, other.computeEllipse(1e5).b_m);
  EXPECT_EQ(one.computeEllipse(1e5).b_m, other.computeEllipse(1e5).a_m);
  EXPECT_LT(one.computeEllipse(1e5).a_m, one.computeEllipse(1e5).b_m);  // the stronger curvature, the shorter axis
}

TEST(HertzTest, ForceAndApproachAreInverse) {
  const HertzContact contact = paperContact();
  for (const double load : {1.0, 1e3, 1e5, 3e5}) {
    EXPECT_NEAR(contact.computeNormalForce(contact.computeApproach(load)), load, 1e-13 * load);  // round-off
  }
}

TEST(HertzTest, BodiesApartCarryNothing) {
  EXPECT_EQ(paperContact().computeNormalForce(0.0), 0.0);
  EXPECT_EQ(paperContact().computeNormalForce(-1e-4), 0.0);
  EXPECT_EQ(paperContact().computeTangentStiffness(-1e-4), 0.0);
}

TEST(HertzTest, StiffnessIsTheSlopeOfTheForce) {
  const HertzContact contact = paperContact();
  const double delta = 9e-5, h = 1e-9;
  const double slope = (contact.computeNormalForce(delta + h) - contact.computeNormalForce(delta - h)) / (2.0 * h);
  EXPECT_NEAR(contact.computeTangentStiffness(delta), slope, 1e-7 * slope);  // round-off over h
}

}  // namespace
