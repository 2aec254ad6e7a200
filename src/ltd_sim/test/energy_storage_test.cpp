#include "ltd_sim/energy_storage.hpp"

#include <gtest/gtest.h>

#include "supply_texts.hpp"
#include "train_fixtures.hpp"

namespace {

using ltd::EnergyStorage;

constexpr double kStep = 2.0;        // s
constexpr double kRelative = 1e-14;  // a product of a few factors

EnergyStorage readStorage(rail::YamlReader reader) {
  EnergyStorage storage = EnergyStorage::read(reader.map("storage"));
  reader.finish();
  return storage;
}
/// 1 to 9 MJ; in 0.4 MW at 0.9, out 0.5 MW at 0.95.
EnergyStorage testStorage() { return fixtures::readMap(fixtures::storageText(), readStorage); }

std::vector<std::string> faults(const std::string& from, const std::string& to) {
  return fixtures::faultsIn(fixtures::changed(fixtures::storageText(), from, to), readStorage);
}

TEST(EnergyStorageTest, RefusesSharesInTheWrongOrderAndImpossibleNumbers) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(faults("initial_share: 0.5", "initial_share: 0.05"),
            Lines{"test.yaml: storage.initial_share = 0.05: must be from lowest_share to highest_share"});
  EXPECT_EQ(faults("initial_share: 0.5", "initial_share: 0.95"),
            Lines{"test.yaml: storage.initial_share = 0.95: must be from lowest_share to highest_share"});
  EXPECT_EQ(faults("lowest_share: 0.1", "lowest_share: 0.9").front(),
            "test.yaml: storage.highest_share = 0.9: must be above lowest_share");
  EXPECT_EQ(faults("charge_efficiency: 0.9,", "charge_efficiency: 1.1,").size(), 1u);
  EXPECT_EQ(faults("discharge_efficiency: 0.95", "discharge_efficiency: 0").size(), 1u);
  EXPECT_EQ(faults("charge_power_W: 4.0e5", "charge_power_W: 400").size(), 1u);  // kilowatts
  EXPECT_EQ(faults("discharge_power_W: 5.0e5", "discharge_power_W: 500").size(), 1u);
  EXPECT_EQ(faults("capacity_J: 1.0e7", "capacity_J: 2400").size(), 1u);  // kilowatt hours
  EXPECT_EQ(faults("capacity_J", "capacity_Wh").size(), 2u);              // missing, unknown
}

TEST(EnergyStorageTest, SharesAreOfTheCapacity) {
  const EnergyStorage storage = testStorage();
  EXPECT_DOUBLE_EQ(storage.initialEnergy(), 5e6);
  EXPECT_DOUBLE_EQ(storage.lowestEnergy(), 1e6);
  EXPECT_DOUBLE_EQ(storage.highestEnergy(), 9e6);
}

TEST(EnergyStorageTest, WhatComesOutIsLessThanWhatItLoses) {
  double stored_J = 5e6;
  EXPECT_EQ(testStorage().stepOut(1.9e5, kStep, stored_J), 1.9e5);
  EXPECT_NEAR(stored_J, 5e6 - 2e5, kRelative * 5e6);  // 1.9e5/0.95
  EXPECT_NEAR(testStorage().computeLossOut(1.9e5), 1e4, 1e-9);
}

TEST(EnergyStorageTest, WhatGoesInIsMoreThanWhatItGains) {
  double stored_J = 5e6;
  EXPECT_EQ(testStorage().stepIn(2e5, kStep, stored_J), 2e5);
  EXPECT_NEAR(stored_J, 5e6 + 1.8e5, kRelative * 5e6);  // 2e5 0.9
  EXPECT_NEAR(testStorage().computeLossIn(2e5), 2e4, 1e-9);
}

TEST(EnergyStorageTest, PowerLimitsCountAtTheLink) {
  double stored_J = 5e6;
  EXPECT_EQ(testStorage().stepOut(3e6, kStep, stored_J), 1e6);  // 0.5 MW 2 s
  EXPECT_NEAR(stored_J, 5e6 - 1e6 / 0.95, kRelative * 5e6);
  stored_J = 5e6;
  EXPECT_EQ(testStorage().stepIn(3e6, kStep, stored_J), 8e5);  // 0.4 MW 2 s
  EXPECT_NEAR(stored_J, 5e6 + 8e5 * 0.9, kRelative * 5e6);
}

TEST(EnergyStorageTest, GivesDownToItsLowestChargeAndThenNothing) {
  double stored_J = 1.1e6;
  EXPECT_NEAR(testStorage().stepOut(1e6, kStep, stored_J), 0.95e5, 1e-9);
  EXPECT_DOUBLE_EQ(stored_J, 1e6);
  stored_J = 1e6;
  EXPECT_EQ(testStorage().stepOut(1e6, kStep, stored_J), 0.0);
  EXPECT_EQ(stored_J, 1e6);
}

TEST(EnergyStorageTest, TakesUpToItsHighestChargeAndThenNothing) {
  double stored_J = 8.91e6;
  EXPECT_NEAR(testStorage().stepIn(1e6, kStep, stored_J), 1e5, 1e-8);  // 0.09 MJ/0.9
  EXPECT_DOUBLE_EQ(stored_J, 9e6);
  stored_J = 9e6;
  EXPECT_EQ(testStorage().stepIn(1e6, kStep, stored_J), 0.0);
  EXPECT_EQ(stored_J, 9e6);
}

}  // namespace
