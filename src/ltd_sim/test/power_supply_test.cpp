#include "ltd_sim/power_supply.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "supply_fixtures.hpp"

namespace {

using fixtures::after;
using fixtures::allKinds;
using fixtures::changed;
using fixtures::diesel;
using fixtures::engineText;
using fixtures::line;
using fixtures::readSupply;
using fixtures::supplyHead;
using ltd::PowerSupply;
using ltd::RimWork;
using State = ltd::PowerSupply::State;

constexpr double kStep = fixtures::kSupplyStep, kTiny = fixtures::kTinyEnergy;

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
