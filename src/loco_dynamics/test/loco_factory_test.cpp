#include "loco_dynamics/loco_factory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace {

constexpr const char* kScenario = R"(
locomotive_model: 1d
rotary_inertia: false
train:
  groups:
    - {kind: wagon}
    - repeat: 2
      groups:
        - vehicle:
            name: Co-Co
            mass_kg: 100000
            axles: 6
            length_m: 22
            rotary_mass_kg_per_axle: 5000
            adhesion_limit: 0.2
            resistance: {per_mass_N_per_t: 1, per_axle_N: 1, per_mass_speed_N_per_t_kmph: 1,
                         per_speed_squared_N_per_kmph2: 1, curving_N_m_per_t: 1}
)";

constexpr const char* kKey = "train.groups.1.groups.0.vehicle";

TEST(LocoFactoryTest, FindsTheLocomotiveAtItsPathInTheScenario) {
  rail::Problems problems;
  const rail::Document document = rail::Document::parse(kScenario, "test.yaml", problems);
  const auto locomotive = loco::makeLocomotive(document, kKey, problems);
  ASSERT_TRUE(problems.empty()) << problems.lines().front();
  ASSERT_NE(locomotive, nullptr);

  loco::LocoForce force;
  force.step_length = 1000000;
  force.traction_reference_N = 1e9;
  loco::LocoTraction answer;
  locomotive->step(locomotive->equilibriumState(0.0, 0.0).state, force, answer);
  EXPECT_DOUBLE_EQ(answer.traction_N, 0.2 * 100000 * 9.81);
  EXPECT_DOUBLE_EQ(answer.speed_mps, 1e-3 * answer.traction_N / 100000);
}

TEST(LocoFactoryTest, CountsRotaryInertiaIfTheScenarioSaysSo) {
  std::string text = kScenario;
  text.replace(text.find("false"), 5, "true");
  rail::Problems problems;
  const rail::Document document = rail::Document::parse(text, "test.yaml", problems);
  const auto locomotive = loco::makeLocomotive(document, kKey, problems);
  ASSERT_NE(locomotive, nullptr);
  loco::LocoForce force;
  force.step_length = 1000000;
  force.grade_N = 1000;
  loco::LocoTraction answer;
  locomotive->step({0.0, 0.0}, force, answer);
  EXPECT_DOUBLE_EQ(answer.speed_mps, 1e-3 * 1000 / 130000);
}

TEST(LocoFactoryTest, RefusesAModelThatDoesNotExistAndAPathThatLeadsNowhere) {
  std::string text = kScenario;
  text.replace(text.find("1d"), 2, "7d");
  rail::Problems problems;
  const rail::Document document = rail::Document::parse(text, "test.yaml", problems);
  EXPECT_EQ(loco::makeLocomotive(document, "train.groups.9.vehicle", problems), nullptr);
  ASSERT_GE(problems.lines().size(), 2u);
  EXPECT_NE(problems.lines()[0].find("locomotive_model"), std::string::npos);
  EXPECT_NE(problems.lines()[1].find("has no entry 9"), std::string::npos);
}

/// What is refused of the paper's 2D (or 3D) locomotive with this in its scenario, without the file's name.
std::vector<std::string> faultsOfThePapersLocomotive(const std::vector<rail::Override>& overrides,
                                                     const std::string& scenario = "paper_2d") {
  rail::Problems problems;
  const rail::Document document =
      rail::Document::load(std::string(CONFIG_DIR) + "/scenarios/" + scenario + ".yaml", overrides, problems);
  const auto locomotive = loco::makeLocomotive(document, "train.groups.0.vehicle", problems);
  EXPECT_EQ(locomotive == nullptr, !problems.empty());
  std::vector<std::string> lines = problems.lines();
  for (std::string& line : lines) line.erase(0, line.find(": ") + 2);
  return lines;
}

