#include "ltd_sim/train_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "train_fixtures.hpp"

namespace {

using ltd::TrainModel;

const std::string kResistance =
    "resistance: {per_mass_N_per_t: 2.943, per_axle_N: 89.2, per_mass_speed_N_per_t_kmph: 0.0306, "
    "per_speed_squared_N_per_kmph2: 0.122, curving_N_m_per_t: 6116}";
const std::string kWagon =
    "vehicle: {name: wagon, mass_kg: 120000, axles: 4, length_m: 15, rotary_mass_kg_per_axle: 750, " + kResistance +
    "}";
const std::string kLoco =
    "vehicle: {name: loco, mass_kg: 134000, axles: 6, length_m: 22, rotary_mass_kg_per_axle: 5000, " + kResistance +
    ", adhesion_limit: 0.35, traction: {law: limits, notches: 8, largest_force_N: 560.0e3, force_slope_N_s_per_m: 0, "
    "power_at_rail_W: 4.10e6, rise_N_per_s: 1, fall_N_per_s: 1}}";
const std::string kCoupler =
    "coupler: {name: c, slack_m: 0.02, unloading_ratio: 0.45, smoothing_speed_mps: 0.02, loading: "
    "[{stiffness_N_per_m: 4.0e6}]}";
const std::string kStiffCoupler =
    "coupler: {name: stiff, slack_m: 0.0, unloading_ratio: 0.9, smoothing_speed_mps: 0.1, loading: "
    "[{stiffness_N_per_m: 50.0e6}]}";

std::string locos(int count, const std::string& group) {
  return "{kind: locomotive, count: " + std::to_string(count) + ", notch_group: " + group + ", " + kLoco + "}";
}
std::string wagons(int count, const std::string& coupler = "") {
  return "{kind: wagon, count: " + std::to_string(count) + ", " + coupler + kWagon + "}";
}
std::string trainText(const std::string& groups) {
  return "train: {name: test, " + kCoupler + ", groups: [" + groups + "]}";
}

auto reading(bool rotary_inertia) {
  return [rotary_inertia](rail::YamlReader root) { return TrainModel::read(root.map("train"), "1d", rotary_inertia); };
}
TrainModel read(const std::string& groups, bool rotary_inertia = false) {
  return fixtures::readMap(trainText(groups), reading(rotary_inertia));
}

/// "LWWL": what stands where.
std::string pattern(const TrainModel& train) {
  std::string text;
  for (const rail::Vehicle& vehicle : train.vehicles) text += vehicle.axles == 6 ? 'L' : 'W';
  for (const ltd::LocoUnit& unit : train.locomotives) EXPECT_EQ(text[unit.vehicle], 'L') << unit.vehicle;
  EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), 'L')), train.locomotives.size());
  return text;
}

TEST(TrainModelTest, CountsVehiclesFromTheHead) {
  const TrainModel train = read(locos(3, "lead") + "," + wagons(105));
  EXPECT_EQ(pattern(train), "LLL" + std::string(105, 'W'));
  EXPECT_EQ(train.coupler_type.size(), 107u);
  EXPECT_EQ(train.coupler_distance_m.size(), 107u);
  EXPECT_DOUBLE_EQ(train.grossMass_t(), 13002.0);
}

/// A locomotive of 4.10 MW with a diesel of this rated power, without losses and auxiliaries.
std::string suppliedLoco(const std::string& rated_W) {
  std::string text = locos(1, "lead");
  const std::string supply =
      ", supply: {name: s, kind: diesel, drivetrain_efficiency: 1, auxiliary_power_W: 0, auxiliary_share_of_rim_power: "
      "0, generator_efficiency: 1, engine: {rated_power_W: " +
      rated_W + ", idle_fuel_W: 0, fuel_J_per_l: 36.0e6, efficiency: [[1, 0.4]]}}";
  return text.insert(text.find(", traction:"), supply);
}

TEST(TrainModelTest, ALocomotiveMayHaveASupplyAndTheTypesKeepTheirOrder) {
  const TrainModel train = read(locos(2, "lead") + "," + wagons(1) + "," + suppliedLoco("4.2e6"));
  ASSERT_EQ(train.supplies.size(), train.traction.size());
  EXPECT_FALSE(train.supplies[train.locomotives[1].type].exists());
  EXPECT_TRUE(train.supplies[train.locomotives[2].type].exists());
}

