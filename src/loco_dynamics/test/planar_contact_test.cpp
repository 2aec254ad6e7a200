// The keys of `contact`, and the two laws of the normal force.

#include "loco_dynamics/planar_contact.hpp"

#include <cmath>

#include "loco_2d_fixtures.hpp"

namespace {

using loco::NormalContact;
using loco::PlanarContact;

std::vector<std::string> faults(const std::vector<rail::Override>& overrides) {
  std::vector<rail::Override> deeper = overrides;
  for (rail::Override& o : deeper) o.key = "contact." + o.key;
  rail::Problems problems;
  const rail::Document document =
      rail::Document::load(std::string(CONFIG_DIR) + "/locomotives/co_co_134t.yaml", deeper, problems);
  PlanarContact::read(rail::YamlReader(document, problems).map("contact"), 0.5335);
  return problems.lines();
}

std::string onlyFault(const std::string& key, const std::string& value) {
  const std::vector<std::string> lines = faults({{key, value}});
  EXPECT_EQ(lines.size(), 1u) << key;
  return lines.empty() ? "accepted" : lines.front();
}

NormalContact paperWheel(loco::NormalLaw law) {
  PlanarContact::Parameters p = fixtures::paperParameters().contact;
  p.normal_law = law;
  p.linear_stiffness_N_per_m = 1.1e9;
  return PlanarContact::makeNormalContact(p);
}

TEST(PlanarContactTest, EveryValueOutOfRangeIsNamed) {
  const std::vector<rail::Override> bad = {
      {"rail_crown_radius_m", "300"},     {"wheel_transverse_curvature_1pm", "-200"},
      {"normal_damping_N_s_per_m", "-1"}, {"young_modulus_Pa", "0"},
      {"poisson_ratio", "0.6"},           {"shear_modulus_Pa", "-82e9"}};
  const std::vector<std::string> lines = faults(bad);
  ASSERT_EQ(lines.size(), bad.size());
  for (std::size_t i = 0; i < bad.size(); ++i)
    EXPECT_NE(lines[i].find("contact." + bad[i].key + " = "), std::string::npos) << lines[i];
}

TEST(PlanarContactTest, AWheelMoreHollowThanTheRailIsRoundIsRefused) {
  EXPECT_NE(onlyFault("wheel_transverse_curvature_1pm", "-3.4").find("less hollow"), std::string::npos);
}

TEST(PlanarContactTest, OnlyTheKeyOfTheChosenLawIsAllowed) {
  EXPECT_NE(onlyFault("normal_law", "cubic").find("must be one of: hertz, linear"), std::string::npos);
  EXPECT_NE(onlyFault("linear_stiffness_N_per_m", "1.1e9").find("unknown key"), std::string::npos);
  EXPECT_NE(onlyFault("normal_law", "linear").find("linear_stiffness_N_per_m: is missing"), std::string::npos);
  EXPECT_EQ(faults({{"normal_law", "linear"}, {"linear_stiffness_N_per_m", "1.1e9"}}), std::vector<std::string>());
  EXPECT_EQ(faults({{"normal_law", "linear"}, {"linear_stiffness_N_per_m", "0"}}).size(), 1u);
  EXPECT_EQ(faults({{"normal_law", "hertz"}}), std::vector<std::string>());
}

TEST(PlanarContactTest, TheDefaultIsHertzWith1820MNPerMetreAtTheStaticLoad) {
  const NormalContact wheel = paperWheel(loco::NormalLaw::kHertz);
  const double N = fixtures::kWeight_N / 12.0;
  EXPECT_NEAR(wheel.computeTangentStiffness(N), 1.82e9, 0.005e9);
  EXPECT_NEAR(wheel.computeApproach(N), 0.0901e-3, 0.0001e-3);
}

TEST(PlanarContactTest, EitherLawIsOneLawInForceEnergyApproachAndStiffness) {
  for (const loco::NormalLaw law : {loco::NormalLaw::kHertz, loco::NormalLaw::kLinear}) {
    const NormalContact wheel = paperWheel(law);
    for (const double N : {2e4, 1.1e5, 3e5}) {
      const double delta = wheel.computeApproach(N), d = 1e-9;
      EXPECT_NEAR(wheel.computeForce(delta, 0.0), N, 1e-9 * N);
      const double energy_slope =
          (wheel.computeStoredEnergy(delta + d) - wheel.computeStoredEnergy(delta - d)) / (2.0 * d);
      const double force_slope = (wheel.computeForce(delta + d, 0.0) - wheel.computeForce(delta - d, 0.0)) / (2.0 * d);
      EXPECT_NEAR(energy_slope, N, 1e-6 * N);
      EXPECT_NEAR(force_slope, wheel.computeTangentStiffness(N), 1e-6 * force_slope);
    }
  }
}

TEST(PlanarContactTest, AContactPushesOnlyWithItsDampingToo) {
  for (const loco::NormalLaw law : {loco::NormalLaw::kHertz, loco::NormalLaw::kLinear}) {
    const NormalContact wheel = paperWheel(law);
    EXPECT_EQ(wheel.computeForce(-1e-6, 5.0), 0.0);
    EXPECT_EQ(wheel.computeForce(1e-5, -5.0), 0.0);
    EXPECT_DOUBLE_EQ(wheel.computeForce(1e-4, 0.1) - wheel.computeForce(1e-4, 0.0), 1e4);
    EXPECT_EQ(wheel.computeStoredEnergy(-1e-4), 0.0);
  }
}

TEST(PlanarContactTest, ALocomotiveOnLinearWheelsStandsStillAndPullsTheSame) {
  loco::Loco2d::Parameters p = fixtures::paperParameters();
  p.contact.normal_law = loco::NormalLaw::kLinear;
  p.contact.linear_stiffness_N_per_m = 1.1e9;
  fixtures::Ride rest(p, 0.0);
  rest.run(0.5);
  for (const loco::AxleAdhesion& axle : rest.answer.adhesion.axles)
    EXPECT_NEAR(axle.normal_force_N, fixtures::kWeight_N / 6.0, 1e-3);
  fixtures::Ride ride(p, 4.42);
  ride.force.traction_reference_N = 490e3;
  ride.runAtSteadySpeed(20.0);
  EXPECT_NEAR(ride.answer.traction_N, 399.7e3, 1e3);
}

}  // namespace