TEST(LocoFactoryTest, BodiesThatDoNotWeighWhatTheVehicleDoesAreRefused) {
  EXPECT_EQ(faultsOfThePapersLocomotive({}), std::vector<std::string>());
  const std::string rule = ": must be the sum of the masses in `bodies`, ";
  EXPECT_EQ(faultsOfThePapersLocomotive({{"train.groups.0.vehicle.mass_kg", "134001"}}),
            std::vector<std::string>{"train.groups.0.vehicle.mass_kg = 134001" + rule + "134000 kg"});
  EXPECT_EQ(faultsOfThePapersLocomotive({{"train.groups.0.vehicle.bodies.wheelsets.mass_kg", "3401"}}),
            std::vector<std::string>{"mass_kg = 134000" + rule + "134006 kg"});
}

TEST(LocoFactoryTest, AMicroStepBeyondThatOfTheWheelsAtTheirStaticLoadIsRefused) {
  const auto lines =
      faultsOfThePapersLocomotive({{"steps.micro_step_s", "0.00151"}, {"steps.macro_step_s", "0.00302"}});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines.front().substr(0, 60), "steps.micro_step_s = 0.00151: must be at most 0.001507 s for");
  EXPECT_EQ(faultsOfThePapersLocomotive({{"steps.micro_step_s", "0.0015"}, {"steps.macro_step_s", "0.003"}}),
            std::vector<std::string>());
}

TEST(LocoFactoryTest, TheStepsLimitCountsThePinsOnTheirSteepestBranch) {
  const std::string slope = "train.groups.0.vehicle.bodies.secondary.centre_pin.longitudinal.1.slope_N_per_m";
  const auto lines = faultsOfThePapersLocomotive({{slope, "1e11"}});  // beyond a clearance of 2 mm
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NE(lines.front().find("steps.micro_step_s = 0.001: must be at most"), std::string::npos) << lines.front();
  EXPECT_NE(lines.front().find("bogie frame"), std::string::npos) << lines.front();
  EXPECT_NE(lines.front().find(", longitudinal"), std::string::npos) << lines.front();
}

TEST(LocoFactoryTest, FaultsInBodiesContactAdhesionAndControlAreToldAtOnce) {
  const auto lines = faultsOfThePapersLocomotive({{"train.groups.0.vehicle.bodies.primary.y_m", "0"},
                                                  {"train.groups.0.vehicle.contact.poisson_ratio", "2"},
                                                  {"adhesion.reduction.k0", "1.1"},
                                                  {"control.slip_limit", "1.1"}});
  EXPECT_EQ(lines.size(), 4u);
}

TEST(LocoFactoryTest, MakesThePapers3dLocomotive) {
  rail::Problems problems;
  const rail::Document document =
      rail::Document::load(std::string(CONFIG_DIR) + "/scenarios/paper_3d.yaml", {}, problems);
  const auto locomotive = loco::makeLocomotive(document, "train.groups.0.vehicle", problems);
  ASSERT_NE(locomotive, nullptr) << problems.lines().front();
  loco::LocoForce force;
  force.step_length = 2000000;
  loco::LocoTraction answer;
  locomotive->step(locomotive->equilibriumState(3000.0, 5.0).state, force, answer);
  EXPECT_EQ(answer.failure, "");
  EXPECT_EQ(answer.adhesion.contacts.size(), 12u);
  EXPECT_EQ(locomotive->computePoses(answer.state).size(), 9u);
}

TEST(LocoFactoryTest, A3dLocomotiveWithoutSoundProfilesIsRefused) {
  const auto lines = faultsOfThePapersLocomotive({{"train.groups.0.vehicle.profiles.gauge_mm", "1300"}}, "paper_3d");
  EXPECT_FALSE(lines.empty());
}

/// Traction [N] of the paper's 3D locomotive in the curve, after some steps of running free.
double curvingForce(const std::string& scenario, const std::vector<rail::Override>& overrides) {
  rail::Problems problems;
  const rail::Document document =
      rail::Document::load(std::string(CONFIG_DIR) + "/scenarios/" + scenario + ".yaml", overrides, problems);
  const auto locomotive = loco::makeLocomotive(document, "train.groups.0.vehicle", problems);
  problems.throwIfAny();
  loco::LocoForce force;
  force.step_length = 2000000;
  loco::LocoTraction answer;
  locomotive->step(locomotive->equilibriumState(3450.0, 8.85).state, force, answer);
  return answer.traction_N;
}

