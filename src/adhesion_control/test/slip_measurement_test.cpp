#include "adhesion_control/slip_measurement.hpp"

#include <gtest/gtest.h>

namespace {

constexpr double kRadius_m = 0.5335;  // Table 2 of the paper

TEST(SlipMeasurementTest, PureRollingHasNone) {
  EXPECT_EQ(adhesion::computeSlip(10.0 / 0.5, 10.0, 0.5), 0.0);  // exact in binary
  EXPECT_EQ(adhesion::computeSlip(0.0, 0.0, kRadius_m), 0.0);
}

TEST(SlipMeasurementTest, LockedWheelIsMinusOneFromTheFloorOn) {
  EXPECT_EQ(adhesion::computeSlip(0.0, 20.0, kRadius_m), -1.0);
  EXPECT_EQ(adhesion::computeSlip(0.0, 0.5, kRadius_m), -1.0);
  EXPECT_EQ(adhesion::computeSlip(0.0, 0.25, kRadius_m), -0.5);  // over 0.5 m/s
}

TEST(SlipMeasurementTest, IsTheExcessOfTheRimOverTheTrainsSpeed) {
  EXPECT_DOUBLE_EQ(adhesion::computeSlip(22.0, 10.0, 0.5), 0.1);
  EXPECT_DOUBLE_EQ(adhesion::computeSlip(18.0, 10.0, 0.5), -0.1);
  EXPECT_DOUBLE_EQ(adhesion::computeSlip(30.0, 10.0, 0.5), 0.5);  // over v, not over omega r
}

TEST(SlipMeasurementTest, BelowTheFloorItIsMeasuredAgainstHalfAMetrePerSecond) {
  EXPECT_DOUBLE_EQ(adhesion::computeSlip(1.0, 0.0, kRadius_m), kRadius_m / 0.5);
  EXPECT_DOUBLE_EQ(adhesion::computeSlip(1.0, 0.4, kRadius_m), (kRadius_m - 0.4) / 0.5);
  EXPECT_DOUBLE_EQ(adhesion::computeSlip(0.0, -2.0, kRadius_m), 4.0);  // rolling back counts as standing
}

}  // namespace
