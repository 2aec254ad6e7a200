#include "ltd_sim/energy_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

TEST(EnergyFiguresTest, ArePer1000GrossTonnesAndKilometre) {
  EXPECT_DOUBLE_EQ(ltd::computeKilowattHoursPer1000TonneKm(3.6e9, 2000.0, 50.0), 10.0);  // 1000 kWh, 100000 t km
  EXPECT_DOUBLE_EQ(ltd::computeLitresPer1000TonneKm(300.0, 2000.0, 50.0), 3.0);
  EXPECT_TRUE(std::isnan(ltd::computeLitresPer1000TonneKm(0.0, 2000.0, 0.0)));
}

}  // namespace
