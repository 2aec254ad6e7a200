// Verification case 6 (and the modes of case 9): modes without friction, linear contact 1.1 GN/m and 100 kN s/m a
// wheel, Table 2's dampers with the primary's 10 kN s/m vertically only, the chosen rubber damping off. Figures are an
// independent prototype's.
#include "loco_dynamics/modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loco_2d_fixtures.hpp"
#include "rail_core/testing/verification.hpp"

namespace {

using loco::BodyLayout;
using loco::Mode;

const std::vector<loco::Dof> kPlanar = {loco::kX, loco::kZ, loco::kPitch};
constexpr loco::WheelSpring kWheel{1.1e9, 100e3, 0.75};

loco::LinearModel caseSix(bool series_springs) {
  const loco::LocoStructure s = fixtures::paperStructure({{"primary.damping.longitudinal_N_s_per_m", "0"},
                                                          {"primary.damping.lateral_N_s_per_m", "0"},
                                                          {"secondary.damping_per_bogie.longitudinal_N_s_per_m", "0"},
                                                          {"secondary.damping_per_bogie.vertical_N_s_per_m", "0"}});
  return loco::linearise(s, loco::allCoordinates(kPlanar), kWheel, {loco::Branch::kAtRest, series_springs});
}

struct Expected {
  std::string name;
  double frequency_Hz, frequency_tolerance, damping, damping_tolerance;
};

/// The same words, whichever wheelset it is: alike wheelsets have alike modes in any combination.
bool alike(std::string a, std::string b) {
  for (std::string* name : {&a, &b})
    if (name->compare(0, 9, "wheelset ") == 0) (*name)[9] = '*';
  return a == b;
}

/// Of the modes of that name the one that is closest in frequency and damping, in tolerances.
const Mode& nearest(const std::vector<Mode>& modes, const Expected& e) {
  const auto distance = [&e](const Mode& m) {
    return alike(m.name, e.name) ? std::abs(m.frequency_Hz - e.frequency_Hz) / e.frequency_tolerance +
                                       std::abs(m.damping - e.damping) / e.damping_tolerance
                                 : std::numeric_limits<double>::infinity();
  };
  return *std::min_element(modes.begin(), modes.end(),
                           [&](const Mode& a, const Mode& b) { return distance(a) < distance(b); });
}

/// @param number, words  for the page of validation: of the case, and before the mode's name
void expectModes(const std::vector<Mode>& modes, const std::vector<Expected>& all, const std::string& number,
                 const std::string& words) {
  for (const Expected& e : all) {
    const bool found = std::any_of(modes.begin(), modes.end(), [&](const Mode& m) {
      return alike(m.name, e.name) && std::abs(m.frequency_Hz - e.frequency_Hz) <= e.frequency_tolerance &&
             std::abs(m.damping - e.damping) <= e.damping_tolerance;
    });
    EXPECT_TRUE(found) << e.name << " " << e.frequency_Hz << " Hz, zeta " << e.damping;
    const Mode& m = nearest(modes, e);
    rail::verify({number, words + e.name + ", frequency", "independent model", "Hz", e.frequency_Hz, m.frequency_Hz,
                  e.frequency_tolerance, "last digit given"});
    rail::verify({number, words + e.name + ", damping ratio", "independent model", "1", e.damping, m.damping,
                  e.damping_tolerance, "last digit given"});
  }
  if (!::testing::Test::HasFailure()) return;
  for (const Mode& m : modes) std::cout << m.name << " " << m.frequency_Hz << " Hz, zeta " << m.damping << '\n';
}

// Tolerances: the last digit that is quoted.
const std::vector<Expected> kOthers = {
    {"car body, vertical", 1.428, .001, .276, .001},     {"car body, pitch", 1.482, .001, .293, .001},
    {"bogie frame 1, pitch", 5.78, .01, .40, .01},       {"bogie frame 1, vertical", 15.32, .01, .116, .001},
    {"bogie frame 1, vertical", 15.41, .01, .114, .001}, {"wheelset 1, longitudinal", 25.89, .01, .0, .001},
    {"wheelset 2, vertical", 128.0, 1.0, .040, .001},    {"wheelset 1, vertical", 128.0, 1.0, .062, .001}};

TEST(ModesTest, WithYawDampersInRigidEndsTheyAreThoseOfAnIndependentModel) {
  const std::vector<Mode> modes = loco::computeModes(caseSix(false));
  expectModes(modes, kOthers, "6", "");
  expectModes(modes,
              {{"bogie frame 1, longitudinal", 1.348, .001, .803, .001},
               {"car body, longitudinal", 1.649, .001, .979, .001},
               {"bogie frame 1, longitudinal", 36.0, .1, .027, .001}},
              "6", "yaw dampers in rigid ends: ");
}

TEST(ModesTest, TheYawDampersSeriesSpringsMoveTheForeAndAftModesOnly) {
  const std::vector<Mode> modes = loco::computeModes(caseSix(true));
  expectModes(modes, kOthers, "6", "");
  expectModes(
      modes,
      {{"bogie frame 1, longitudinal", 1.381, .001, .822, .001}, {"bogie frame 1, longitudinal", 36.5, .1, .019, .001}},
      "6", "45 MN/m in series: ");
}

/// Verification case 9, its modes: wheelsets locked to the track, Table 2 with 10 kN s/m in all directions, yaw dampers
/// with their springs, the chosen dampers off, no gravity stiffness.
TEST(ModesTest, SpatialModesOnHeldWheelsetsAreThoseOfAnIndependentModel) {
  const loco::LocoStructure s = fixtures::paperStructure({{"secondary.damping_per_bogie.longitudinal_N_s_per_m", "0"},
                                                          {"secondary.damping_per_bogie.lateral_N_s_per_m", "0"},
                                                          {"secondary.damping_per_bogie.vertical_N_s_per_m", "0"}});
  std::vector<loco::Coordinate> coordinates;
  for (const std::size_t body : {BodyLayout::kCar, BodyLayout::bogie(0), BodyLayout::bogie(1)})
    for (const loco::Dof dof : {loco::kY, loco::kRoll, loco::kYaw}) coordinates.push_back({body, dof});
  const std::vector<Mode> modes = loco::computeModes(loco::linearise(s, coordinates, kWheel, {}));
  expectModes(modes,
              {{"car body, lateral", .662, .001, .115, .001},  // lower sway
               {"car body, yaw", .921, .001, .150, .001},
               {"car body, roll", 1.577, .001, .269, .001},  // upper sway
               {"bogie frame 1, lateral", 5.836, .001, .176, .001},
               {"bogie frame 1, lateral", 5.857, .001, .178, .001},
               {"bogie frame 1, yaw", 15.592, .001, .082, .001},
               {"bogie frame 1, yaw", 15.594, .001, .081, .001},
               {"bogie frame 1, roll", 26.67, .01, .220, .001},
               {"bogie frame 1, roll", 27.20, .01, .204, .001}},
              "9", "held wheelsets: ");
}

TEST(ModesTest, AShapeTellsWhoMovesWithWhom) {
  const std::vector<Mode> modes = loco::computeModes(caseSix(false));
  const loco::LinearModel model = caseSix(false);
  const auto at = [&](const Mode& mode, std::size_t body, loco::Dof dof) {
    for (std::size_t i = 0; i < model.coordinates.size(); ++i)
      if (model.coordinates[i].body == body && model.coordinates[i].dof == dof)
        return mode.shape[static_cast<Eigen::Index>(i)].real();
    return 0.0;
  };
  const Mode& antiphase = modes.front();  // 1.348 Hz
  EXPECT_NEAR(at(antiphase, BodyLayout::bogie(0), loco::kX) + at(antiphase, BodyLayout::bogie(1), loco::kX), 0.0, 1e-9);
  EXPECT_NEAR(at(antiphase, BodyLayout::kCar, loco::kX), 0.0, 1e-9);
  EXPECT_GT(std::abs(at(antiphase, BodyLayout::bogie(0), loco::kX)), 0.9);
}

TEST(ModesTest, WhatIsHeldToTheTrackIsLeftOut) {
  // one bogie frame on its secondary springs against a held car body and held wheelsets: a single mass, known in closed
  // form
  const loco::LocoStructure s = fixtures::paperStructure();
  const loco::LinearModel model =
      loco::linearise(s, {{BodyLayout::bogie(0), loco::kZ}}, kWheel, {loco::Branch::kAtRest, false});
  const double k = 80e6 + 6 * 782e3, c = 150e3 + 6 * 10e3 + 4 * 60e3, m = 11000.0;
  const std::vector<Mode> modes = loco::computeModes(model);
  ASSERT_EQ(modes.size(), 1u);
  EXPECT_NEAR(modes[0].frequency_Hz, std::sqrt(k / m) / (2.0 * M_PI), 1e-9);
  EXPECT_NEAR(modes[0].damping, c / (2.0 * std::sqrt(k * m)), 1e-12);
}

}  // namespace
