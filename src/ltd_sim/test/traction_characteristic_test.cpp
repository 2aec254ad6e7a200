#include "ltd_sim/traction_characteristic.hpp"

#include <gtest/gtest.h>

#include "train_fixtures.hpp"

namespace {

using fixtures::readMap;
using ltd::TractionCharacteristic;

constexpr double kForce = 560e3;     // F_max
constexpr double kPower = 4.10e6;    // P
constexpr double kRelative = 1e-14;  // a product of a few factors

TEST(TractionLimitsTest, NotchGivesItsShareOfTheForceAtLowSpeedAndItsSquareOfThePowerAbove) {
  const TractionCharacteristic traction = fixtures::paperTraction();
  ASSERT_EQ(traction.notches(), 8);
  for (int n = 1; n <= 8; ++n) {
    const double share = n / 8.0;
    EXPECT_NEAR(traction.computeForce(n, 0.0), share * kForce, kRelative * kForce) << n;
    EXPECT_NEAR(traction.computeForce(n, 0.5), share * kForce, kRelative * kForce) << n;
    EXPECT_NEAR(traction.computeForce(n, 20.0), share * share * kPower / 20.0, kRelative * kForce) << n;
    EXPECT_NEAR(traction.computeRimPowerLimit(n), share * share * kPower, kRelative * kPower) << n;
  }
}

TEST(TractionLimitsTest, ForceAndPowerLimitCrossAtTheirCommonSpeed) {
  const TractionCharacteristic traction = fixtures::paperTraction();
  for (int n = 1; n <= 8; ++n) {
    const double crossing_mps = n / 8.0 * kPower / kForce;  // 7.32 m/s for notch 8
    EXPECT_NEAR(traction.computeForce(n, 0.999 * crossing_mps), n / 8.0 * kForce, kRelative * kForce) << n;
    EXPECT_NEAR(traction.computeForce(n, crossing_mps), n / 8.0 * kForce, kRelative * kForce) << n;
    EXPECT_NEAR(traction.computeForce(n, 1.001 * crossing_mps), n / 8.0 * kForce / 1.001, 1e-13 * kForce) << n;
  }
}

TEST(TractionLimitsTest, Notch7ReachesThePapersAdhesionLimitAndNotch8HoldsItUpTo8Point911MetresPerSecond) {
  const TractionCharacteristic traction = fixtures::paperTraction();
  const double limit_N = 0.35 * 134e3 * 9.81;  // 460.09 kN
  EXPECT_GT(traction.computeForce(7, 0.0), limit_N);
  EXPECT_NEAR(kPower / limit_N, 8.9113, 1e-4);
  EXPECT_GT(traction.computeForce(8, 8.911), limit_N);
  EXPECT_LT(traction.computeForce(8, 8.912), limit_N);
}

TEST(TractionLimitsTest, IdleGivesNothingAndRollingBackCountsAsStanding) {
  const TractionCharacteristic traction = fixtures::paperTraction();
  for (const double v_mps : {-3.0, 0.0, 10.0}) EXPECT_EQ(traction.computeForce(0, v_mps), 0.0);
  EXPECT_EQ(traction.computeRimPowerLimit(0), 0.0);
  EXPECT_EQ(traction.computeForce(3, -50.0), traction.computeForce(3, 0.0));
}

TEST(TractionLimitsTest, ForceFallsWithSpeedByItsSlopeAndNeverBelowZero) {
  const TractionCharacteristic traction = readMap(
      "{law: limits, notches: 4, largest_force_N: 100.0e3, force_slope_N_s_per_m: 5.0e3, power_at_rail_W: "
      "1.0e9, rise_N_per_s: 1, fall_N_per_s: 1}",
      TractionCharacteristic::read);
  EXPECT_NEAR(traction.computeForce(4, 8.0), 60e3, 1e-9);
  EXPECT_NEAR(traction.computeForce(2, 8.0), 30e3, 1e-9);
  EXPECT_EQ(traction.computeForce(4, 25.0), 0.0);
  EXPECT_EQ(traction.computeForce(4, -8.0), 100e3);  // rolling back counts as standing
  EXPECT_EQ(traction.largestForce(), 100e3);
}

TEST(TractionResponseTest, RisesBy40AndFallsBy160kNPerSecondExactly) {
  const TractionCharacteristic traction = fixtures::paperTraction();
  EXPECT_EQ(traction.computeResponse(100e3, 300e3, 0.5), 120e3);
  EXPECT_EQ(traction.computeResponse(300e3, 0.0, 0.5), 220e3);
}

TEST(TractionResponseTest, StopsAtTheTargetFromBothSides) {
  const TractionCharacteristic traction = fixtures::paperTraction();
  EXPECT_EQ(traction.computeResponse(100e3, 110e3, 0.5), 110e3);
  EXPECT_EQ(traction.computeResponse(100e3, 90e3, 0.5), 90e3);
  EXPECT_EQ(traction.computeResponse(100e3, 100e3, 0.5), 100e3);
}

TEST(TractionResponseTest, ManySmallStepsTakeAsLongAsTheRateSays) {
  const TractionCharacteristic traction = fixtures::paperTraction();
  double force_N = 0.0;
  for (int k = 0; k < 5000; ++k) force_N = traction.computeResponse(force_N, 560e3, 0.002);
  EXPECT_NEAR(force_N, 400e3, 1e-5);  // 10 s; the sum of 5000 steps of 80 N is off by round-off
}

/// A table of two notches; `rows` as lines below the header.
std::string tableText(const std::vector<std::string>& rows,
                      const std::string& header = "speed_kmph,notch_1_N,notch_2_N") {
  std::string text = "law: table\nrise_N_per_s: 1\nfall_N_per_s: 1\ntable: |\n  " + header + "\n";
  for (const std::string& row : rows) text += "  " + row + "\n";
  return text;
}
const std::vector<std::string> kGoodRows = {"0, 100000, 200000", "18, 80000, 160000", "36, 30000, 80000"};

TEST(TractionTableTest, IsLinearBetweenItsSpeeds) {
  const TractionCharacteristic traction = readMap(tableText(kGoodRows), TractionCharacteristic::read);
  ASSERT_EQ(traction.notches(), 2);
  EXPECT_EQ(traction.computeForce(1, 0.0), 100e3);
  EXPECT_EQ(traction.computeForce(1, -4.0), 100e3);
  EXPECT_NEAR(traction.computeForce(1, 2.5), 90e3, 1e-9);
  EXPECT_NEAR(traction.computeForce(2, 5.0), 160e3, 1e-9);
  EXPECT_NEAR(traction.computeForce(2, 7.5), 120e3, 1e-9);
  EXPECT_EQ(traction.computeForce(0, 2.5), 0.0);
  EXPECT_EQ(traction.largestForce(), 200e3);
}

TEST(TractionTableTest, BeyondItsLastSpeedItFollowsTheHyperbolaOfTheLastPower) {
  const TractionCharacteristic traction = readMap(tableText(kGoodRows), TractionCharacteristic::read);
  EXPECT_NEAR(traction.computeForce(2, 10.0), 80e3, 1e-9);
  EXPECT_NEAR(traction.computeForce(2, 20.0), 40e3, 1e-9);
  EXPECT_NEAR(traction.computeForce(1, 25.0), 30e3 * 10.0 / 25.0, 1e-9);
}

TEST(TractionTableTest, RimPowerLimitIsTheLargestPowerOfTheNotch) {
  const TractionCharacteristic traction = readMap(tableText(kGoodRows), TractionCharacteristic::read);
  // Between 5 and 10 m/s notch 1 gives 130 kN - 10 kN s/m v, so most at 6.5 m/s, notch 2 240 kN - 16 kN s/m v.
  EXPECT_NEAR(traction.computeRimPowerLimit(1), 65e3 * 6.5, 1e-9);
  EXPECT_NEAR(traction.computeRimPowerLimit(2), 120e3 * 7.5, 1e-9);
  EXPECT_EQ(traction.computeRimPowerLimit(0), 0.0);
  for (double v_mps = 0.0; v_mps < 30.0; v_mps += 0.01)
    EXPECT_LE(traction.computeForce(2, v_mps) * v_mps, traction.computeRimPowerLimit(2) + 1e-9) << v_mps;
}

TEST(TractionTableTest, RimPowerLimitIsThatOfARowWhereTheForceFallsSteeplyBehindIt) {
  const TractionCharacteristic traction =
      readMap(tableText({"0, 100000, 200000", "18, 100000, 200000", "36, 10000, 20000"}), TractionCharacteristic::read);
  // 190 kN - 18 kN s/m v has its vertex at 5.28 m/s, just behind the row: 501.4 kW, not the row's 500.
  EXPECT_NEAR(traction.computeRimPowerLimit(1), 190e3 * 190e3 / (4.0 * 18e3), 1e-6);
  const TractionCharacteristic cliff = readMap(
      tableText({"0, 100000, 200000", "18, 100000, 200000", "19.8, 10000, 20000"}), TractionCharacteristic::read);
  EXPECT_NEAR(cliff.computeRimPowerLimit(1), 500e3, 1e-9);
}

void expectFault(const std::string& text, const std::vector<std::string>& parts) {
  const std::vector<std::string> faults = fixtures::faultsIn(text, TractionCharacteristic::read);
  EXPECT_EQ(faults.size(), 1u) << fixtures::joined(faults);
  EXPECT_TRUE(fixtures::anyHas(faults, parts)) << fixtures::joined(faults);
}

TEST(TractionTableTest, RefusesABadTableWithTheLineNumber) {
  expectFault(tableText({"1, 100000, 200000", "36, 30000, 80000"}), {"line 2: speed_kmph = 1", "must start at 0"});
  expectFault(tableText({"0, 100000, 200000", "36, 30000, 80000", "36, 20000, 70000"}),
              {"line 4: speed_kmph = 36", "must rise"});
  expectFault(tableText({"0, 100000, 200000", "36, 130000, 180000"}),
              {"line 3: notch_1_N = 130000", "must not rise with speed"});
  expectFault(tableText({"0, 100000, 200000", "36, 90000, 80000"}),
              {"line 3: notch_2_N = 80000", "must not fall with the notch"});
  expectFault(tableText({"0, 100000, 200000", "36, -1, 80000"}), {"line 3: notch_1_N = -1", ">= 0"});
  expectFault(tableText({"0, 100000, 200000", "36, x, 80000"}), {"line 3: notch_1_N = x", "must be a number"});
  expectFault(tableText({"0, 100000, 200000", "36, 80000"}), {"line 3", "has 2 cells"});
  expectFault(tableText({"0, 100000, 200000"}), {"at least two rows"});
  expectFault(tableText({"0, 100, 560", "36, 50, 80"}), {"notch_2_N = 560", "from 1e3 to 1e7 N"});  // kN
  expectFault(tableText(kGoodRows, "speed_kmph,notch_1_N,notch_3_N"), {"line 1: notch_3_N", "notch_2_N"});
  expectFault(tableText(kGoodRows, "speed_mps,notch_1_N,notch_2_N"), {"line 1", "must be 'speed_kmph'"});
}

TEST(TractionTableTest, RefusesATableWithoutANotch) {
  expectFault(tableText({"0", "36"}, "speed_kmph"), {"line 1", "notch_1_N"});
}

TEST(TractionReadTest, RefusesImpossibleNumbersAndMixedLaws) {
  const std::string rates = ", rise_N_per_s: 1, fall_N_per_s: 1}";
  expectFault(
      "{law: hyperbola, notches: 8, largest_force_N: 1e5, force_slope_N_s_per_m: 0, power_at_rail_W: 1e6" + rates,
      {"law = hyperbola", "limits, table"});
  expectFault("{law: limits, notches: 0, largest_force_N: 1e5, force_slope_N_s_per_m: 0, power_at_rail_W: 1e6" + rates,
              {"notches = 0"});
  expectFault("{law: limits, notches: 8, largest_force_N: -1, force_slope_N_s_per_m: 0, power_at_rail_W: 1e6" + rates,
              {"largest_force_N = -1"});
  expectFault("{law: limits, notches: 8, largest_force_N: 1e5, force_slope_N_s_per_m: 0, power_at_rail_W: 0" + rates,
              {"power_at_rail_W = 0"});
  expectFault(
      "{law: limits, notches: 8, largest_force_N: 1e5, force_slope_N_s_per_m: 0, power_at_rail_W: 1e6, "
      "rise_N_per_s: 0, fall_N_per_s: 1}",
      {"rise_N_per_s = 0"});
  expectFault(tableText(kGoodRows) + "notches: 2\n", {"notches", "unknown key"});
}

}  // namespace
