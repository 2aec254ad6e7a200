#include "loco_dynamics/exchange.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

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

/// One axle and one contact, of which one number is changed.
void expectToCount(const std::function<double&(loco::AdhesionReport&)>& number, std::size_t index) {
  loco::LocoTraction plain, changed;
  plain.adhesion.axles.resize(1);
  plain.adhesion.contacts.resize(1);
  changed = plain;
  EXPECT_TRUE(loco::samePayload(changed, plain));
  number(changed.adhesion) = 1e-300;
  EXPECT_FALSE(loco::samePayload(changed, plain)) << index;
  EXPECT_TRUE(loco::allFinite(changed));
  number(changed.adhesion) = std::nan("");
  EXPECT_FALSE(loco::allFinite(changed)) << index;
}

TEST(ExchangeTest, EveryNumberOfAnAxleCountsInTheDigest) {
  using A = loco::AxleAdhesion;
  double A::*const members[] = {&A::creep,
                                &A::adhesion,
                                &A::friction,
                                &A::static_friction,
                                &A::normal_force_N,
                                &A::force_N,
                                &A::torque_reference_N_m,
                                &A::torque_N_m,
                                &A::frictional_power_W,
                                &A::t_gamma_N};
  std::size_t index = 0;
  for (const auto member : members)
    expectToCount([member](loco::AdhesionReport& r) -> double& { return r.axles[0].*member; }, index++);
  for (const auto sides : {&A::vertical_force_N, &A::lateral_force_N})
    for (int side = 0; side < 2; ++side)
      expectToCount([&](loco::AdhesionReport& r) -> double& { return (r.axles[0].*sides)[side]; }, index++);
}

TEST(ExchangeTest, EveryNumberOfAContactCountsInTheDigest) {
  using C = loco::ContactAdhesion;
  double C::*const members[] = {&C::x_m,
                                &C::y_m,
                                &C::z_m,
                                &C::angle_rad,
                                &C::rolling_radius_m,
                                &C::a_m,
                                &C::b_m,
                                &C::normal_force_N,
                                &C::longitudinal_force_N,
                                &C::lateral_force_N,
                                &C::xi_x,
                                &C::xi_y,
                                &C::phi_1pm,
                                &C::friction};
  std::size_t index = 0;
  for (const auto member : members)
    expectToCount([member](loco::AdhesionReport& r) -> double& { return r.contacts[0].*member; }, index++);
}

TEST(ExchangeTest, ControlSideAxleAndNumbersOfThemCountInTheDigest) {
  loco::LocoTraction plain;
  plain.adhesion.axles.resize(1);
  plain.adhesion.contacts.resize(1);
  loco::LocoTraction changed[5] = {plain, plain, plain, plain, plain};
  changed[0].adhesion.axles[0].controlled = true;
  changed[1].adhesion.contacts[0].right = true;
  changed[2].adhesion.contacts[0].axle = 1;
  changed[3].adhesion.axles.resize(2);
  changed[4].adhesion.contacts.resize(2);
  for (const loco::LocoTraction& one : changed) EXPECT_FALSE(loco::samePayload(one, plain)) << &one - changed;
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
