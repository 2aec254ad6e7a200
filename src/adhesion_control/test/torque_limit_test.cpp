#include "adhesion_control/torque_limit.hpp"

#include <gtest/gtest.h>

namespace {

constexpr double kRadius_m = 0.5335;
constexpr adhesion::TorqueLimit kPaper{kRadius_m, 134000.0, 6, 0.35};  // Table 2 and Sect. 5

TEST(TorqueLimitTest, EveryAxleGetsAnEqualShare) {
  EXPECT_DOUBLE_EQ(adhesion::computeTorqueReference(kPaper, 300e3), 50e3 * kRadius_m);
  EXPECT_DOUBLE_EQ(adhesion::computeTorqueReference(kPaper, -300e3), -50e3 * kRadius_m);
  EXPECT_EQ(adhesion::computeTorqueReference(kPaper, 0.0), 0.0);
}

TEST(TorqueLimitTest, AdhesionLimitOfThePaperIs460kNForSixAxles) {
  // 0.35 m g = 460.089 kN, to the rounding of that figure
  EXPECT_NEAR(6.0 * adhesion::computeTorqueReference(kPaper, 560e3) / kRadius_m, 460.089e3, 0.5);
  EXPECT_NEAR(6.0 * adhesion::computeTorqueReference(kPaper, -560e3) / kRadius_m, -460.089e3, 0.5);
  EXPECT_DOUBLE_EQ(6.0 * adhesion::computeTorqueReference(kPaper, 460e3) / kRadius_m, 460e3);
}

TEST(TorqueLimitTest, RimPowerIsSharedByTheAxles) {
  const double P = 4.1e6;
  EXPECT_DOUBLE_EQ(adhesion::limitRimPower(kPaper, 40e3, 50.0, P), P / 6.0 / 50.0);  // 13.7 kN m
  EXPECT_EQ(adhesion::limitRimPower(kPaper, 40e3, 17.0, P), 40e3);                   // 0.68 of 0.683 MW
  EXPECT_EQ(adhesion::limitRimPower(kPaper, 40e3, 0.0, P), 40e3);
  EXPECT_EQ(adhesion::limitRimPower(kPaper, 40e3, 10.0, 0.0), 0.0);  // idle
}

TEST(TorqueLimitTest, RimPowerDoesNotLimitBraking) {
  EXPECT_EQ(adhesion::limitRimPower(kPaper, -40e3, 100.0, 4.1e6), -40e3);
  EXPECT_EQ(adhesion::limitRimPower(kPaper, 40e3, -100.0, 4.1e6), 40e3);
}

TEST(TorqueLimitTest, DrivingBackwardsIsTheMirrorImage) {
  EXPECT_EQ(adhesion::limitRimPower(kPaper, -40e3, -50.0, 4.1e6), -adhesion::limitRimPower(kPaper, 40e3, 50.0, 4.1e6));
}

TEST(TorqueLimitTest, TheDynamicBrakeFadesBelowHalfAMetreASecondAndNeverDrivesBackwards) {
  EXPECT_EQ(adhesion::fadeDynamicBrake(-40e3, 20.0), -40e3);
  EXPECT_EQ(adhesion::fadeDynamicBrake(-40e3, 0.5), -40e3);
  EXPECT_DOUBLE_EQ(adhesion::fadeDynamicBrake(-40e3, 0.125), -10e3);
  EXPECT_EQ(adhesion::fadeDynamicBrake(-40e3, 0.0), 0.0);
  EXPECT_EQ(adhesion::fadeDynamicBrake(-40e3, -1.0), 0.0);
  EXPECT_EQ(adhesion::fadeDynamicBrake(40e3, 0.0), 40e3);  // traction starts from rest
}

}  // namespace
