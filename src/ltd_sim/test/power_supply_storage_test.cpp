#include <gtest/gtest.h>

#include <limits>

#include "supply_fixtures.hpp"

namespace {

using fixtures::after;
using fixtures::battery;
using fixtures::changed;
using fixtures::diesel;
using fixtures::hybrid;
using fixtures::line;
using fixtures::readSupply;
using fixtures::storageText;
using fixtures::supplyHead;
using ltd::PowerSupply;
using ltd::RimWork;
using State = ltd::PowerSupply::State;

constexpr double kStep = fixtures::kSupplyStep, kTiny = fixtures::kTinyEnergy;

TEST(PowerSupplyStorageTest, StorageGivesFirstAndTheEngineTheRest) {
  const State s = after(hybrid(), 1e6);  // link 1.25e6 + 2e4 + 1e5 = 1.37 MJ, of it 0.5 MW 2 s from the storage
  EXPECT_NEAR(s.storage_out_J, 1e6, kTiny);
  EXPECT_NEAR(s.stored_J, 5e6 - 1e6 / 0.95, kTiny);
  EXPECT_NEAR(s.storage_loss_J, 1e6 / 0.95 - 1e6, kTiny);
  EXPECT_NEAR(s.generator_J, 3.7e5, kTiny);
  EXPECT_FALSE(s.empty);
  const State little = after(hybrid(), 4e5);
  EXPECT_NEAR(little.storage_out_J, 5.6e5, kTiny);
  EXPECT_EQ(little.generator_J, 0.0);
  EXPECT_EQ(little.idle_fuel_J, 2e4);
}

TEST(PowerSupplyStorageTest, WhatTheStorageMayNotTakeGoesToTheResistors) {
  const State s = after(hybrid(), -2e6);  // link 1.6e6 - 2e4 - 2e5 = 1.38 MJ; 0.4 MW 2 s into the storage
  EXPECT_NEAR(s.storage_in_J, 8e5, kTiny);
  EXPECT_NEAR(s.stored_J, 5e6 + 7.2e5, kTiny);
  EXPECT_NEAR(hybrid().computeCharge(s), 0.572, 1e-15);  // of 10 MJ
  EXPECT_NEAR(s.storage_loss_J, 8e4, kTiny);
  EXPECT_NEAR(s.to_resistors_J, 5.8e5, kTiny);
}

TEST(PowerSupplyStorageTest, ARoundTripThroughTheStorageLosesWhatItsFourEfficienciesSay) {
  const std::string head = changed(changed(supplyHead("storage"), "1.0e4", "0"), "0.1", "0");
  const PowerSupply supply = readSupply(head + storageText());
  State s = supply.initialState();
  supply.step(RimWork(-1e5), kStep, s);
  supply.step(RimWork(1e5 * 0.8 * 0.9 * 0.95 * 0.8), kStep, s);
  EXPECT_NEAR(s.stored_J, s.stored_start_J, kTiny);
  EXPECT_NEAR(s.storage_loss_J, 8e4 * (1.0 - 0.9 * 0.95), kTiny);
  EXPECT_NEAR(s.recovered_loss_J, 2e4, kTiny);
  EXPECT_NEAR(s.motored_loss_J, 6.84e4 * 0.2, kTiny);
  EXPECT_NEAR(s.residual(), 0.0, kTiny);
  EXPECT_EQ(s.unserved_J, 0.0);
}

TEST(PowerSupplyStorageTest, AFullStorageSendsEverythingToTheResistors) {
  const PowerSupply supply = battery();
  State s = supply.initialState();
  s.stored_J = s.stored_start_J = 9e6;
  supply.step(RimWork(-4e5), kStep, s);
  EXPECT_EQ(s.storage_in_J, 0.0);
  EXPECT_NEAR(s.to_resistors_J, 2.6e5, kTiny);
  EXPECT_NEAR(s.residual(), 0.0, kTiny);
}

TEST(PowerSupplyStorageTest, AnEmptyStorageServesNothingAndSaysSo) {
  const PowerSupply supply = battery();
  State s = supply.initialState();
  s.stored_J = s.stored_start_J = 1e6;
  supply.step(RimWork(4e5), kStep, s);
  EXPECT_TRUE(s.empty);
  EXPECT_NEAR(s.unserved_J, 5e5, kTiny);           // 4e5/0.8: the wheels did turn
  EXPECT_NEAR(s.auxiliaries_unfed_J, 6e4, kTiny);  // 2e4 + 0.1 4e5
  EXPECT_EQ(s.auxiliaries_J, 0.0);
  EXPECT_NEAR(s.residual(), 0.0, kTiny);
  supply.step(RimWork(-4e5), kStep, s);  // braking fills it
  EXPECT_FALSE(s.empty);
  EXPECT_GT(s.stored_J, 1e6);
}

TEST(PowerSupplyStorageTest, BeyondTheStoragesPowerTheAuxiliariesStarveThenTheRestIsUnservedButItIsNotEmpty) {
  const State s = after(battery(), 1e6);  // asked 1.25e6 + 2e4 + 1e5, given 1e6
  EXPECT_NEAR(s.auxiliaries_unfed_J, 1.2e5, kTiny);
  EXPECT_NEAR(s.unserved_J, 2.5e5, kTiny);
  EXPECT_FALSE(s.empty);
  const State little = after(battery(), 7.5e5);  // asked 9.375e5 + 2e4 + 7.5e4
  EXPECT_NEAR(little.auxiliaries_J, 1e6 - 9.375e5, kTiny);
  EXPECT_NEAR(little.auxiliaries_unfed_J, 3.25e4, kTiny);
  EXPECT_EQ(little.unserved_J, 0.0);
}

TEST(PowerSupplyStorageTest, AStorageThatServesJustItsLastIsEmptyThoughNobodyAsksForMore) {
  const std::string head = changed(changed(supplyHead("storage"), "1.0e4", "0"), "0.1", "0");
  const PowerSupply supply = readSupply(head + storageText());
  State s = supply.initialState();
  s.stored_J = s.stored_start_J = 1.3e6;
  supply.step(RimWork(supply.availableRimPower(s, kStep) * kStep), kStep, s);
  EXPECT_TRUE(s.empty);
  EXPECT_EQ(s.unserved_J, 0.0);
}

TEST(PowerSupplyStorageTest, AStoragesPowerAndChargeBoundTheRimPower) {
  const PowerSupply supply = battery();
  State s = supply.initialState();
  EXPECT_NEAR(supply.availableRimPower(s, kStep), (5e5 - 1e4) / 1.35, kTiny);  // 1/0.8 + 0.1
  s.stored_J = s.stored_start_J = 1.2e6;                                       // 0.19 MJ at the link, 95 kW for 2 s
  const double available_W = supply.availableRimPower(s, kStep);
  EXPECT_NEAR(available_W, (9.5e4 - 1e4) / 1.35, kTiny);
  supply.step(RimWork(available_W * kStep), kStep, s);
  EXPECT_NEAR(s.unserved_J, 0.0, kTiny);
  EXPECT_NEAR(s.stored_J, 1e6, kTiny);
  EXPECT_EQ(supply.availableRimPower(s, kStep), 0.0);  // not below, though the auxiliaries starve
}

TEST(PowerSupplyStorageTest, AnEngineBesideAStorageBoundsTheRimPowerWithItAndAloneItDoesNot) {
  const PowerSupply supply = hybrid();
  EXPECT_NEAR(supply.availableRimPower(supply.initialState(), kStep), (5e5 + 7e5 - 1e4) / 1.35, kTiny);
  for (const PowerSupply& unbounded : {diesel(), line(true)})
    EXPECT_EQ(unbounded.availableRimPower(unbounded.initialState(), kStep), std::numeric_limits<double>::infinity());
}

}  // namespace
