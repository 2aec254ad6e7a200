// Creep forces against the tables that were computed with CONTACT. The distances are printed; docs/contact.md quotes
// them.

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <map>

#include "contact_fixtures.hpp"
#include "loco_dynamics/contact/contact_signs.hpp"
#include "rail_core/testing/verification.hpp"

namespace {

using fixtures::Distance;
using fixtures::numberAt;
using loco::CreepLawParameters;
using loco::CreepMethod;
using loco::FlexibilityRule;

using Row = std::map<std::string, std::string>;

fixtures::Rows table(const std::string& name) {
  return fixtures::readRows(std::string(TEST_DATA_DIR) + "/reference/" + name);
}

loco::ContactPatch patchOf(const Row& row) {
  return loco::makeContactPatch(1e-3 * numberAt(row, "a_mm"), 1e-3 * numberAt(row, "b_mm"), numberAt(row, "N_N"),
                                1e9 * numberAt(row, "G_GPa"), numberAt(row, "nu"));
}

/// Distance of the force from the row's, in % of mu N with the friction that acts.
double differenceTo(const Row& row, const CreepLawParameters& parameters, double speed_mps) {
  const loco::Creepage creepage = loco::fromContactSigns(
      {numberAt(row, "creep_x"), numberAt(row, "creep_y"), numberAt(row, "spin_rad_per_m")}, speed_mps);
  const loco::CreepForce force = loco::CreepLaw(parameters).computeForce(patchOf(row), creepage);
  const loco::ContactForce signs = loco::toContactSigns(force);
  return 100.0 * std::hypot(signs.x_N - numberAt(row, "Fx_N"), signs.y_N - numberAt(row, "Fy_N")) /
         (force.friction * numberAt(row, "N_N"));
}

std::map<std::string, Distance> distancesOfModfastsim(int n, FlexibilityRule rule) {
  std::map<std::string, Distance> distances;
  for (const Row& row : table("contact_modfastsim.csv")) {
    CreepLawParameters parameters;
    parameters.method = CreepMethod::kModfastsim;
    parameters.flexibility = rule;
    parameters.cells = parameters.strips = n;
    parameters.friction = {numberAt(row, "mu0"), numberAt(row, "A"), numberAt(row, "B_s_per_m")};
    parameters.reduction = {numberAt(row, "k0"), numberAt(row, "alpha_inf"), numberAt(row, "beta")};
    distances[row.at("method")].add(differenceTo(row, parameters, numberAt(row, "V_mps")));
  }
  return distances;
}

std::map<std::string, Distance> distancesOfFastsim(int n, FlexibilityRule rule) {
  std::map<std::string, Distance> distances;
  for (const Row& row : table("contact_fastsim.csv")) {
    CreepLawParameters parameters = fixtures::coulomb(CreepMethod::kFastsim, numberAt(row, "mu_static"), n, n);
    parameters.flexibility = rule;
    distances[row.at("method")].add(differenceTo(row, parameters, 0.0));
  }
  return distances;
}

void print(const char* what, const std::map<std::string, Distance>& distances) {
  for (const auto& [set, distance] : distances) {
    std::cout << what << ' ' << set << ": largest " << distance.largest << " %, rms " << distance.rms()
              << " % of mu N, " << distance.count << " points\n";
  }
}

constexpr double kGoal = 0.5;  // % of mu N on 20x20, the goal of the reference's README

TEST(ContactReferenceTest, ModifiedFastsimMeetsContactWithinHalfAPercent) {
  const auto distances = distancesOfModfastsim(20, FlexibilityRule::kBlended);
  print("20x20", distances);
  ASSERT_EQ(distances.size(), 3u);
  for (const auto& [set, distance] : distances) {
    EXPECT_EQ(distance.count, 143) << set;
    const auto check = [&set = set](const std::string& what, double computed, double limit, const std::string& reason) {
      rail::verify(
          {"3", set + ", 20x20, " + what + " difference", "CONTACT v25.2", "% of mu N", 0.0, computed, limit, reason});
    };
    check("largest", distance.largest, kGoal, "goal for a 20x20 grid");
    check("rms", distance.rms(), 0.2, "CONTACT's own march is stiffer by about this much");
  }
}

TEST(ContactReferenceTest, FastsimMeetsContactsFineGridWithinHalfAPercent) {
  const auto distances = distancesOfFastsim(20, FlexibilityRule::kBlended);
  print("20x20", distances);
  ASSERT_EQ(distances.size(), 3u);
  const Distance& fine = distances.at("fastsim_parabolic_220x220");
  rail::verify({"3", "FASTSIM, 20x20, largest difference", "CONTACT v25.2, FASTSIM 220x220", "% of mu N", 0.0,
                fine.largest, kGoal, "goal for a 20x20 grid"});
  rail::verify({"3", "FASTSIM, 20x20, rms difference", "CONTACT v25.2, FASTSIM 220x220", "% of mu N", 0.0, fine.rms(),
                0.2, "CONTACT's own march is stiffer by about this much"});
  // CONTACT's own 22x22 grid is 2.4 % from its 220x220 one, and that is 6.9 % from the full theory (pure spin): not
  // tuned away, only kept from growing
  EXPECT_LE(distances.at("fastsim_parabolic_22x22").largest, 3.0);
  EXPECT_LE(distances.at("full_halfspace_66x66").largest, 7.5);
}

/// What is left with a fine grid is CONTACT's implicit march; with three flexibilities the theory is another.
TEST(ContactReferenceTest, BlendedFlexibilityIsContactsTheory) {
  const auto blended = distancesOfModfastsim(200, FlexibilityRule::kBlended);
  const auto three = distancesOfModfastsim(200, FlexibilityRule::kThree);
  print("200x200 blended", blended);
  print("200x200 three", three);
  print("200x200 blended", distancesOfFastsim(200, FlexibilityRule::kBlended));
  print("200x200 three", distancesOfFastsim(200, FlexibilityRule::kThree));
  for (const auto& [set, distance] : blended) {
    EXPECT_LE(distance.largest, 0.3) << set;
    EXPECT_LT(3.0 * distance.largest, 2.0 * three.at(set).largest + 1.0) << set;
  }
  EXPECT_GT(three.at("modfastsim_dry_falling_friction").largest, 1.5);
}

/// CONTACT's "Eurosprinter" example; its terms do not let a copy go into this repository. The table does not give the
/// ellipse, but without lateral creep and spin only G a b C11 counts, which is the slope of the table's own FASTSIM
/// curve.
TEST(ContactReferenceTest, ClosedFormMeetsTheEurosprinterCurve) {
  const std::string path = std::string(TEST_DATA_DIR) + "/../../../../shared/reference/tractcurv.csv";
  if (!std::ifstream(path)) GTEST_SKIP() << path << " is not here: nothing compared";
  CreepLawParameters modified;
  modified.method = CreepMethod::kClosed;
  modified.friction = {0.36, 0.38, 0.7};
  modified.reduction = {0.54, 0.02, 0.62};
  const CreepLawParameters original = fixtures::coulomb(CreepMethod::kClosed, 0.33);

  loco::ContactPatch patch;
  std::map<std::string, Distance> distances;
  for (const Row& row : fixtures::readRows(path)) {
    const bool is_original = row.at("series").rfind("FASTSIM_original", 0) == 0;
    if (!is_original && row.at("series").rfind("MODIFIED_FASTSIM", 0) != 0) continue;
    const double creep = numberAt(row, "cksi"), force = numberAt(row, "Fx_N_minusFx_sign_flipped");
    if (patch.a_m == 0.0) {  // a circle with the slope of the first point, corrected for x = 2e-4 of saturation
      const double c11 = loco::computeKalkerCoefficients(1.0, 0.28).c11;
      const double radius = std::sqrt(force / creep / (82e9 * c11));
      patch = loco::makeContactPatch(radius, radius, numberAt(row, "FN_N"), 82e9, 0.28);
    }
    const double speed_mps = 1e-3 * numberAt(row, "V_mm_s");
    const loco::CreepForce computed =
        loco::CreepLaw(is_original ? original : modified).computeForce(patch, {-creep, 0.0, 0.0, speed_mps * creep});
    distances[row.at("series")].add(100.0 * (computed.x_N - force) / (computed.friction * patch.normal_N));
  }
  print("closed", distances);
  ASSERT_EQ(distances.size(), 2u);
  for (const auto& [series, distance] : distances) {
    EXPECT_EQ(distance.count, 30) << series;
    EXPECT_LE(distance.largest, kGoal) << series;  // four digits, and a grid that is not ours
  }
}

}  // namespace
