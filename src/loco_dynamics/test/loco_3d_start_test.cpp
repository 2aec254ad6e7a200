// Where the 3D locomotive can start, and what it says where it cannot.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "loco_3d_fixtures.hpp"
#include "loco_dynamics/profile/contact_search.hpp"

namespace {

using loco::Loco3d;
using loco::LocoStart;

Loco3d::Parameters inCurve(double radius_m, double cant_mm = 0.0) {
  Loco3d::Parameters p = fixtures::paperParameters3d();
  static const auto finder = fixtures::finderOf(loco::ContactSearch(loco::WheelRailGeometry()));
  p.finder = finder;
  p.track = fixtures::makeTrack("left", cant_mm, 50.0, radius_m);
  return p;
}

std::string failureAt(const Loco3d::Parameters& parameters, double v_mps, double location_m = 3450.0) {
  const LocoStart start = Loco3d(parameters).equilibriumState(location_m, v_mps);
  EXPECT_EQ(start.state.empty(), !start.failure.empty());
  return start.failure;
}

TEST(Loco3dStartTest, InACurveItStartsUntilItsInnerWheelsLift) {
  // the load transfer of 48.9 kN at 8.85 m/s grows with v^2 to 562 kN of the inner side's 657 kN at 30 m/s; a sudden
  // start would pass it
  EXPECT_EQ(failureAt(inCurve(300.0), 30.0), "");
  EXPECT_EQ(failureAt(inCurve(300.0), 35.0),
            "cannot start at 3.450000 km with 35 m/s: wheelset 1, left wheel, at 3.458496 km: wheel lift, no contact "
            "with its rail");
  EXPECT_EQ(failureAt(inCurve(300.0, 150.0), 35.0), "");  // 1 m/s^2 less
}

TEST(Loco3dStartTest, InACurveThatIsTooTightAWheelClimbs) {
  EXPECT_EQ(failureAt(inCurve(100.0), 2.0), "");
  EXPECT_EQ(failureAt(inCurve(80.0), 2.0),
            "cannot start at 3.450000 km with 2 m/s: wheelset 1, right wheel, at 3.458496 km: flange climb, it runs "
            "beyond the flange's largest angle");
}

/// On a run-off of 3 mm a metre that hardly curves, a bogie's end axles are rolled against it by +-slope 1.85/1.5, the
/// front one to the right. The contacts' moment about the axle's middle holds the primary springs' 2 k_z y^2 times
/// that.
TEST(Loco3dStartTest, OnARunOffTheContactsHoldTheTwistOfThePrimarySprings) {
  Loco3d::Parameters p = inCurve(300.0);
  p.track = fixtures::makeTrack("left", 150.0, 50.0, 1e6);
  p.gravity_stiffness = false;
  fixtures::Ride3d ride(p, 0.0, 3325.0);
  ride.step();
  const loco::BodyState bodies = ride.bodies();
  const auto moment_N_m = [&](std::size_t axle) {
    const auto& q = bodies.q[loco::BodyLayout::wheelset(axle)];
    const Eigen::Vector3d middle(0.0, q[loco::kY], 0.5335 + q[loco::kZ]);
    const auto& contacts = ride.locomotive.contacts(axle);
    double sum_N_m = 0.0;
    for (std::size_t i = 0; i < contacts.count; ++i)
      sum_N_m += (contacts.list[i].region.p_T - middle).cross(contacts.list[i].force_N()).x();
    return sum_N_m;
  };
  const double stiffness_N_m = 2.0 * 782e3 * 1.078 * 1.078, twist_rad = 2.0 * 0.003 * 1.85 / (1.5 * std::cos(0.05));
  for (const std::size_t first : {0, 3}) {
    const double in_frames_rad = bodies.q[loco::BodyLayout::wheelset(first)][loco::kRoll] -
                                 bodies.q[loco::BodyLayout::wheelset(first + 2)][loco::kRoll];
    EXPECT_NEAR(moment_N_m(first) - moment_N_m(first + 2), stiffness_N_m * (in_frames_rad - twist_rad), 20.0) << first;
    EXPECT_LT(std::abs(in_frames_rad), 0.05 * twist_rad) << first;
  }
}

/// A rail that pushes with more than the wheel's load, or with next to nothing.
struct Jump {
  std::size_t find(loco::Side side, const loco::WheelsetPose& pose,
                   std::array<loco::ContactRegion, loco::kMostContacts>& regions) const {
    regions[0] = {};
    regions[0].approach_m = pose.z_m > 0.0 ? 1e-6 : 1.5e-4;
    regions[0].rolling_radius_m = 0.5335;
    regions[0].p_T = {0.0, side == loco::Side::kLeft ? 0.75 : -0.75, 0.0};
    regions[0].curvature = {1.0 / 0.5335, 3.0};
    regions[0].share = 1.0;
    return 1;
  }
};

TEST(Loco3dStartTest, WhereNothingBalancesItSaysSo) {
  Loco3d::Parameters p = fixtures::paperParameters3d();
  p.finder = fixtures::finderOf(Jump{});
  EXPECT_EQ(failureAt(p, 5.0, 3000.0),
            "cannot start at 3.000000 km with 5 m/s: wheelset 1: no equilibrium was found, 145928 N or N m are left "
            "on it");
}

}  // namespace
