// What a bodies file may not say, and what of it goes where.

#include "loco_dynamics/loco_structure.hpp"

#include <algorithm>

#include "loco_2d_fixtures.hpp"

namespace {

using loco::BodyLayout;

/// What is refused of the paper's file with these values in it, without the file's name.
std::vector<std::string> faults(const std::vector<rail::Override>& overrides) {
  try {
    fixtures::paperStructure(overrides);
  } catch (const rail::ConfigError& error) {
    std::vector<std::string> lines = error.lines();
    for (std::string& line : lines) line.erase(0, line.find(": ") + 2);
    return lines;
  }
  return {};
}

std::string onlyFault(const std::string& key, const std::string& value) {
  const std::vector<std::string> lines = faults({{key, value}});
  EXPECT_EQ(lines.size(), 1u) << key;
  return lines.empty() ? "accepted" : lines.front();
}

TEST(LocoStructureTest, WhatMustBePositiveIsNamed) {
  for (const char* key :
       {"coupler.x_m", "coupler.z_m", "car_body.mass_kg", "car_body.z_m", "car_body.pitch_inertia_kg_m2",
        "bogie_frames.x_m", "bogie_frames.mass_kg", "bogie_frames.yaw_inertia_kg_m2", "wheelsets.mass_kg",
        "wheelsets.spin_inertia_kg_m2", "secondary.z_m", "secondary.springs.0.vertical_N_per_m",
        "secondary.yaw_dampers.y_m", "secondary.yaw_dampers.series_stiffness_N_per_m", "secondary.centre_pin.x_m",
        "primary.y_m", "primary.stiffness.vertical_N_per_m"}) {
    EXPECT_EQ(onlyFault(key, "0"), std::string(key) + " = 0: must be a number > 0");
    EXPECT_EQ(onlyFault(key, "-1"), std::string(key) + " = -1: must be a number > 0");
  }
}

TEST(LocoStructureTest, WhatMustNotBeNegativeIsNamedAndMayBeZero) {
  for (const char* key :
       {"secondary.springs.1.longitudinal_N_per_m", "secondary.springs.0.x_m",
        "secondary.damping_per_bogie.vertical_N_s_per_m", "secondary.lateral_dampers.damping_N_s_per_m",
        "secondary.yaw_dampers.damping.0.slope_N_s_per_m", "secondary.centre_pin.longitudinal.1.slope_N_per_m",
        "primary.stiffness.longitudinal_N_per_m", "primary.damping.lateral_N_s_per_m",
        "primary.outer_axle_vertical_damping_N_s_per_m"}) {
    EXPECT_EQ(onlyFault(key, "-1"), std::string(key) + " = -1: must be a number >= 0");
    EXPECT_EQ(faults({{key, "0"}}), std::vector<std::string>()) << key;
  }
}

TEST(LocoStructureTest, AWheelOfAnImpossibleRadiusIsRefused) {
  EXPECT_EQ(onlyFault("wheel_radius_m", "533.5"), "wheel_radius_m = 533.5: must be a number >= 0.2 and <= 1.5");
}

TEST(LocoStructureTest, AxlesThatAreNotThreeFromTheFrontAreRefused) {
  EXPECT_NE(onlyFault("wheelsets.x_m", "[1.85, -1.85]").find("must be three places"), std::string::npos);
  EXPECT_NE(onlyFault("wheelsets.x_m", "[1.85, -1.85, 0.0]").find("the first axle is in front"), std::string::npos);
}

TEST(LocoStructureTest, ACarWithoutSpringsAndALawWithoutPiecesAreRefused) {
  EXPECT_NE(onlyFault("secondary.springs", "[]").find("at least one"), std::string::npos);
  EXPECT_NE(onlyFault("secondary.centre_pin.longitudinal", "[]").find("at least one piece"), std::string::npos);
}

TEST(LocoStructureTest, PiecesOfALawMustRise) {
  const std::string fault = onlyFault("secondary.yaw_dampers.damping",
                                      "[{up_to_mps: 0.1, slope_N_s_per_m: 1}, {up_to_mps: 0.05, slope_N_s_per_m: 1}, "
                                      "{slope_N_s_per_m: 1}]");
  EXPECT_EQ(fault, "secondary.yaw_dampers.damping.1.up_to_mps = 0.05: must be a number > 0.1");
}

TEST(LocoStructureTest, ForeignKeysAreRefusedInEveryMap) {
  const std::vector<std::string> lines =
      faults({{"primary.stiffness",
               "{longitudinal_N_per_m: 45.0e6, lateral_N_per_m: 2.25e6, vertical_N_per_m: 782.0e3, vertikal: 1}"},
              {"wheelsets.x_m", "[1.85, 0.0]"},
              {"coupler", "{x_m: 11, z_m: 0.885, y_m: 0}"}});
  EXPECT_EQ(lines.size(), 3u);  // all at once
}

TEST(LocoStructureTest, NosesOfTheMotorsAreAskedForOnlyIfTheyBear) {
  EXPECT_NE(onlyFault("motor_reaction", "hook").find("must be one of: couple, nose"), std::string::npos);
  EXPECT_NE(onlyFault("motor_reaction", "nose").find("motor_nose_x_m: is missing"), std::string::npos);
  EXPECT_NE(onlyFault("motor_nose_x_m", "[-1, -1, 1]").find("unknown key"), std::string::npos);
  const auto nose = [](const std::string& x_m) {
    return faults({{"motor_reaction", "nose"}, {"motor_nose_x_m", x_m}});
  };
  EXPECT_EQ(nose("[-1, -1, 1]"), std::vector<std::string>());
  EXPECT_EQ(nose("[-1, 1]").size(), 1u);
  EXPECT_EQ(nose("[-1, 0, 1]").size(), 1u);
  EXPECT_EQ(nose("[-1, -9, 1]").size(), 1u);
}

TEST(LocoStructureTest, EveryBodyStandsWhereTheFileSays) {
  const loco::LocoStructure s = fixtures::paperStructure();
  const double x_m[] = {0.0, 6.645, -6.645, 8.495, 6.645, 4.795, -4.795, -6.645, -8.495};
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) EXPECT_NEAR(s.bodies[i].p_T.x(), x_m[i], 1e-12) << i;
  EXPECT_EQ(s.bodies[BodyLayout::wheelset(5)].name, "wheelset 6");
  EXPECT_EQ(s.suspension.springs.size(), 2u * (6 + 1 + 2) + 12u);
  EXPECT_EQ(s.suspension.yaw_dampers.size(), 4u);
  EXPECT_EQ(s.suspension.pins.size(), 2u);
}

}  // namespace
