#include "rail_core/vehicle.hpp"

#include <gtest/gtest.h>

namespace {

constexpr const char* kWagon = R"(
name: wagon
mass_kg: 120000
axles: 4
length_m: 15
rotary_mass_kg_per_axle: 750
resistance: {per_mass_N_per_t: 1, per_axle_N: 2, per_mass_speed_N_per_t_kmph: 3, per_speed_squared_N_per_kmph2: 4,
             curving_N_m_per_t: 5}
)";

rail::Vehicle read(const std::string& text, rail::Problems& problems) {
  const rail::Document document = rail::Document::parse(text, "wagon.yaml", problems);
  rail::YamlReader reader(document, problems);
  const rail::Vehicle vehicle = rail::readVehicle(reader);
  reader.finish();
  return vehicle;
}

TEST(VehicleTest, EveryKeyGoesToItsField) {
  rail::Problems problems;
  const rail::Vehicle v = read(kWagon, problems);
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(v.name, "wagon");
  EXPECT_EQ(v.mass_kg, 120000.0);
  EXPECT_EQ(v.axles, 4);
  EXPECT_EQ(v.length_m, 15.0);
  EXPECT_EQ(v.rotary_mass_kg_per_axle, 750.0);
  EXPECT_EQ(v.resistance.per_mass_N_per_t, 1.0);
  EXPECT_EQ(v.resistance.per_axle_N, 2.0);
  EXPECT_EQ(v.resistance.per_mass_speed_N_per_t_kmph, 3.0);
  EXPECT_EQ(v.resistance.per_speed_squared_N_per_kmph2, 4.0);
  EXPECT_EQ(v.resistance.curving_N_m_per_t, 5.0);
}

TEST(VehicleTest, RotaryInertiaAddsItsMassPerAxleOnlyIfCounted) {
  rail::Problems problems;
  const rail::Vehicle v = read(kWagon, problems);
  EXPECT_EQ(v.inertialMass(false), 120000.0);
  EXPECT_EQ(v.inertialMass(true), 123000.0);
}

TEST(VehicleTest, ImpossibleValuesAreRefusedAllAtOnce) {
  std::string text = kWagon;
  text.replace(text.find("120000"), 6, "-1");
  text.replace(text.find("axles: 4"), 8, "axles: 1");
  text.replace(text.find("length_m: 15"), 12, "lenght_m: 15");
  text.replace(text.find("per_axle_N: 2"), 13, "per_axle_N: -2");
  rail::Problems problems;
  read(text, problems);
  ASSERT_EQ(problems.lines().size(), 5u);  // the misspelt key is unknown, and the right one is missing
  EXPECT_EQ(problems.lines()[0], "wagon.yaml: mass_kg = -1: must be a number >= 1000 and <= 1000000");
}

}  // namespace
