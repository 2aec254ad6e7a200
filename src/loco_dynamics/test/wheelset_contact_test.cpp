#include "loco_dynamics/wheelset_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "loco_3d_fixtures.hpp"
#include "rail_core/testing/verification.hpp"

namespace {

using loco::Side;
using loco::Vector6;
using loco::WheelsetContact;
using loco::WheelsetMotion;

constexpr double kRadius_m = 0.5335;
constexpr double kAxleLoad_N = fixtures::kWeight_N / 6.0;

loco::RailConditions paperRail() {
  loco::RailConditions rail;
  rail.elsewhere = fixtures::readFile("/adhesion/paper_table1.yaml", loco::readCreepLaw);
  return rail;
}

/// Clean steel: Kalker's stiffness, friction 0.4.
loco::RailConditions cleanRail() {
  loco::RailConditions rail = paperRail();
  rail.elsewhere.friction = {0.4, 1.0, 0.0};
  rail.elsewhere.reduction = {1.0, 1.0, 0.0};
  return rail;
}

template <typename Search>
WheelsetContact contactOf(Search search, const loco::RailConditions& rail = paperRail(), double damping = 100e3) {
  return {{kRadius_m, damping, {210e9, 0.28}, 82e9}, rail, fixtures::finderOf(search)};
}

/// One contact a wheel at a given angle, whatever the pose is, with its lead.
struct GivenAngle {
  double angle_rad;  ///< of the left wheel
  double approach_m = 1e-4;
  double share = 1.0;
  std::size_t regions_of_left = 1;
  std::size_t find(Side side, const loco::WheelsetPose& pose,
                   std::array<loco::ContactRegion, loco::kMostContacts>& regions) const {
    const std::size_t found = side == Side::kLeft ? regions_of_left : 0;
    for (std::size_t i = 0; i < found; ++i) {
      loco::ContactRegion& r = regions[i];
      r.angle_rad = angle_rad;
      const double lead_m = kRadius_m * std::tan(angle_rad) * pose.yaw_rad - 0.75 * pose.yaw_rad;
      r.p_T = {lead_m, pose.y_m + 0.75, pose.z_m};
      r.rolling_radius_m = kRadius_m;
      r.approach_m = approach_m;
      r.curvature = {1.0 / kRadius_m, 3.0};
      r.share = share;
    }
    return found;
  }
};

WheelsetMotion rolling(double v_mps, double yaw_rad = 0.0) {
  WheelsetMotion motion;
  motion.q.setZero();
  motion.v.setZero();
  motion.q[loco::kYaw] = yaw_rad;
  motion.v[loco::kX] = v_mps;
  motion.v[loco::kPitch] = v_mps / kRadius_m;
  return motion;
}

TEST(WheelsetContactTest, RollingStraightAheadItSlipsNowhere) {
  WheelsetContact::Contacts contacts;
  contactOf(GivenAngle{0.0}).compute(rolling(10.0), contacts);
  ASSERT_EQ(contacts.count, 1u);
  EXPECT_NEAR(contacts.list[0].slip_mps.norm(), 0.0, 1e-12);
  EXPECT_NEAR(contacts.list[0].creep_N.norm(), 0.0, 1e-6);
}

TEST(WheelsetContactTest, OnASteepFlangeLateralCreepIsYawOverTheCosine) {
  // u_t = -omega psi r/cos gamma: the lead r tan(gamma) psi makes it 1/cos^2 = 8.5 times what it is without
  for (const double angle : {0.0, 0.5, 70.0 * M_PI / 180.0}) {
    WheelsetContact::Contacts contacts;
    contactOf(GivenAngle{angle}).compute(rolling(10.0, 1e-3), contacts);
    EXPECT_NEAR(contacts.list[0].creepage.xi_y, -1e-3 / std::cos(angle), 1e-9) << angle;
    EXPECT_NEAR(contacts.list[0].creepage.xi_x, 0.0, 1e-6) << angle;
  }
}

TEST(WheelsetContactTest, SpinIsThatOfTheWheelAlongTheNormalAndTheAbsoluteYawRate) {
  WheelsetMotion motion = rolling(10.0);
  motion.curvature_1pm = 1.0 / 300.0;
  motion.v[loco::kYaw] = 0.02;
  WheelsetContact::Contacts contacts;
  contactOf(GivenAngle{0.3}).compute(motion, contacts);
  const double spin = -10.0 / kRadius_m * std::sin(0.3) + (0.02 + 10.0 / 300.0) * std::cos(0.3);
  EXPECT_NEAR(contacts.list[0].creepage.phi_1pm, spin / 10.0, 1e-12);
}

TEST(WheelsetContactTest, InACurveTheInnerWheelHasLessWayToGo) {
  WheelsetMotion motion = rolling(10.0);
  motion.curvature_1pm = 1.0 / 300.0;
  WheelsetContact::Contacts contacts;
  contactOf(GivenAngle{0.0}).compute(motion, contacts);  // to the left: the left wheel is the inner one and drives
  EXPECT_NEAR(contacts.list[0].creepage.xi_x, -0.75 / 300.0, 1e-12);
}

TEST(WheelsetContactTest, ShareTakesItsPartOfAllForcesAndRegionsShareTheDamping) {
  WheelsetMotion motion = rolling(10.0);
  motion.v[loco::kPitch] *= 1.01;
  motion.v[loco::kZ] = -0.05;  // 5 kN of damping
  WheelsetContact::Contacts whole, half;
  contactOf(GivenAngle{0.0, 1e-4, 1.0, 1}).compute(motion, whole);
  contactOf(GivenAngle{0.0, 1e-4, 0.5, 2}).compute(motion, half);
  ASSERT_EQ(half.count, 2u);
  EXPECT_NEAR(whole.list[0].normal_N - whole.list[0].elastic_N, 5e3, 1e-6);
  EXPECT_NEAR(half.list[0].normal_N, 0.5 * whole.list[0].normal_N, 1e-6);
  EXPECT_NEAR(half.list[0].creep_N.x(), 0.5 * whole.list[0].creep_N.x(), 1e-6);
  EXPECT_NEAR(half.list[0].a_m, whole.list[0].a_m, 1e-12);  // the ellipse is the whole region's
}

TEST(WheelsetContactTest, AWheelThatLeavesItsRailIsNotHeldBack) {
  WheelsetMotion motion = rolling(10.0);
  motion.v[loco::kZ] = 10.0;
  WheelsetContact::Contacts contacts;
  contactOf(GivenAngle{0.0}).compute(motion, contacts);
  EXPECT_EQ(contacts.list[0].normal_N, 0.0);
}

TEST(WheelsetContactTest, MirroredMotionsHaveMirroredForcesToTheLastBit) {
  WheelsetMotion motion = rolling(10.0, 2e-3);
  motion.q[loco::kY] = 3e-3;
  motion.q[loco::kZ] = -2e-4;
  motion.q[loco::kRoll] = 1e-4;
  motion.v[loco::kY] = 0.01;
  motion.v[loco::kRoll] = 0.02;
  motion.v[loco::kYaw] = -0.03;
  motion.v[loco::kPitch] *= 1.01;
  motion.curvature_1pm = 1.0 / 300.0;
  WheelsetMotion mirror = motion;
  for (const loco::Dof dof : {loco::kY, loco::kRoll, loco::kYaw}) {
    mirror.q[dof] *= -1.0;
    mirror.v[dof] *= -1.0;
  }
  mirror.curvature_1pm *= -1.0;
  WheelsetContact::Contacts one, other;
  const WheelsetContact contact = contactOf(fixtures::ConedWheel{});
  contact.compute(motion, one);
  contact.compute(mirror, other);
  ASSERT_EQ(one.count, 2u);
  EXPECT_EQ(one.list[0].normal_N, other.list[1].normal_N);
  EXPECT_EQ(one.list[0].creep_N.x(), other.list[1].creep_N.x());
  EXPECT_EQ(one.list[0].creep_N.y(), -other.list[1].creep_N.y());
}

TEST(WheelsetContactTest, CreepOfCleanSteelIsStableAtTheSpeedsFloor) {
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

TEST(WheelsetContactTest, CreepForceNeverPassesWhatFrictionOffersHoweverStiffTheCreep) {
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

/// Turning of a wheelset that shoes press at 0.5 m/s on a rail of little friction, largest after `from` of 100 steps.
double largestTurningUnderShoes(double shoes_N_m, int from) {
  loco::RailConditions rail = cleanRail();
  rail.elsewhere.friction.mu0 = 0.05;  // stiff creep: the straight lines of (W5) pass what it offers
  const WheelsetContact contact = contactOf(fixtures::ConedWheel{}, rail);
  Vector6 inertia;
  inertia << 3400.0, 3400.0, 3400.0, 2134.0, 1432.0, 2134.0;
  WheelsetMotion motion = rolling(0.5);
  motion.q[loco::kZ] = -1.1e-4;
  WheelsetContact::Contacts contacts;
  double largest_radps = 0.0;
  for (int i = 0; i < 100; ++i) {
    contact.compute(motion, contacts);
    Vector6 load = Vector6::Zero();
    load[loco::kZ] = -kAxleLoad_N;
    WheelsetContact::addForces(inertia, 5e-4, contacts, load, {shoes_N_m, motion.v[loco::kPitch]});
    motion.v += 5e-4 * load.cwiseQuotient(inertia);
    motion.v[loco::kX] = 0.5;
    motion.q += 5e-4 * motion.v;
    if (i >= from) largest_radps = std::max(largest_radps, std::abs(motion.v[loco::kPitch]));
  }
  return largest_radps;
}

TEST(WheelsetContactTest, ShoesThatLockAWheelHoldItStillThoughItsRailOffersLittleFriction) {
  EXPECT_LT(largestTurningUnderShoes(60e3, 60), 1e-12);  // 60 kN m take 0.94 rad/s in 25 ms
  EXPECT_GT(largestTurningUnderShoes(1e3, 60), 0.9);     // mu N r = 5.8 kN m keeps it rolling
}

/// Wavelength of a free wheelset's motion, from its crossings of the track's centre.
double wavelength(const fixtures::ConedWheel& wheel, double v_mps) {
  const WheelsetContact contact({wheel.wheel_radius_m, 100e3, {210e9, 0.28}, 82e9}, cleanRail(),
                                fixtures::finderOf(wheel));
  Vector6 inertia;
  inertia << 3400.0, 3400.0, 3400.0, 2134.0, 1432.0, 2134.0;
  WheelsetMotion motion = rolling(v_mps);
  motion.q[loco::kY] = 1e-4;
  motion.q[loco::kZ] = -1e-4;
  WheelsetContact::Contacts contacts;
  const double h = 2e-4;
  double last_m = 0.0, s_m = 0.0, first_crossing_m = 0.0;
  int crossings = 0;
  while (crossings < 5) {
    contact.compute(motion, contacts);
    Vector6 load = Vector6::Zero();
    load[loco::kZ] = -kAxleLoad_N;
    WheelsetContact::addForces(inertia, h, contacts, load, {});
    last_m = motion.q[loco::kY];
    motion.v += h * load.cwiseQuotient(inertia);
    motion.v[loco::kX] = v_mps;
    motion.q += h * motion.v;
    s_m += h * v_mps;
    if (s_m > 200.0) break;
    if (last_m * motion.q[loco::kY] >= 0.0) continue;
    const double at_m = s_m - h * v_mps * motion.q[loco::kY] / (motion.q[loco::kY] - last_m);
    if (crossings++ == 0) first_crossing_m = at_m;
    if (crossings == 5) return (at_m - first_crossing_m) / 2.0;
  }
  return 0.0;
}

TEST(WheelsetContactTest, AFreeWheelsetWavesAsKlingelSaysAtAnySpeed) {
  // 2 pi sqrt(b r/gamma_e), gamma_e = gamma (1 + R gamma/b) on a crown of radius R. A crown whose middle is at 750 mm
  // meets the cone 15 mm inside. The tenth of a per cent that is left does not depend on the step.
  fixtures::ConedWheel knife;
  knife.crown_radius_m = 0.0;
  fixtures::ConedWheel crown;
  crown.half_distance_m = 0.735;
  crown.wheel_radius_m = kRadius_m + 0.015 / 20.0;
  for (const double v : {1.0, 10.0}) {
    const std::string at = " at " + std::to_string(static_cast<int>(v)) + " m/s";
    rail::verify({"10", "Klingel on knife-edge rails" + at, "2 pi sqrt(b r/gamma)", "m", 17.77, wavelength(knife, v),
                  0.03, "0.17 %; found 0.1 %, whatever the step"});
    rail::verify({"10", "Klingel on a 300 mm crown" + at, "2 pi sqrt(b r/gamma), 1 + R gamma/b", "m", 17.43,
                  wavelength(crown, v), 0.03, "0.17 %; found 0.1 %, whatever the step"});
  }
}

}  // namespace
