// Steps of a wheelset whose creep forces are implicit (W5), with shoes (P3).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "wheelset_fixtures.hpp"

namespace {

using fixtures::cleanRail;
using fixtures::contactOf;
using fixtures::kAxleLoad_N;
using fixtures::rolling;
using loco::Vector6;
using loco::WheelsetContact;
using loco::WheelsetMotion;

constexpr double kRadius_m = fixtures::kWheelRadius_m;

TEST(WheelsetImplicitTest, CreepOfCleanSteelIsStableAtTheSpeedsFloor) {
  // explicitly, a step of 0.5 ms would have to be 20 times shorter
  const WheelsetContact contact = contactOf(fixtures::ConedWheel{}, cleanRail());
  Vector6 inertia;
  inertia << 3400.0, 3400.0, 3400.0, 2134.0, 1432.0, 2134.0;
  WheelsetMotion motion = rolling(0.5);
  motion.q[loco::kZ] = -1.1e-4;
  motion.v[loco::kY] = 1e-3;
  motion.v[loco::kYaw] = 1e-3;
  motion.v[loco::kPitch] += 1e-3;
  WheelsetContact::Contacts contacts;
  for (int i = 0; i < 200; ++i) {
    contact.compute(motion, contacts);
    Vector6 load = Vector6::Zero();
    load[loco::kZ] = -kAxleLoad_N;
    WheelsetContact::addForces(inertia, 5e-4, contacts, load, {});
    motion.v += 5e-4 * load.cwiseQuotient(inertia);
    motion.q += 5e-4 * motion.v;
  }
  EXPECT_LT(std::abs(motion.v[loco::kY]), 1e-4);
  EXPECT_LT(std::abs(motion.v[loco::kPitch] * kRadius_m - motion.v[loco::kX]), 2e-4);  // the loaded radius is smaller
}

TEST(WheelsetImplicitTest, CreepForceNeverPassesWhatFrictionOffersHoweverStiffTheCreep) {
  loco::RailConditions rail = cleanRail();
  rail.elsewhere.friction.mu0 = 0.05;
  const WheelsetContact contact = contactOf(fixtures::ConedWheel{}, rail);
  Vector6 inertia;
  inertia << 3400.0, 3400.0, 3400.0, 2134.0, 1432.0, 2134.0;
  WheelsetMotion motion = rolling(0.5);
  motion.q[loco::kZ] = -1.1e-4;
  WheelsetContact::Contacts contacts;
  double largest_use = 0.0;
  for (int i = 0; i < 400; ++i) {
    contact.compute(motion, contacts);
    Vector6 load = Vector6::Zero();
    load[loco::kY] = 15e3 * std::sin(0.05 * i);  // across and along: both components take their part
    load[loco::kZ] = -kAxleLoad_N;
    load[loco::kPitch] = 20e3;
    WheelsetContact::addForces(inertia, 5e-4, contacts, load, {});
    for (std::size_t k = 0; k < contacts.count; ++k) {
      const WheelsetContact::Contact& c = contacts.list[k];
      if (c.normal_N > 0.0) largest_use = std::max(largest_use, c.creep_N.norm() / (c.friction * c.normal_N));
    }
    motion.v += 5e-4 * load.cwiseQuotient(inertia);
    motion.v[loco::kX] = 0.5;
    motion.q += 5e-4 * motion.v;
    motion.q[loco::kY] = 0.0;
  }
  EXPECT_LE(largest_use, 1.0 + 1e-12);
  EXPECT_GT(largest_use, 0.99);
}

/// A wheelset that is drawn at a speed over a rail of little friction while shoes press.
struct Braked {
  double backwards_radps = 0.0;  ///< largest turning against the motion
  double last_radps = 0.0;       ///< turning after 50 ms
};

Braked brake(double v_mps, double shoes_N_m) {
  loco::RailConditions rail = cleanRail();
  rail.elsewhere.friction.mu0 = 0.05;  // stiff creep: the straight lines of (W5) pass what it offers
  const WheelsetContact contact = contactOf(fixtures::ConedWheel{}, rail);
  Vector6 inertia;
  inertia << 3400.0, 3400.0, 3400.0, 2134.0, 1432.0, 2134.0;
  WheelsetMotion motion = rolling(v_mps);
  motion.q[loco::kZ] = -1.1e-4;
  WheelsetContact::Contacts contacts;
  Braked result;
  for (int i = 0; i < 100; ++i) {
    contact.compute(motion, contacts);
    Vector6 load = Vector6::Zero();
    load[loco::kZ] = -kAxleLoad_N;
    WheelsetContact::addForces(inertia, 5e-4, contacts, load, {shoes_N_m, motion.v[loco::kPitch]});
    motion.v += 5e-4 * load.cwiseQuotient(inertia);
    motion.v[loco::kX] = v_mps;
    motion.q += 5e-4 * motion.v;
    result.last_radps = motion.v[loco::kPitch];
    result.backwards_radps = std::max(result.backwards_radps, -result.last_radps);
  }
  return result;
}

TEST(WheelsetImplicitTest, ShoesLockAWheelAndDoNotTurnItBackwardsAtAnySpeed) {
  for (const double v_mps : {0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005}) {
    const Braked locked = brake(v_mps, 60e3);           // 60 kN m take 0.94 rad/s in 25 ms
    EXPECT_LT(locked.backwards_radps, 1e-12) << v_mps;  // 4e-3 if friction bounds the contacts after the shoes
    EXPECT_NEAR(locked.last_radps, 0.0, 1e-12) << v_mps;
    EXPECT_GT(brake(v_mps, 1e3).last_radps, 0.9 * v_mps / kRadius_m) << v_mps;  // mu N r = 5.8 kN m keeps it rolling
  }
}

}  // namespace
