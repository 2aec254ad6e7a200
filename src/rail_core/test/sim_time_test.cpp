#include "rail_core/sim_time.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rail {
namespace {

TEST(SimTimeTest, DecimalFractionsAreWholeNanoseconds) {
  EXPECT_EQ(wholeNanoseconds(0.002), 2000000);
  EXPECT_EQ(wholeNanoseconds(0.1 * 3), 300000000);  // 0.30000000000000004
  EXPECT_EQ(wholeNanoseconds(1e-9), 1);
  EXPECT_EQ(wholeNanoseconds(0.0), 0);
  EXPECT_EQ(wholeNanoseconds(-0.5), -500000000);
}

TEST(SimTimeTest, FractionsOfANanosecondAreRefused) {
  EXPECT_EQ(wholeNanoseconds(0.3333333333333), std::nullopt);
  EXPECT_EQ(wholeNanoseconds(1.0 / 3.0), std::nullopt);
  EXPECT_EQ(wholeNanoseconds(1.002e-9), std::nullopt);
  EXPECT_EQ(wholeNanoseconds(1.0005e-9), 1);
}

TEST(SimTimeTest, LongTimesAreWholeThoughDoublesAreCoarse) {
  EXPECT_EQ(wholeNanoseconds(86400.002), 86400002000000);
  EXPECT_EQ(wholeNanoseconds(262518.335), 262518335000000);  // times 1e9 it is 0.03 ns off
  EXPECT_EQ(wholeNanoseconds(123456.789), 123456789000000);
}

TEST(SimTimeTest, WhatNoIntegerHoldsIsRefused) {
  EXPECT_EQ(wholeNanoseconds(std::numeric_limits<double>::quiet_NaN()), std::nullopt);
  EXPECT_EQ(wholeNanoseconds(std::numeric_limits<double>::infinity()), std::nullopt);
  EXPECT_EQ(wholeNanoseconds(1e10), std::nullopt);
  EXPECT_EQ(wholeNanoseconds(-1e300), std::nullopt);
}

TEST(SimTimeTest, SecondsAreTheNearestDouble) {
  EXPECT_EQ(toSeconds(2000000), 0.002);
  EXPECT_EQ(toSeconds(86400002000000), 86400.002);
}

}  // namespace
}  // namespace rail
