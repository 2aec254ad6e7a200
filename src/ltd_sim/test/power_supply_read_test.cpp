#include <gtest/gtest.h>

#include "ltd_sim/power_supply.hpp"
#include "supply_texts.hpp"
#include "train_fixtures.hpp"

namespace {

using fixtures::changed;
using fixtures::engineText;
using fixtures::lineText;
using fixtures::storageText;
using fixtures::supplyHead;
using ltd::EfficiencyMap;
using ltd::PowerSupply;
using Lines = std::vector<std::string>;

Lines faults(const std::string& text, double full_rim_power_W = 0.0) {
  return fixtures::faultsIn(text, [&](rail::YamlReader reader) { return PowerSupply::read(reader, full_rim_power_W); });
}
const std::string kDiesel = supplyHead("diesel") + engineText();

EfficiencyMap readMap(const std::string& rows) {
  return fixtures::readMap("efficiency: " + rows,
                           [](rail::YamlReader reader) { return EfficiencyMap::read(reader, "efficiency"); });
}
Lines mapFaults(const std::string& rows) {
  return fixtures::faultsIn("efficiency: " + rows,
                            [](rail::YamlReader reader) { return EfficiencyMap::read(reader, "efficiency"); });
}

TEST(EfficiencyMapTest, IsExactAtItsPointsLinearBetweenAndHeldBeyond) {
  const EfficiencyMap map = readMap("[[0.2, 0.2], [0.6, 0.4], [1.0, 0.5]]");
  EXPECT_EQ(map.computeEfficiency(0.2), 0.2);
  EXPECT_EQ(map.computeEfficiency(0.6), 0.4);
  EXPECT_EQ(map.computeEfficiency(1.0), 0.5);
  EXPECT_NEAR(map.computeEfficiency(0.3), 0.25, 1e-15);
  EXPECT_NEAR(map.computeEfficiency(0.8), 0.45, 1e-15);
  EXPECT_EQ(map.computeEfficiency(0.0), 0.2);
  EXPECT_EQ(map.computeEfficiency(7.0), 0.5);
}

TEST(EfficiencyMapTest, RefusesSharesThatDoNotRiseToOneAndImpossibleEfficiencies) {
  const std::string share = "must be a share above 0 and above the one before it";
  const std::string efficiency = "must be an efficiency > 0 and <= 1";
  EXPECT_EQ(mapFaults("[[0, 0.2], [1, 0.5]]"), Lines{"test.yaml: efficiency.0.0 = 0: " + share});
  EXPECT_EQ(mapFaults("[[0.5, 0.2], [0.5, 0.2], [1, 0.3]]").front(), "test.yaml: efficiency.1.0 = 0.5: " + share);
  EXPECT_EQ(mapFaults("[[0.5, 0], [1, 0.3]]").front(), "test.yaml: efficiency.0.1 = 0: " + efficiency);
  EXPECT_EQ(mapFaults("[[1, 41.8]]"), Lines{"test.yaml: efficiency.0.1 = 41.8: " + efficiency});  // per cent
  for (const std::string rows : {"[[0.5, 0.4]]", "[[0.5, 0.3], [1.1, 0.5]]", "[]"}) {
    ASSERT_EQ(mapFaults(rows).size(), 1u) << rows;
    EXPECT_NE(mapFaults(rows)[0].find("must end at the rated power, share 1"), std::string::npos) << rows;
  }
}

TEST(EfficiencyMapTest, RefusesAMapInWhichMorePowerBurnsLessFuel) {
  EXPECT_EQ(
      mapFaults("[[0.5, 0.2], [0.6, 0.3], [1, 0.4]]"),
      Lines{"test.yaml: efficiency.1.1 = 0.3: must not be so much higher that more power burns less fuel (share / "
            "efficiency must rise)"});
}

TEST(PowerSupplyReadTest, EachKindAsksForItsPartsAndRefusesTheOthers) {
  const std::string parts = engineText() + storageText() + lineText(true);
  const auto refused = [&](const std::string& kind) {
    std::string keys;
    for (const std::string& fault : faults(supplyHead(kind) + parts)) {
      EXPECT_NE(fault.find("must not be given: a supply of this kind has none"), std::string::npos) << fault;
      keys += fault.substr(11, fault.find_first_of(" :", 11) - 11) + " ";
    }
    return keys;
  };
  EXPECT_EQ(refused("diesel"), "storage line ");
  EXPECT_EQ(refused("diesel_storage"), "line ");
  EXPECT_EQ(refused("storage"), "engine generator_efficiency line ");
  EXPECT_EQ(refused("overhead_line"), "engine generator_efficiency storage ");
  for (const std::string kind : {"diesel", "storage", "overhead_line"}) EXPECT_FALSE(faults(supplyHead(kind)).empty());
  EXPECT_EQ(faults(supplyHead("steam") + parts).size(), 1u);  // of an unknown kind no parts are asked for
}

TEST(PowerSupplyReadTest, RefusesWrongNumbersAndUnknownKeys) {
  EXPECT_TRUE(faults(kDiesel).empty());
  EXPECT_EQ(faults(changed(kDiesel, "drivetrain_efficiency: 0.8", "drivetrain_efficiency: 98.9")).size(), 1u);
  EXPECT_EQ(faults(changed(kDiesel, "generator_efficiency: 0.7", "generator_efficiency: 0")).size(), 1u);
  EXPECT_EQ(faults(changed(kDiesel, "auxiliary_power_W: 1.0e4", "auxiliary_power_W: -1")).size(), 1u);
  EXPECT_EQ(faults(changed(kDiesel, "rated_power_W: 1.0e6", "rated_power_W: 1000")).size(), 1u);
  EXPECT_EQ(faults(changed(kDiesel, "fuel_J_per_l: 36.0e6", "fuel_J_per_l: 36")).size(), 1u);
  EXPECT_EQ(faults(changed(kDiesel, "idle_fuel_W: 1.0e4", "idle_fuel_W: 2.0e6")),
            Lines{"test.yaml: engine.idle_fuel_W = 2.0e6: must be below the fuel that the rated power burns"});
  EXPECT_EQ(faults(changed(kDiesel, "idle_fuel_W", "idel_fuel_W")).size(), 2u);
  EXPECT_EQ(faults(kDiesel + "colour: red\n").size(), 1u);
}

TEST(PowerSupplyReadTest, ADieselMustServeFullTractionWithAuxiliariesAndLosses) {
  const double served_W = (0.7e6 - 1e4) / 1.35;  // 1 MW at the shaft; 511111.1 W
  EXPECT_TRUE(faults(kDiesel, served_W * (1.0 - 1e-12)).empty());
  const Lines lines = faults(kDiesel, 511112.0);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].rfind("test.yaml: engine.rated_power_W = 1.0e6: serves 511111 W at the rim, ", 0), 0u) << lines[0];
  EXPECT_NE(lines[0].find("must serve 511112 W, the most that `traction` asks"), std::string::npos) << lines[0];
  const std::string hybrid = supplyHead("diesel_storage") + engineText() + storageText();
  EXPECT_TRUE(faults(hybrid, 1e9).empty());  // bounds the traction instead
}

