#include "loco_dynamics/profile/contact_search.hpp"

#include <gtest/gtest.h>

#include <random>

#include "profile_fixtures.hpp"

namespace {

using fixtures::normalForces;
using fixtures::NormalForces;
using fixtures::searchOf;
using loco::Side;
using loco::WheelsetPose;

TEST(ContactSearchTest, ALiftedWheelTouchesNothing) {
  std::array<loco::ContactRegion, loco::kMostContacts> regions;
  EXPECT_EQ(searchOf("S1002").find(Side::kLeft, {0.0, 1e-3, 0.0, 0.0}, regions), 0u);
  EXPECT_EQ(searchOf("S1002").find(Side::kRight, {0.0, -0.5e-3, -5e-3, 0.0}, regions), 0u);  // right wheel up
  EXPECT_EQ(searchOf("S1002").find(Side::kLeft, {0.3, 0.0, 0.0, 0.0}, regions), 0u);         // off the rail
}

/// A head and a tread that are arcs: Hertz's own case. The overlap of arcs is a parabola but for 1e-3 of it.
TEST(ContactSearchTest, ArcsHaveTheCurvaturesOfHertz) {
  loco::ProfilePoints rail, wheel;
  for (double y = -40e-3; y <= 40.01e-3; y += 0.25e-3) {
    const double from_middle = std::abs(y);
    rail.push_back({y, from_middle < 30e-3 ? 0.2 - std::sqrt(0.04 - y * y) : 2.2629e-3 + 2.0 * (from_middle - 30e-3)});
  }
  for (double y = -70e-3; y <= 60e-3; y += 0.25e-3) {  // convex, 0.5 m; and a flange far away
    wheel.push_back(
        {y, std::sqrt(0.25 - y * y) - 0.5 + (y < -40e-3 ? 28e-3 * std::exp(-std::pow((y + 55e-3) / 6e-3, 2)) : 0.0)});
  }
  loco::WheelRailDimensions dimensions;
  dimensions.inclination = 0.0;
  const loco::WheelRailGeometry geometry(wheel, rail, dimensions);
  // centre the wheel above the rail
  const WheelsetPose pose{geometry.railTop_m() - geometry.tapingLine_m(), -20e-6, 0.0, 0.0};
  std::array<loco::ContactRegion, loco::kMostContacts> regions;
  ASSERT_EQ(loco::ContactSearch(geometry).find(Side::kLeft, pose, regions), 1u);
  EXPECT_NEAR(regions[0].approach_m, 20e-6, 1e-12);
  EXPECT_NEAR(regions[0].curvature.across_1pm, 1.0 / 0.2 + 1.0 / 0.5, 0.02);
  EXPECT_NEAR(regions[0].curvature.along_1pm, 1.0 / 0.5335, 1e-6);
  EXPECT_NEAR(regions[0].angle_rad, 0.0, 1e-6);
  EXPECT_NEAR(regions[0].p_T.y(), geometry.railTop_m(), 1e-6);
}

TEST(ContactSearchTest, MirroredPosesGiveMirroredBits) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (const char* wheel : {"S1002", "coned_1_20"}) {
    const loco::ContactSearch search = searchOf(wheel);
    std::size_t touching = 0;
    for (int i = 0; i < 500; ++i) {
      const WheelsetPose pose{8e-3 * unit(random), -0.3e-3 + 0.2e-3 * unit(random), 1e-3 * unit(random),
                              0.02 * unit(random)};
      const NormalForces left = normalForces(search, Side::kLeft, pose);
      const NormalForces right =
          normalForces(search, Side::kRight, {-pose.y_m, pose.z_m, -pose.roll_rad, -pose.yaw_rad});
      ASSERT_EQ(left.count, right.count);
      touching += left.count;
      for (std::size_t j = 0; j < left.count; ++j) {
        const loco::ContactRegion &a = left.regions[j], &b = right.regions[j];
        EXPECT_EQ(a.p_T.x(), b.p_T.x());
        EXPECT_EQ(a.p_T.y(), -b.p_T.y());
        EXPECT_EQ(a.p_T.z(), b.p_T.z());
        EXPECT_EQ(a.angle_rad, -b.angle_rad);
        EXPECT_EQ(a.rolling_radius_m, b.rolling_radius_m);
        EXPECT_EQ(a.approach_m, b.approach_m);
        EXPECT_EQ(a.curvature.across_1pm, b.curvature.across_1pm);
        EXPECT_EQ(a.share, b.share);
      }
    }
    EXPECT_GT(touching, 200u);
  }
}

