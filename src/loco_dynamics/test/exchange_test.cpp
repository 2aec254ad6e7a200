#include "loco_dynamics/exchange.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

TEST(ExchangeTest, EveryNumberOfAForceCountsInItsDigest) {
  double loco::LocoForce::*const members[] = {&loco::LocoForce::traction_reference_N,
                                              &loco::LocoForce::notch,
                                              &loco::LocoForce::rim_power_limit_W,
                                              &loco::LocoForce::coupler_front_N,
                                              &loco::LocoForce::coupler_rear_N,
                                              &loco::LocoForce::propulsion_resistance_N,
                                              &loco::LocoForce::curving_resistance_N,
                                              &loco::LocoForce::grade_N,
                                              &loco::LocoForce::speed_mps,
                                              &loco::LocoForce::location_m};
  for (const auto member : members) {
    loco::LocoForce changed;
    changed.*member = 1e-300;
    EXPECT_FALSE(loco::samePayload(changed, loco::LocoForce{}));
    changed.*member = std::nan("");
    EXPECT_FALSE(loco::allFinite(changed));
  }
}

TEST(ExchangeTest, EveryNumberOfATractionCountsInItsDigest) {
  double loco::LocoTraction::*const members[] = {&loco::LocoTraction::traction_N, &loco::LocoTraction::speed_mps,
                                                 &loco::LocoTraction::location_m, &loco::LocoTraction::work_rim_J,
                                                 &loco::LocoTraction::work_slip_J};
  for (const auto member : members) {
    loco::LocoTraction changed;
    changed.*member = -0.0;  // another bit pattern than +0
    EXPECT_FALSE(loco::samePayload(changed, loco::LocoTraction{}));
    changed.*member = INFINITY;
    EXPECT_FALSE(loco::allFinite(changed));
  }
}

TEST(ExchangeTest, StateLengthAndContentCountInTheDigest) {
  loco::LocoTraction a, b;
  a.state = {0.0};
  EXPECT_FALSE(loco::samePayload(a, b));
  b.state = {1.0};
  EXPECT_FALSE(loco::samePayload(a, b));
  b.state = {0.0};
  EXPECT_TRUE(loco::samePayload(a, b));
  b.state = {std::nan("")};
  EXPECT_FALSE(loco::allFinite(b));
}

}  // namespace