PowerSupply readConfig(const std::string& name, double full_rim_power_W) {
  rail::Problems problems;
  const rail::Document document = rail::Document::load(CONFIG_DIR "/supplies/" + name, {}, problems);
  const PowerSupply supply = PowerSupply::read(rail::YamlReader(document, problems), full_rim_power_W);
  for (const std::string& line : problems.lines()) ADD_FAILURE() << line;
  return supply;
}

TEST(PowerSupplyReadTest, TheDieselOfTheConfigServesThePapersTractionWith7PercentOfSlip) {
  const PowerSupply supply = readConfig("diesel_electric.yaml", 1.07 * 4.10e6);
  PowerSupply::State s = supply.initialState();
  supply.step(ltd::RimWork(4.10e6 * 3600.0), 3600.0, s);
  const double shaft_W = (4.10e6 / 0.989 + 13e3 + 1.1e-3 * 4.10e6) / 0.980;  // 4.2481 MW, share 0.9235
  EXPECT_NEAR(s.generator_loss_J / 3600.0, 0.02 * shaft_W, 1e-6 * shaft_W);
  const double efficiency = 0.425 + (shaft_W / 4.6e6 - 0.849) / (1.0 - 0.849) * (0.418 - 0.425);
  EXPECT_NEAR(s.fuel_J / 3600.0, shaft_W / efficiency, 1e-9 * shaft_W);
  EXPECT_NEAR(supply.computeLitres(s), 1013.4, 0.1);  // 10.08 MW for an hour
  EXPECT_EQ(s.overload_J, 0.0);
}

TEST(PowerSupplyReadTest, TheHybridAndTheBatteryOfTheConfigBoundTheRimPower) {
  const PowerSupply hybrid = readConfig("diesel_storage.yaml", 4.10e6);
  const PowerSupply battery = readConfig("battery.yaml", 4.10e6);
  EXPECT_GT(hybrid.availableRimPower(hybrid.initialState(), 0.002), 1.07 * 4.10e6);
  EXPECT_NEAR(battery.availableRimPower(battery.initialState(), 0.002), 3.235e6, 1e3);
}

TEST(PowerSupplyReadTest, TheLineOfTheConfigPaysItsLossBothWaysAndTakesBack) {
  const PowerSupply line = readConfig("overhead_line.yaml", 1e9);  // bounds nothing
  PowerSupply::State pulled = line.initialState(), braked = line.initialState();
  line.step(ltd::RimWork(4.10e6 * 3600.0), 3600.0, pulled);
  EXPECT_NEAR(pulled.line_drawn_J / 3.6e6, (4100.0 / 0.989 + 13.0 + 1.1e-3 * 4100.0) / 0.92, 1e-9 * 4e3);  // 4525 kWh
  line.step(ltd::RimWork(-3.69e6 * 3600.0), 3600.0, braked);
  EXPECT_NEAR(braked.line_returned_J / 3.6e6, (3690.0 * 0.989 - 13.0 - 1.1e-3 * 3690.0) * 0.92,
              1e-9 * 4e3);  // 3342 kWh
  EXPECT_EQ(braked.to_resistors_J, 0.0);
}

}  // namespace
