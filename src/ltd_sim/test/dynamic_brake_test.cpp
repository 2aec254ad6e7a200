#include "ltd_sim/dynamic_brake.hpp"

#include "train_fixtures.hpp"

namespace {

using fixtures::anyHas;
using fixtures::faultsIn;
using fixtures::readMap;
using ltd::DynamicBrake;

constexpr const char* kRates = "rise_N_per_s: 40.0e3, fall_N_per_s: 160.0e3}";
const std::string kLimits =
    std::string(
        "{law: limits, notches: 8, largest_force_N: 364.0e3, power_at_rail_W: 3.69e6, fade_from_kmph: 10, "
        "fade_to_kmph: 2, ") +
    kRates;

DynamicBrake paperBrake() { return readMap(kLimits, DynamicBrake::read); }

TEST(DynamicBrakeTest, FadesInBetweenItsTwoSpeedsHoldsAndFollowsTheHyperbola) {
  const DynamicBrake brake = paperBrake();
  for (int n = 1; n <= 8; ++n) {
    const double share = n / 8.0;
    EXPECT_EQ(brake.computeForce(n, 2.0 / 3.6), 0.0) << n;
    EXPECT_NEAR(brake.computeForce(n, 6.0 / 3.6), share * 182e3, 1e-6) << n;  // half way
    EXPECT_NEAR(brake.computeForce(n, 10.0 / 3.6), share * 364e3, 1e-6) << n;
    EXPECT_NEAR(brake.computeForce(n, 10.0), share * 364e3, 1e-6) << n;
    EXPECT_NEAR(brake.computeForce(n, 20.0), share * 3.69e6 / 20.0, 1e-6) << n;
  }
}

TEST(DynamicBrakeTest, GivesNothingStandingBackwardsOrOff) {
  const DynamicBrake brake = paperBrake();
  EXPECT_EQ(brake.computeForce(8, 0.0), 0.0);
  EXPECT_EQ(brake.computeForce(8, -5.0), 0.0);
  EXPECT_EQ(brake.computeForce(0, 10.0), 0.0);
  EXPECT_EQ(DynamicBrake().computeForce(0, 10.0), 0.0);
  EXPECT_EQ(DynamicBrake().notches(), 0);
}

TEST(DynamicBrakeTest, FollowsItsTargetNoFasterThanItsRates) {
  const DynamicBrake brake = paperBrake();
  EXPECT_NEAR(brake.computeResponse(100e3, 300e3, 0.5), 120e3, 1e-9);
  EXPECT_NEAR(brake.computeResponse(100e3, 0.0, 0.5), 20e3, 1e-9);
  EXPECT_EQ(brake.computeResponse(100e3, 100.5e3, 0.5), 100.5e3);
}

TEST(DynamicBrakeTest, FaultsAreNamed) {
  const std::string fade = std::string(
                               "{law: limits, notches: 8, largest_force_N: 364, power_at_rail_W: 3.69e6, "
                               "fade_from_kmph: 2, fade_to_kmph: 10, colour: red, ") +
                           kRates;
  const std::vector<std::string> faults = faultsIn(fade, DynamicBrake::read);
  EXPECT_TRUE(anyHas(faults, {"largest_force_N = 364"})) << fixtures::joined(faults);
  EXPECT_TRUE(anyHas(faults, {"colour"})) << fixtures::joined(faults);
  const std::string crossed = std::string(
                                  "{law: limits, notches: 8, largest_force_N: 364e3, power_at_rail_W: 3.69e6, "
                                  "fade_from_kmph: 2, fade_to_kmph: 10, ") +
                              kRates;
  EXPECT_TRUE(anyHas(faultsIn(crossed, DynamicBrake::read), {"fade_from_kmph", "must be above fade_to_kmph"}));
}

std::string tableOf(const std::string& rows) {
  return "{law: table, table: \"speed_kmph,notch_1_N,notch_2_N\\n" + rows + "\", " + kRates;
}

TEST(DynamicBrakeTableTest, IsLinearBetweenItsRowsAndAHyperbolaBeyond) {
  const DynamicBrake brake = readMap(tableOf("0,0,0\\n18,50000,100000\\n36,40000,80000\\n"), DynamicBrake::read);
  EXPECT_EQ(brake.notches(), 2);
  EXPECT_NEAR(brake.computeForce(2, 2.5), 50e3, 1e-9);
  EXPECT_NEAR(brake.computeForce(1, 7.5), 45e3, 1e-9);
  EXPECT_NEAR(brake.computeForce(2, 20.0), 40e3, 1e-9);
  EXPECT_EQ(brake.largestForce(), 100e3);
}

TEST(DynamicBrakeTableTest, ForceAtRestIsRefusedWithItsLine) {
  const std::vector<std::string> faults = faultsIn(tableOf("0,1000,2000\\n18,50000,40000\\n"), DynamicBrake::read);
  EXPECT_TRUE(anyHas(faults, {"line 2", "must be 0: motors cannot hold"})) << fixtures::joined(faults);
  EXPECT_TRUE(anyHas(faults, {"line 3", "must not fall with the notch"})) << fixtures::joined(faults);
}

}  // namespace