TEST(ContactSearchTest, SignsOfATreadContact) {
  const NormalForces left = normalForces(searchOf("coned_1_20"), Side::kLeft, {0.0, -0.6e-3, 0.0, 0.0});
  ASSERT_EQ(left.count, 1u);
  EXPECT_NEAR(left.regions[0].angle_rad, 0.05, 1e-3);  // the cone's
  EXPECT_LT(left.y_N, 0.0);                            // both wheels are pressed to the track's centre
  EXPECT_NEAR(left.regions[0].p_T.y(), 0.7456, 2e-3);  // crown 300 mm: 15 mm inside the rail's top at 0.7605
  EXPECT_NEAR(left.regions[0].rolling_radius_m, 0.5335 + (0.75 - left.regions[0].p_T.y()) / 20.0, 1e-6);
}

/// A cone of r0 - s/20: the left wheel of a wheelset to the left rolls on more radius.
TEST(ContactSearchTest, ConeRollsOnItsConicity) {
  const loco::ContactSearch search = searchOf("coned_1_20");
  const WheelsetPose pose{1e-3, -0.6e-3, 0.0, 0.0};
  const NormalForces left = normalForces(search, Side::kLeft, pose), right = normalForces(search, Side::kRight, pose);
  ASSERT_EQ(left.count, 1u);
  for (const auto& [forces, sign] : {std::pair{left, 1.0}, std::pair{right, -1.0}}) {
    const double s_m = sign * (forces.regions[0].p_T.y() - pose.y_m) - 0.75;
    EXPECT_NEAR(forces.regions[0].rolling_radius_m, 0.5335 - s_m / 20.0, 1e-7);
  }
  // the contacts move by up to 2 mm on their crowns, which takes part of 2 y/20 away
  EXPECT_NEAR(left.regions[0].rolling_radius_m - right.regions[0].rolling_radius_m, 1e-4, 2e-5);
}

/// Height at which a left wheel that comes down just touches, less 1 um.
double touchdown(const loco::ContactSearch& search, double y_m, double yaw_rad) {
  double low_m = -5e-3, high_m = 40e-3;
  for (int i = 0; i < 40; ++i) {
    const double middle_m = 0.5 * (low_m + high_m);
    (normalForces(search, Side::kLeft, {y_m, middle_m, 0.0, yaw_rad}).count > 0 ? low_m : high_m) = middle_m;
  }
  return low_m - 1e-6;
}

/// Just touching, there is next to nothing to sum up.
TEST(ContactSearchTest, ContactsBeginWithNumbers) {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const loco::ContactSearch search = searchOf("S1002");
  for (int i = 0; i < 200; ++i) {
    const double y_m = 8e-3 * unit(random), yaw_rad = 0.01 * unit(random), touching_m = touchdown(search, y_m, yaw_rad);
    for (const double above_m : {1e-6 - 1e-10, 1e-6 - 1e-12, 1e-6}) {  // 0.1 nm deep, less, 0
      const NormalForces forces = normalForces(search, Side::kLeft, {y_m, touching_m + above_m, 0.0, yaw_rad});
      EXPECT_TRUE(std::isfinite(forces.z_N));
      EXPECT_LT(std::abs(forces.z_N), 1e-3);
    }
  }
}

/// x_c = r tan(gamma) psi on top of the wheel's own way forward.
TEST(ContactSearchTest, YawMovesTheContactAheadOfTheAxle) {
  const loco::ContactSearch search = searchOf("S1002");
  for (const double yaw : {0.01, -0.01}) {
    for (const double y_m : {-2e-3, 7.5e-3}) {  // tread; flange
      const NormalForces forces = normalForces(search, Side::kLeft, {y_m, touchdown(search, y_m, yaw), 0.0, yaw});
      ASSERT_EQ(forces.count, 1u);
      const loco::ContactRegion& region = forces.regions[0];
      const double expected_m = region.rolling_radius_m * std::tan(region.angle_rad) * yaw;
      // from the axle's middle to the contact along x, without the way of 0.75 m to the taping line
      const double lead_m = region.p_T.x() + (region.p_T.y() - y_m) * std::tan(yaw);
      EXPECT_NEAR(lead_m, expected_m, 0.02 * std::abs(expected_m)) << y_m;
      EXPECT_GT(region.angle_rad, y_m > 0.0 ? 1.0 : 0.01);
    }
  }
}