TEST(TrainModelTest, ASupplyMustServeItsTractionAndIsNotJudgedByAFaultyOne) {
  const std::vector<std::string> weak = fixtures::faultsIn(trainText(suppliedLoco("4.0e6")), reading(false));
  ASSERT_EQ(weak.size(), 1u);
  EXPECT_EQ(weak[0],
            "test.yaml: train.groups.0.vehicle.supply.engine.rated_power_W = 4.0e6: serves 4000000 W at the rim, must "
            "serve 4100000 W, the most that `traction` asks");
  std::string faulty = trainText(suppliedLoco("4.0e6"));  // a table without rows has no notches and no power
  const std::size_t at = faulty.find("{law: limits");
  faulty.replace(at, faulty.find(", rise", at) - at, "{law: table, table: speed_kmph");
  const std::vector<std::string> lines = fixtures::faultsIn(faulty, reading(false));
  EXPECT_FALSE(lines.empty());
  for (const std::string& line : lines) EXPECT_EQ(line.find("rated_power_W"), std::string::npos) << line;
}

TEST(TrainModelTest, AWagonHasNoSupply) {
  std::string wagon = wagons(1);
  wagon.insert(wagon.find("mass_kg"), "supply: {}, ");
  const std::vector<std::string> lines = fixtures::faultsIn(trainText(locos(1, "lead") + "," + wagon), reading(false));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NE(lines[0].find("train.groups.1.vehicle.supply"), std::string::npos) << lines[0];
}

TEST(TrainModelTest, LocomotivesMayStandAnywhereInNotchGroupsOfTheirOwn) {
  const TrainModel train = read(wagons(1) + "," + locos(1, "lead") + "," + wagons(2) + "," + locos(2, "remote") + "," +
                                wagons(1) + "," + locos(1, "lead"));
  EXPECT_EQ(pattern(train), "WLWWLLWL");
  EXPECT_EQ(train.notch_groups, (std::vector<std::string>{"lead", "remote"}));
  ASSERT_EQ(train.locomotives.size(), 4u);
  const std::size_t vehicle[] = {1, 4, 5, 7}, group[] = {0, 1, 1, 0}, type[] = {0, 1, 1, 2};
  const char* const key[] = {"train.groups.1.vehicle", "train.groups.3.vehicle", "train.groups.3.vehicle",
                             "train.groups.5.vehicle"};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(train.locomotives[i].vehicle, vehicle[i]);
    EXPECT_EQ(train.locomotives[i].notch_group, group[i]);
    EXPECT_EQ(train.locomotives[i].type, type[i]);
    EXPECT_EQ(train.locomotives[i].key, key[i]);
    EXPECT_EQ(train.locomotives[i].adhesion_limit, 0.35);
  }
}

TEST(TrainModelTest, RepeatsNestedGroupsWithTheirLocomotives) {
  const std::string pair = "{repeat: 2, groups: [" + wagons(1) + "," + locos(1, "mid") + "]}";
  const TrainModel train =
      read(locos(1, "lead") + ",{repeat: 3, groups: [" + wagons(2) + "," + pair + "]}," + wagons(1));
  EXPECT_EQ(pattern(train),
            "L"
            "WWWLWL"
            "WWWLWL"
            "WWWLWL"
            "W");
  const std::size_t vehicle[] = {0, 4, 6, 10, 12, 16, 18};
  ASSERT_EQ(train.locomotives.size(), 7u);
  for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(train.locomotives[i].vehicle, vehicle[i]);
  EXPECT_EQ(train.locomotives.back().key, "train.groups.1.groups.1.groups.1.vehicle");
  EXPECT_EQ(train.inertial_mass_kg.size(), train.vehicles.size());
  EXPECT_EQ(train.coupler_type.size() + 1, train.vehicles.size());
}

TEST(TrainModelTest, NeighboursAreHalfTheirLengthsApart) {
  const TrainModel train = read(locos(2, "lead") + "," + wagons(2));
  EXPECT_EQ(train.coupler_distance_m, (std::vector<double>{22.0, 18.5, 15.0}));
}

TEST(TrainModelTest, CountsRotaryInertiaOnlyIfAsked) {
  const std::string groups = locos(1, "lead") + "," + wagons(1);
  EXPECT_EQ(read(groups, false).inertial_mass_kg, (std::vector<double>{134000.0, 120000.0}));
  EXPECT_EQ(read(groups, true).inertial_mass_kg, (std::vector<double>{134000.0 + 6 * 5000, 120000.0 + 4 * 750}));
  EXPECT_DOUBLE_EQ(read(groups, true).grossMass_t(), 254.0);  // weight has no rotary part
}

