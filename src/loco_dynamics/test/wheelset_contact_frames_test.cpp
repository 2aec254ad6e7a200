// Signs of what a wheelset's contacts see: a turning frame, a rolled axle, running backwards.

#include <gtest/gtest.h>

#include <cmath>

#include "loco_3d_fixtures.hpp"
#include "loco_dynamics/wheelset_contact.hpp"

namespace {

using loco::Side;
using loco::WheelsetContact;
using loco::WheelsetMotion;

constexpr double kRadius_m = 0.5335, kKappa_1pm = 1.0 / 300.0;

loco::RailConditions paperRail() {
  loco::RailConditions rail;
  rail.elsewhere = fixtures::readFile("/adhesion/paper_table1.yaml", loco::readCreepLaw);
  return rail;
}

template <typename Search>
WheelsetContact contactOf(Search search) {
  return {{kRadius_m, 100e3, {210e9, 0.28}, 82e9}, paperRail(), fixtures::finderOf(search)};
}

/// One contact of the left wheel with this angle and lead, whatever the pose is.
struct GivenLead {
  double angle_rad, lead_m;
  std::size_t find(Side side, const loco::WheelsetPose& pose,
                   std::array<loco::ContactRegion, loco::kMostContacts>& regions) const {
    if (side == Side::kRight) return 0;
    loco::ContactRegion& r = regions[0];
    r = {};
    r.angle_rad = angle_rad;
    r.p_T = {lead_m, pose.y_m + 0.75, pose.z_m};
    r.rolling_radius_m = kRadius_m;
    r.approach_m = 1e-4;
    r.curvature = {1.0 / kRadius_m, 3.0};
    r.share = 1.0;
    return 1;
  }
};

WheelsetMotion rolling(double v_mps) {
  WheelsetMotion motion;
  motion.q.setZero();
  motion.v.setZero();
  motion.v[loco::kX] = v_mps;
  motion.v[loco::kPitch] = v_mps / kRadius_m;
  return motion;
}

TEST(WheelsetContactFramesTest, AheadOfItsAxleAWheelThatFollowsACurveSlipsToTheInside) {
  // like any body that goes round a centre at (0, R): there its velocity points to the left by x/R
  WheelsetMotion straight = rolling(10.0), curve = straight;
  curve.curvature_1pm = kKappa_1pm;
  for (const double angle : {0.0, 0.5}) {
    WheelsetContact::Contacts with, without;
    const WheelsetContact contact = contactOf(GivenLead{angle, 0.02});
    contact.compute(curve, with);
    contact.compute(straight, without);
    EXPECT_NEAR(with.list[0].slip_mps.y() - without.list[0].slip_mps.y(), 10.0 * kKappa_1pm * 0.02 * std::cos(angle),
                1e-12);
  }
}

TEST(WheelsetContactFramesTest, AWheelsetWhoseAxleLiesInTheContactsPlaneDoesNotSpin) {
  WheelsetMotion motion = rolling(10.0);
  motion.q[loco::kRoll] = 0.02;  // left end up
  WheelsetContact::Contacts contacts;
  contactOf(GivenLead{0.02, 0.0}).compute(motion, contacts);
  EXPECT_NEAR(contacts.list[0].creepage.phi_1pm, 0.0, 0.02 * 0.02 * 0.02 / kRadius_m);  // sin and tan, cubed
  motion.q[loco::kRoll] = -0.02;
  contactOf(GivenLead{0.02, 0.0}).compute(motion, contacts);
  EXPECT_NEAR(contacts.list[0].creepage.phi_1pm, -0.04 / kRadius_m, 1e-5);
}

/// Seen from someone who looks the other way, a wheelset that runs backwards runs forwards.
TEST(WheelsetContactFramesTest, RunningBackwardsIsRunningForwardsSeenFromBehind) {
  WheelsetMotion forward = rolling(10.0);
  forward.q << 0.0, 3e-3, -2e-4, 1e-4, 0.0, 2e-3;
  forward.v += (loco::Vector6() << 0.0, 0.01, 0.0, 0.02, 0.1, -0.03).finished();
  forward.curvature_1pm = kKappa_1pm;
  WheelsetMotion back = forward;
  for (const loco::Dof dof : {loco::kX, loco::kY, loco::kRoll, loco::kPitch}) {  // all but z and what turns about it
    back.q[dof] *= -1.0;
    back.v[dof] *= -1.0;
  }
  back.curvature_1pm *= -1.0;
  WheelsetContact::Contacts one, other;
  const WheelsetContact contact = contactOf(fixtures::ConedWheel{});
  contact.compute(forward, one);
  contact.compute(back, other);
  ASSERT_EQ(one.count, 2u);
  ASSERT_EQ(other.count, 2u);
  for (std::size_t side = 0; side < 2; ++side) {
    const WheelsetContact::Contact &a = one.list[side], &b = other.list[1 - side];
    EXPECT_GT(std::abs(a.creep_N.y()), 100.0);
    EXPECT_NEAR(b.normal_N, a.normal_N, 1e-6);
    EXPECT_NEAR(b.creepage.phi_1pm, a.creepage.phi_1pm, 1e-12);
    EXPECT_NEAR(b.creep_N.x(), -a.creep_N.x(), 1e-6) << side;  // round-off of 1e5 N
    EXPECT_NEAR(b.creep_N.y(), -a.creep_N.y(), 1e-6) << side;
  }
}

}  // namespace