TEST(ContactSearchTest, ConeHasTwoPointContact) {
  const loco::ContactSearch search = searchOf("coned_1_20");
  std::size_t most = 0;
  double angle_apart = 0.0;
  for (double y_m = 4e-3; y_m < 7e-3; y_m += 5e-6) {
    const NormalForces forces = normalForces(search, Side::kLeft, {y_m, -0.7e-3, 0.0, 0.0});
    most = std::max(most, forces.count);
    if (forces.count == 2) angle_apart = forces.regions[0].angle_rad - forces.regions[1].angle_rad;
  }
  EXPECT_EQ(most, 2u);
  EXPECT_GT(angle_apart, 0.5);  // flange and tread
}

struct Sweep {
  const char* wheel;
  WheelsetPose from, to;
};

/// Largest change of the sum of normal forces from step to step.
double largestChange(const loco::ContactSearch& search, const Sweep& sweep, int steps, std::size_t& blended) {
  double largest = 0.0, before_y = 0.0, before_z = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const double u = static_cast<double>(i) / steps;
    const auto between = [u](double a, double b) { return a + u * (b - a); };
    const NormalForces forces =
        normalForces(search, Side::kLeft,
                     {between(sweep.from.y_m, sweep.to.y_m), between(sweep.from.z_m, sweep.to.z_m),
                      between(sweep.from.roll_rad, sweep.to.roll_rad), between(sweep.from.yaw_rad, sweep.to.yaw_rad)});
    if (i > 0) largest = std::max(largest, std::hypot(forces.y_N - before_y, forces.z_N - before_z));
    before_y = forces.y_N;
    before_z = forces.z_N;
    if (forces.count > 1 && forces.regions[0].share < 1.0) ++blended;
  }
  return largest;
}

/// With an eighth of the step the largest change must be an eighth; a jump would stay as it is.
TEST(ContactSearchTest, ForcesAreContinuousInThePose) {
  const double low = -0.45e-3;
  for (const Sweep& sweep : {Sweep{"S1002", {-9e-3, -0.30e-3, 0.0, 0.0}, {6e-3, -0.30e-3, 0.0, 0.0}},
                             Sweep{"S1002", {-9e-3, -0.15e-3, 0.0, 0.0}, {6e-3, -0.15e-3, 0.0, 0.0}},
                             Sweep{"S1002", {0.0, 0.0, 0.0, 0.0}, {0.0, low, 0.0, 0.0}},
                             Sweep{"S1002", {5.5e-3, 0.2e-3, 0.0, 0.0}, {5.5e-3, low, 0.0, 0.0}},
                             Sweep{"S1002", {3e-3, -0.25e-3, 0.0, -0.02}, {3e-3, -0.25e-3, 0.0, 0.02}},
                             Sweep{"S1002", {0.0, -0.25e-3, -1e-3, 0.0}, {0.0, -0.25e-3, 1e-3, 0.0}},
                             Sweep{"coned_1_20", {-9e-3, -0.7e-3, 0.0, 0.0}, {6e-3, -0.7e-3, 0.0, 0.0}},
                             Sweep{"coned_1_20", {5.8e-3, -0.5e-3, 0.0, 0.0}, {5.8e-3, -0.9e-3, 0.0, 0.0}},
                             Sweep{"coned_1_20", {5.6e-3, -0.7e-3, 0.0, -0.02}, {5.6e-3, -0.7e-3, 0.0, 0.02}}}) {
    const loco::ContactSearch search = searchOf(sweep.wheel);
    std::size_t blended = 0;
    const double coarse = largestChange(search, sweep, 8000, blended);
    const double fine = largestChange(search, sweep, 64000, blended);
    EXPECT_LT(fine, 0.2 * coarse) << sweep.wheel << " y " << sweep.from.y_m << " z " << sweep.from.z_m << " to z "
                                  << sweep.to.z_m << " yaw " << sweep.to.yaw_rad;
    EXPECT_GT(coarse, 0.0);
  }
}

}  // namespace
