#include "ltd_sim/power_supply.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "supply_texts.hpp"
#include "train_fixtures.hpp"

namespace {

using fixtures::changed;
using fixtures::engineText;
using fixtures::lineText;
using fixtures::storageText;
using fixtures::supplyHead;
using ltd::PowerSupply;
using ltd::RimWork;
using State = ltd::PowerSupply::State;

constexpr double kStep = 2.0;   // s
constexpr double kTiny = 1e-8;  // J, round-off of some MJ

PowerSupply readSupply(const std::string& text) {
  return fixtures::readMap(text, [](rail::YamlReader reader) { return PowerSupply::read(reader, 0.0); });
}
PowerSupply diesel() { return readSupply(supplyHead("diesel") + engineText()); }
PowerSupply hybrid() { return readSupply(supplyHead("diesel_storage") + engineText() + storageText()); }
PowerSupply battery() { return readSupply(supplyHead("storage") + storageText()); }
PowerSupply line(bool regenerates) { return readSupply(supplyHead("overhead_line") + lineText(regenerates)); }
std::vector<PowerSupply> allKinds() { return {diesel(), hybrid(), battery(), line(true), line(false)}; }

/// One step of 2 s from the initial state.
State after(const PowerSupply& supply, double rim_work_J) {
  State state = supply.initialState();
  supply.step(RimWork(rim_work_J), kStep, state);
  EXPECT_NEAR(state.residual(), 0.0, kTiny);
  return state;
}

std::vector<double> energiesOf(const State& s) {
  return {s.stored_J,         s.stored_start_J,     s.motored_rim_J,   s.recovered_rim_J,  s.motored_loss_J,
          s.recovered_loss_J, s.auxiliaries_J,      s.generator_J,     s.generator_loss_J, s.engine_loss_J,
          s.fuel_J,           s.idle_fuel_J,        s.overload_J,      s.storage_in_J,     s.storage_out_J,
          s.storage_loss_J,   s.line_drawn_J,       s.line_returned_J, s.line_loss_J,      s.to_resistors_J,
          s.unserved_J,       s.auxiliaries_unfed_J};
}

TEST(PowerSupplyTest, NoSupplyBooksNothingAndLimitsNothing) {
  const PowerSupply none;
  EXPECT_FALSE(none.exists());
  for (const double energy_J : energiesOf(after(none, 4e5))) EXPECT_EQ(energy_J, 0.0);
  EXPECT_EQ(none.availableRimPower(none.initialState(), kStep), std::numeric_limits<double>::infinity());
  EXPECT_EQ(none.computeLitres(none.initialState()), 0.0);
  EXPECT_EQ(none.computeCharge(none.initialState()), 0.0);
}

TEST(PowerSupplyTest, MotoringBooksEachStageFromTheRimToTheFuel) {
  const State s = after(diesel(), 4e5);
  EXPECT_EQ(s.motored_rim_J, 4e5);
  EXPECT_EQ(s.recovered_rim_J, 0.0);
  EXPECT_EQ(s.recovered_loss_J, 0.0);
  EXPECT_NEAR(s.motored_loss_J, 1e5, kTiny);      // 4e5/0.8 - 4e5
  EXPECT_NEAR(s.auxiliaries_J, 6e4, kTiny);       // 1e4 W 2 s + 0.1 4e5
  EXPECT_NEAR(s.generator_J, 5.6e5, kTiny);       // 5e5 + 6e4
  EXPECT_NEAR(s.generator_loss_J, 2.4e5, kTiny);  // 5.6e5/0.7 = 8e5 at the shaft, 0.4 MW
  EXPECT_NEAR(s.fuel_J, 8e5 / 0.3, kTiny);        // share 0.4, half way from 0.2 to 0.4
  EXPECT_NEAR(s.engine_loss_J, 8e5 / 0.3 - 8e5, kTiny);
  EXPECT_EQ(s.idle_fuel_J, 0.0);
  EXPECT_EQ(s.to_resistors_J, 0.0);
  EXPECT_EQ(s.overload_J, 0.0);
  EXPECT_NEAR(diesel().computeLitres(s), 8e5 / 0.3 / 36e6, 1e-15);
}

TEST(PowerSupplyTest, BrakingFeedsTheAuxiliariesAndHeatsTheResistorsWhileTheEngineIdles) {
  const State s = after(diesel(), -4e5);
  EXPECT_EQ(s.motored_rim_J, 0.0);
  EXPECT_EQ(s.recovered_rim_J, 4e5);
  EXPECT_EQ(s.motored_loss_J, 0.0);
  EXPECT_NEAR(s.recovered_loss_J, 8e4, kTiny);  // 4e5 - 4e5 0.8
  EXPECT_NEAR(s.auxiliaries_J, 6e4, kTiny);
  EXPECT_NEAR(s.to_resistors_J, 2.6e5, kTiny);  // 3.2e5 - 6e4
  EXPECT_EQ(s.generator_J, 0.0);
  EXPECT_EQ(s.fuel_J, 2e4);  // 1e4 W 2 s
  EXPECT_EQ(s.idle_fuel_J, 2e4);
  EXPECT_EQ(s.engine_loss_J, 2e4);
}

TEST(PowerSupplyTest, TheEngineGivesWhatWeakBrakingLacksForTheAuxiliaries) {
  const State s = after(diesel(), -1e4);
  EXPECT_NEAR(s.generator_J, 1.3e4, kTiny);         // 2e4 + 0.1 1e4 - 0.8 1e4
  EXPECT_NEAR(s.fuel_J, 1.3e4 / 0.7 / 0.2, kTiny);  // share 0.009: the map's first efficiency
  EXPECT_EQ(s.to_resistors_J, 0.0);
  EXPECT_EQ(s.idle_fuel_J, 0.0);
}

TEST(PowerSupplyTest, AnHourOfIdlingBurnsTheIdlePowerTimesAnHour) {
  const std::string text = changed(changed(supplyHead("diesel"), "1.0e4", "0") + engineText(), "1.0e4", "19.7e3");
  const PowerSupply supply = readSupply(changed(text, "36.0e6", "35.8e6"));
  State s = supply.initialState();
  for (int k = 0; k < 3600; ++k) supply.step(RimWork(0.0), 1.0, s);
  EXPECT_NEAR(s.fuel_J, 19.7 * 3.6e6, 1e-6);
  EXPECT_EQ(s.idle_fuel_J, s.fuel_J);
  EXPECT_NEAR(supply.computeLitres(s), 1.98101, 1e-5);
}

TEST(PowerSupplyTest, AnEngineThatGivesLittleBurnsNoLessThanAnIdlingOne) {
  const State s = after(diesel(), -19300.0 / 0.7);  // leaves 700 J for the generator, 1 kJ at the shaft
  EXPECT_NEAR(s.generator_J, 700.0, kTiny);
  EXPECT_EQ(s.fuel_J, 2e4);       // not 1e3/0.2
  EXPECT_EQ(s.idle_fuel_J, 0.0);  // it gave something
}

TEST(PowerSupplyTest, BeyondTheRatedPowerTheLastEfficiencyHoldsAndTheExcessIsTold) {
  const State s = after(diesel(), 2.78e6 / 1.35);  // 2.8 MJ from the generator, 4 MJ at the shaft, 2 MW
  EXPECT_NEAR(s.generator_J, 2.8e6, kTiny);
  EXPECT_NEAR(s.fuel_J, 8e6, 1e-7);
  EXPECT_NEAR(s.overload_J, 2e6, 1e-7);
}

TEST(PowerSupplyTest, StorageGivesFirstAndTheEngineTheRest) {
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

TEST(PowerSupplyTest, WhatTheStorageMayNotTakeGoesToTheResistors) {
  const State s = after(hybrid(), -2e6);  // link 1.6e6 - 2e4 - 2e5 = 1.38 MJ; 0.4 MW 2 s into the storage
  EXPECT_NEAR(s.storage_in_J, 8e5, kTiny);
  EXPECT_NEAR(s.stored_J, 5e6 + 7.2e5, kTiny);
  EXPECT_NEAR(hybrid().computeCharge(s), 0.572, 1e-15);  // of 10 MJ
  EXPECT_NEAR(s.storage_loss_J, 8e4, kTiny);
  EXPECT_NEAR(s.to_resistors_J, 5.8e5, kTiny);
}

TEST(PowerSupplyTest, ARoundTripThroughTheStorageLosesWhatItsFourEfficienciesSay) {
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

TEST(PowerSupplyTest, AFullStorageSendsEverythingToTheResistors) {
  const PowerSupply supply = battery();
  State s = supply.initialState();
  s.stored_J = s.stored_start_J = 9e6;
  supply.step(RimWork(-4e5), kStep, s);
  EXPECT_EQ(s.storage_in_J, 0.0);
  EXPECT_NEAR(s.to_resistors_J, 2.6e5, kTiny);
  EXPECT_NEAR(s.residual(), 0.0, kTiny);
}

TEST(PowerSupplyTest, AnEmptyStorageServesNothingAndSaysSo) {
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

TEST(PowerSupplyTest, BeyondTheStoragesPowerTheAuxiliariesStarveThenTheRestIsUnservedButItIsNotEmpty) {
  const State s = after(battery(), 1e6);  // asked 1.25e6 + 2e4 + 1e5, given 1e6
  EXPECT_NEAR(s.auxiliaries_unfed_J, 1.2e5, kTiny);
  EXPECT_NEAR(s.unserved_J, 2.5e5, kTiny);
  EXPECT_FALSE(s.empty);
  const State little = after(battery(), 7.5e5);  // asked 9.375e5 + 2e4 + 7.5e4
  EXPECT_NEAR(little.auxiliaries_J, 1e6 - 9.375e5, kTiny);
  EXPECT_NEAR(little.auxiliaries_unfed_J, 3.25e4, kTiny);
  EXPECT_EQ(little.unserved_J, 0.0);
}

TEST(PowerSupplyTest, AStorageThatServesJustItsLastIsEmptyThoughNobodyAsksForMore) {
  const std::string head = changed(changed(supplyHead("storage"), "1.0e4", "0"), "0.1", "0");
  const PowerSupply supply = readSupply(head + storageText());
  State s = supply.initialState();
  s.stored_J = s.stored_start_J = 1.3e6;
  supply.step(RimWork(supply.availableRimPower(s, kStep) * kStep), kStep, s);
  EXPECT_TRUE(s.empty);
  EXPECT_EQ(s.unserved_J, 0.0);
}

TEST(PowerSupplyTest, ALinePaysItsLossBothWaysAndTakesBackOnlyIfItRegenerates) {
  const State drawn = after(line(true), 4e5);
  EXPECT_NEAR(drawn.line_drawn_J, 5.6e5 / 0.75, kTiny);
  EXPECT_NEAR(drawn.line_loss_J, 5.6e5 / 0.75 - 5.6e5, kTiny);
  const State returned = after(line(true), -4e5);
  EXPECT_NEAR(returned.line_returned_J, 2.6e5 * 0.75, kTiny);
  EXPECT_NEAR(returned.line_loss_J, 2.6e5 * 0.25, kTiny);
  EXPECT_EQ(returned.to_resistors_J, 0.0);
  const State burnt = after(line(false), -4e5);
  EXPECT_EQ(burnt.line_returned_J, 0.0);
  EXPECT_NEAR(burnt.to_resistors_J, 2.6e5, kTiny);
}

TEST(PowerSupplyTest, AStoragesPowerAndChargeBoundTheRimPower) {
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

TEST(PowerSupplyTest, AnEngineBesideAStorageBoundsTheRimPowerWithItAndAloneItDoesNot) {
  const PowerSupply supply = hybrid();
  EXPECT_NEAR(supply.availableRimPower(supply.initialState(), kStep), (5e5 + 7e5 - 1e4) / 1.35, kTiny);
  for (const PowerSupply& unbounded : {diesel(), line(true)})
    EXPECT_EQ(unbounded.availableRimPower(unbounded.initialState(), kStep), std::numeric_limits<double>::infinity());
}

/// Rim work of step k [J]: strong and weak, motoring and braking.
double variedWork(int k) { return 1.2e6 * std::sin(0.013 * k) + 4e5 * std::sin(0.7 * k); }

TEST(PowerSupplyTest, EveryKindClosesItsBalanceOverALongRunAndEveryEnergyOnlyGrows) {
  for (const PowerSupply& supply : allKinds()) {
    State s = supply.initialState();
    for (int k = 0; k < 5000; ++k) {
      const std::vector<double> before = energiesOf(s);
      supply.step(RimWork(variedWork(k)), kStep, s);
      for (std::size_t i = 1; i < before.size(); ++i) ASSERT_GE(energiesOf(s)[i], before[i]) << k << " " << i;
    }
    // 5000 roundings of each of ten sums, at worst all one way
    EXPECT_NEAR(s.residual() / s.motored_rim_J, 0.0, 5000 * 10 * std::numeric_limits<double>::epsilon());
    EXPECT_GT(s.motored_rim_J, 1e9);
    EXPECT_GT(s.recovered_rim_J, 1e9);
  }
}

TEST(PowerSupplyTest, ACopiedStateGoesOnWithTheSameBits) {
  for (const PowerSupply& supply : allKinds()) {
    State one = supply.initialState();
    for (int k = 0; k < 500; ++k) supply.step(RimWork(variedWork(k)), kStep, one);
    State other = one;
    for (int k = 500; k < 1000; ++k) supply.step(RimWork(variedWork(k)), kStep, one);
    for (int k = 500; k < 1000; ++k) supply.step(RimWork(variedWork(k)), kStep, other);
    EXPECT_EQ(energiesOf(one), energiesOf(other));
    EXPECT_EQ(one.empty, other.empty);
  }
}

}  // namespace
