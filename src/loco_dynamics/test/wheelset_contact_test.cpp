#include "loco_dynamics/wheelset_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rail_core/testing/verification.hpp"
#include "wheelset_fixtures.hpp"

namespace {

using fixtures::cleanRail;
using fixtures::contactOf;
using fixtures::kAxleLoad_N;
using fixtures::paperRail;
using fixtures::rolling;
using loco::Side;
using loco::Vector6;
using loco::WheelsetContact;
using loco::WheelsetMotion;

constexpr double kRadius_m = fixtures::kWheelRadius_m;

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