TEST(LocoFactoryTest, TheScenariosProfilesTakeThePlaceOfTheLocomotivesOwn) {
  const double own = curvingForce("paper_3d", {});
  const double common = curvingForce("paper_3d_two_point", {});
  EXPECT_NE(common, own);
  EXPECT_EQ(common, curvingForce("paper_3d", {{"train.groups.0.vehicle.profiles.wheel", "coned_1_20"}}));
}

TEST(LocoFactoryTest, AProfileThatASetNamesIsANameAndNoFile) {
  const auto lines = faultsOfThePapersLocomotive({{"train.groups.0.vehicle.profiles.wheel", "S1003"}}, "paper_3d");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NE(lines.front().find("must be one of S1002, coned_1_20, or wheel_file"), std::string::npos) << lines.front();
}

TEST(LocoFactoryTest, TheScenariosProfilesAreCheckedWithTheirKey) {
  const auto lines = faultsOfThePapersLocomotive({{"profiles.gauge_mm", "1300"}}, "paper_3d_two_point");
  ASSERT_FALSE(lines.empty());
  EXPECT_EQ(lines.front().substr(0, 24), "profiles.gauge_mm = 1300") << lines.front();
}

TEST(LocoFactoryTest, GravityStiffnessIsOnUnlessTheScenarioSaysNo) {
  const auto read = [](const std::string& text) {
    rail::Problems problems;
    const rail::Document document = rail::Document::parse(text, "test.yaml", problems);
    rail::YamlReader root(document, problems);
    const bool on = loco::readSpatialOptions(root).gravity_stiffness;
    root.finish();
    problems.throwIfAny();
    return on;
  };
  EXPECT_TRUE(read("{}"));
  EXPECT_TRUE(read("gravity_stiffness: true"));
  EXPECT_FALSE(read("gravity_stiffness: false"));
  EXPECT_THROW(read("gravity_stiffness: 1"), std::exception);
  EXPECT_NE(curvingForce("paper_3d", {{"gravity_stiffness", "false"}}), curvingForce("paper_3d", {}));
}

TEST(LocoFactoryTest, Only3dMakesItsCurvingResistanceItself) {
  EXPECT_FALSE(loco::makesCurvingResistance("1d"));
  EXPECT_FALSE(loco::makesCurvingResistance("2d"));
  EXPECT_TRUE(loco::makesCurvingResistance("3d"));
}

TEST(LocoFactoryTest, WhatNoLocomotiveCanBeIsRefusedWithItsKey) {
  const std::string vehicle = "train.groups.0.vehicle.";
  const std::vector<std::array<std::string, 3>> cases = {
      {vehicle + "axles", "4", "must be 6, as many as `bodies` has"},
      {vehicle + "length_m", "5", "must be half of length_m, 2.5 m"},
      {vehicle + "bodies.wheelsets.spin_inertia_kg_m2", "1.432", "must be at least m r^2/10, 96.78 kg m2"},
      {vehicle + "bodies.primary.stiffness.vertical_N_per_m", "782", "is too soft: the car body would sink by 1"},
      {vehicle + "contact.shear_modulus_Pa", "82", "must be that of young_modulus_Pa and poisson_ratio, 8.203e+10"},
      {vehicle + "contact.young_modulus_Pa", "210", "is too soft: wheels would sink by"},
      {"control.sampling_period_s", "0.02", "swings up at low speed: K_p r T_s/(J 0.5 m/s) = 2.235 must be below 2"},
  };
  for (const auto& [key, value, rule] : cases) {
    const std::vector<std::string> lines = faultsOfThePapersLocomotive({{key, value}});
    ASSERT_FALSE(lines.empty()) << key;
    EXPECT_TRUE(std::any_of(lines.begin(), lines.end(),
                            [&rule = rule](const std::string& line) { return line.find(rule) != std::string::npos; }))
        << key << ": " << lines.front();
  }
}

TEST(LocoFactoryTest, ASlowControllerThatIsGentleEnoughIsTaken) {
  EXPECT_EQ(
      faultsOfThePapersLocomotive({{"control.sampling_period_s", "0.02"}, {"control.proportional_gain_N_m", "100e3"}}),
      std::vector<std::string>());
}

}  // namespace