TEST(TrainModelTest, AGroupsOwnCouplerIsTheOneBehindEachOfItsVehicles) {
  const TrainModel train = read(locos(1, "lead") + "," + wagons(2, kStiffCoupler + ", ") + "," + wagons(2));
  ASSERT_EQ(train.coupler_type.size(), 4u);
  const double slack_m[] = {0.02, 0.0, 0.0, 0.02};
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(train.coupler_types[train.coupler_type[i]].parameters().slack_m, slack_m[i]) << i;
}

void expectFault(const std::string& groups, const std::vector<std::string>& parts) {
  const std::vector<std::string> faults = fixtures::faultsIn(trainText(groups), reading(false));
  EXPECT_EQ(faults.size(), 1u) << fixtures::joined(faults);
  EXPECT_TRUE(fixtures::anyHas(faults, parts)) << fixtures::joined(faults);
}

TEST(TrainModelTest, BrakesAreThoseOfEachVehicleAndMayBeLeftOut) {
  std::string braked = wagons(1);
  const std::string brake =
      ", brake: {name: b, shoes: 8, brake_ratio: 0.1, rigging_efficiency: 1, friction: {law: constant, mu: 0.36}}}}";
  braked.replace(braked.size() - 2, 2, brake);
  const TrainModel train = read(locos(1, "lead") + ", {repeat: 2, groups: [" + wagons(1) + "," + braked + "]}");
  ASSERT_EQ(train.brakes.size(), train.vehicles.size());
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(train.brakes[i].present(), i == 2 || i == 4) << i;
  EXPECT_NEAR(train.brakes[4].shoe_force_N, 0.1 * 120e3 * 9.81, 1e-6);
}

TEST(TrainModelTest, RefusesTrainsThatCannotBe) {
  expectFault("", {"train.groups", "at least one group"});
  expectFault(wagons(3), {"train.groups", "at least one locomotive"});
  expectFault(locos(1, "lead") + "," + wagons(0), {"train.groups.1.count = 0"});
  expectFault(locos(1, "lead") + ",{repeat: 2, groups: []}", {"train.groups.1.groups", "at least one group"});
  expectFault("{kind: locomotive, count: 1, " + kLoco + "}", {"train.groups.0.notch_group", "is missing"});
  expectFault(locos(1, "lead") + ",{kind: wagon, count: 1, notch_group: lead, " + kWagon + "}",
              {"train.groups.1.notch_group", "unknown key"});
}

TEST(TrainModelTest, RefusesAKindThatDoesNotExistAndTractionOfAWagon) {
  const auto faults = fixtures::faultsIn(
      trainText("{kind: tender, count: 1, " + kWagon + "}, {kind: wagon, count: 1, " + kLoco + "}"), reading(false));
  EXPECT_TRUE(fixtures::anyHas(faults, {"train.groups.0.kind = tender", "locomotive, wagon"}));
  EXPECT_TRUE(fixtures::anyHas(faults, {"train.groups.1.vehicle.adhesion_limit = 0.35", "unknown key"}));
}

TEST(TrainModelTest, RefusesTooManyVehiclesOnceAndWithoutBuildingThem) {
  expectFault(locos(1, "lead") + "," + wagons(3000) + "," + wagons(3000), {"train.groups.2.count", "5000"});
  expectFault(locos(1, "lead") + ",{repeat: 5000, groups: [{repeat: 10, groups: [" + wagons(1) + "]}]}",
              {"train.groups.1.repeat", "5000"});
}

TEST(TrainModelTest, DesignForceIsTheSumOfTractionsAfterAdhesion) {
  const TrainModel train = read(locos(3, "lead") + "," + wagons(2));
  EXPECT_NEAR(computeDesignCouplerForce(train), 3 * 0.35 * 134e3 * 9.81, 1e-6);  // 1.38 MN: adhesion is below 560 kN
  TrainModel grippy = train;
  for (ltd::LocoUnit& unit : grippy.locomotives) unit.adhesion_limit = 0.9;
  EXPECT_NEAR(computeDesignCouplerForce(grippy), 3 * 560e3, 1e-6);
}

}  // namespace
