#include "loco_dynamics/contact/polach.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "contact_fixtures.hpp"
#include "rail_core/testing/verification.hpp"

namespace {

using loco::CreepLaw;
using loco::CreepMethod;

CreepLaw polach(double mu0, double B, double k_A, double k_S) {
  loco::CreepLawParameters parameters;
  parameters.method = CreepMethod::kPolach;
  parameters.friction = {mu0, 0.40, B};
  parameters.polach = {k_A, k_S};
  return CreepLaw(parameters);
}

/// Magnitude of the force at a creepage of the wheel at 10 m/s.
double forceAt(const CreepLaw& law, double creep) {
  return -law.computeForce(fixtures::tablePatch(), {creep, 0.0, 0.0, 10.0 * creep}).x_N;
}

void checkForce(const std::string& rail, double creep, double expected_N, double computed_N) {
  char what[64];
  std::snprintf(what, sizeof what, "Polach, %s rail, creep %g, 6 x 4 mm, 100 kN, 10 m/s", rail.c_str(), creep);
  rail::verify({"3", what, "independent computation", "N", expected_N, computed_N, 0.5, "whole newtons are given"});
}

TEST(PolachTest, DryRailHasTheForcesThatAnIndependentComputationGives) {
  const CreepLaw dry = polach(0.55, 0.60, 1.0, 0.40);
  checkForce("dry", 0.001, 6425.0, forceAt(dry, 0.001));
  checkForce("dry", 0.005, 25036.0, forceAt(dry, 0.005));
  checkForce("dry", 0.01, 33069.0, forceAt(dry, 0.01));
  checkForce("dry", 0.02, 37959.0, forceAt(dry, 0.02));
  checkForce("dry", 0.05, 41044.0, forceAt(dry, 0.05));
  checkForce("dry", 0.1, 38024.0, forceAt(dry, 0.1));
}

TEST(PolachTest, WetRailHasTheForcesThatAnIndependentComputationGives) {
  const CreepLaw wet = polach(0.30, 0.20, 0.30, 0.10);
  checkForce("wet", 0.001, 1852.0, forceAt(wet, 0.001));
  checkForce("wet", 0.005, 8457.0, forceAt(wet, 0.005));
  checkForce("wet", 0.01, 13578.0, forceAt(wet, 0.01));
  checkForce("wet", 0.02, 17242.0, forceAt(wet, 0.02));
  checkForce("wet", 0.05, 20777.0, forceAt(wet, 0.05));
  checkForce("wet", 0.1, 22810.0, forceAt(wet, 0.1));
}

TEST(PolachTest, SmallCreepagesAndSpinGiveKalkersForces) {
  const loco::ContactPatch patch = fixtures::tablePatch();
  const double gab = 82e9 * 6e-3 * 4e-3;
  const loco::PlaneForce x = loco::computePolachForce(patch, {1.0, 1.0}, {1e-7, 0, 0, 0}, 0.35);
  const loco::PlaneForce y = loco::computePolachForce(patch, {1.0, 1.0}, {0, 1e-7, 0, 0}, 0.35);
  const loco::PlaneForce spin = loco::computePolachForce(patch, {1.0, 1.0}, {0, 0, 1e-5, 0}, 0.35);
  // saturation is of the order of x = 1e-4 for creepages, of e_s = 1e-4 for spin
  EXPECT_NEAR(x.x_N, -gab * patch.kalker.c11 * 1e-7, 1e-4 * gab * patch.kalker.c11 * 1e-7);
  EXPECT_NEAR(y.y_N, -gab * patch.kalker.c22 * 1e-7, 1e-4 * gab * patch.kalker.c22 * 1e-7);
  const double kalker = gab * std::sqrt(24e-6) * patch.kalker.c23 * 1e-5;
  EXPECT_NEAR(spin.y_N, -kalker, 1e-3 * kalker);
  EXPECT_EQ(spin.x_N, 0.0);
}

TEST(PolachTest, NeverPassesMuN) {
  const loco::ContactPatch patch = fixtures::tablePatch();
  for (const double xi : {0.0, 1e-3, 1e-2, 1.0}) {
    for (const double phi : {0.0, 0.3, 3.0, 30.0}) {
      const loco::PlaneForce force = loco::computePolachForce(patch, {1.0, 0.4}, {xi, -0.5 * xi, phi, 0}, 0.4);
      EXPECT_LE(std::hypot(force.x_N, force.y_N), 40e3 * (1.0 + 1e-14));
    }
  }
}

}  // namespace
