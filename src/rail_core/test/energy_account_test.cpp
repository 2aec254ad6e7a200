#include "rail_core/energy_account.hpp"

#include <gtest/gtest.h>

namespace rail {
namespace {

/// Each term a different power of two, so that a wrong sign or a forgotten term cannot cancel.
EnergyAccount distinctTerms() {
  EnergyAccount account;
  account.traction_rail = 1024.0;
  account.propulsion_resistance = 1.0;
  account.curving_resistance = 2.0;
  account.coupler_loss = 4.0;
  account.kinetic = 24.0;
  account.kinetic_start = 16.0;
  account.potential = 96.0;
  account.potential_start = 64.0;
  account.coupler_stored = 384.0;
  account.coupler_stored_start = 256.0;
  return account;
}

TEST(EnergyAccountTest, ResidualIsTractionLessAllThatIsExplained) {
  EXPECT_EQ(distinctTerms().residual(), 1024.0 - 1.0 - 2.0 - 4.0 - 8.0 - 32.0 - 128.0);
}

TEST(EnergyAccountTest, RelativeToTractionWorkIfThereIsAny) {
  EXPECT_EQ(distinctTerms().residualRelative(), 849.0 / 1024.0);
}

TEST(EnergyAccountTest, RelativeToTheBrakesWorkIfThatIsLarger) {
  EnergyAccount account = distinctTerms();
  account.traction_rail = 1e-10;  // what a train at rest leaves
  account.brake_rail = 512.0;
  account.air_brake = 2048.0;
  EXPECT_NEAR(account.residualRelative(), (-175.0 - 2560.0) / 2560.0, 1e-12);
}

TEST(EnergyAccountTest, RelativeToKineticEnergyWhenCoasting) {
  EnergyAccount account = distinctTerms();
  account.traction_rail = 0.0;
  EXPECT_EQ(account.residualRelative(), -175.0 / 16.0);
}

TEST(EnergyAccountTest, ResidualFromNothingIsShownInJoules) {
  EnergyAccount account;
  EXPECT_EQ(account.residualRelative(), 0.0);
  account.kinetic = 3.0;
  EXPECT_EQ(account.residualRelative(), -3.0);
}

TEST(EnergyAccountTest, RimSlipAndGradeWorkAreNotPartOfTheBalance) {
  EnergyAccount account = distinctTerms();
  account.traction_rim = account.slip_loss = account.grade = 1e6;
  EXPECT_EQ(account.residual(), distinctTerms().residual());
}

}  // namespace
}  // namespace rail
