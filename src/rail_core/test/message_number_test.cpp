#include "rail_core/message_number.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using rail::fixedNumber;
using rail::messageKilometres;
using rail::messageNumber;
using rail::Rounding;

TEST(MessageNumberTest, FourSignificantDigitsAndAllBeforeThePoint) {
  EXPECT_EQ(messageNumber(4440723.936429557), "4440724");
  EXPECT_EQ(messageNumber(0.0031541234), "0.003154");
  EXPECT_EQ(messageNumber(-12.3456), "-12.35");
  EXPECT_EQ(messageNumber(12345.6), "12346");
  EXPECT_EQ(messageNumber(500000.0), "500000");
  EXPECT_EQ(messageNumber(0.1 + 0.2), "0.3");
  EXPECT_EQ(messageNumber(9999.7), "10000");
  EXPECT_EQ(messageNumber(8.2123e10), "8.212e+10");
  EXPECT_EQ(messageNumber(1e9), "1e+09");
  EXPECT_EQ(messageNumber(1.5e-9), "1.5e-09");
}

TEST(MessageNumberTest, NothingIsANegativeZero) {
  EXPECT_EQ(messageNumber(-0.0), "0");
  EXPECT_EQ(fixedNumber(-0.0, 3), "0.000");
  EXPECT_EQ(fixedNumber(-0.0004, 3), "0.000");
  EXPECT_EQ(fixedNumber(-0.0006, 3), "-0.001");
  EXPECT_EQ(fixedNumber(-0.4, 0), "0");
  EXPECT_EQ(messageKilometres(-0.01), "0");
}

TEST(MessageNumberTest, WhatIsToBeTypedHasAllDigits) {
  EXPECT_EQ(rail::exactNumber(134000.25), "134000.25");
  EXPECT_EQ(rail::exactNumber(0.1 + 0.2), "0.3");
  EXPECT_EQ(rail::exactNumber(-0.0), "0");
}

TEST(MessageNumberTest, NoNumbersAreNamed) {
  EXPECT_EQ(messageNumber(std::nan("")), "nan");
  EXPECT_EQ(messageNumber(-INFINITY), "-inf");
  EXPECT_EQ(fixedNumber(-INFINITY, 1), "-inf");
}

/// Who types the limit that a message names must not be refused for its rounding.
TEST(MessageNumberTest, LimitsAreRoundedToTheSideThatKeepsThem) {
  EXPECT_EQ(messageNumber(0.00667669, Rounding::kDown), "0.006676");
  EXPECT_EQ(messageNumber(0.00667611, Rounding::kUp), "0.006677");
  EXPECT_EQ(messageNumber(-1.23456, Rounding::kDown), "-1.235");
  EXPECT_EQ(messageNumber(0.3, Rounding::kUp), "0.3");
  EXPECT_EQ(messageNumber(0.3, Rounding::kDown), "0.3");
  EXPECT_EQ(messageKilometres(1622.5, Rounding::kUp), "1.6225");
  EXPECT_EQ(messageKilometres(1622.51, Rounding::kUp), "1.6226");
  EXPECT_EQ(messageKilometres(9966.59, Rounding::kDown), "9.9665");
}

TEST(MessageNumberTest, PlacesAreToldToATenthOfAMetreHoweverFarAlongTheLine) {
  EXPECT_EQ(messageKilometres(1234567.8), "1234.5678");
  EXPECT_EQ(messageKilometres(-22.5), "-0.0225");
  EXPECT_EQ(messageKilometres(3000.0), "3");
}

}  // namespace
