// A stretch of wheel that is said not to touch does not overlap anywhere.

#include "loco_dynamics/profile/reach_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../src/profile/overlap.hpp"
#include "profile_fixtures.hpp"

namespace {

using loco::ReachTable;
using loco::WheelsetPose;

std::vector<ReachTable::Stretch> stretchesOf(const loco::WheelRailGeometry& geometry) {
  std::vector<ReachTable::Stretch> stretches;
  constexpr double kWidth_m = 10e-3;
  for (double s = geometry.wheel().begin_m(); s < geometry.wheel().end_m(); s += kWidth_m) {
    stretches.push_back({s, std::min(s + kWidth_m, geometry.wheel().end_m())});
  }
  return stretches;
}

double largestOverlap(const loco::Overlap& overlap, const ReachTable::Stretch& stretch) {
  constexpr double kStep_m = 0.1e-3;
  double largest_m = -1.0;
  for (double s = stretch.begin_m; s <= stretch.end_m; s += kStep_m) {
    largest_m = std::max(largest_m, overlap.at(s).overlap_m());
  }
  return largest_m;
}

TEST(ReachTableTest, WhatIsSaidNotToTouchDoesNot) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (const char* wheel : {"S1002", "coned_1_20"}) {
    const loco::WheelRailGeometry geometry(loco::makeWheelPoints(wheel), loco::makeRailPoints("UIC60"), {});
    const auto stretches = stretchesOf(geometry);
    const ReachTable table(geometry, stretches);
    int overlapping = 0;
    for (int i = 0; i < 1500; ++i) {
      const double wide = i % 3 == 0 ? 3.0 : 1.0;  // off the rail, up on the flange, yawed as no wheelset is
      const WheelsetPose pose{9e-3 * wide * unit(random), -0.3e-3 + wide * 0.4e-3 * unit(random),
                              2e-3 * wide * unit(random), 0.01 * wide * unit(random)};
      const loco::Overlap overlap(geometry, pose);
      const ReachTable::Reach reach = table.reachOf(pose, geometry);
      for (std::size_t j = 0; j < stretches.size(); ++j) {
        const double largest_m = largestOverlap(overlap, stretches[j]);
        overlapping += largest_m > 0.0 ? 1 : 0;
        if (!table.mayTouch(j, reach)) {
          ASSERT_LE(largest_m, 0.0) << wheel << ' ' << i << ' ' << j;
        }
      }
    }
    EXPECT_GT(overlapping, 1000);
  }
}

TEST(ReachTableTest, OfARunningWheelMostIsPassedOver) {
  const loco::WheelRailGeometry geometry;
  const auto stretches = stretchesOf(geometry);
  const ReachTable table(geometry, stretches);
  for (const WheelsetPose& pose :
       {WheelsetPose{0.0, -0.27e-3, 0.0, 1e-3}, WheelsetPose{-4e-3, -0.15e-3, -0.25e-3, 2e-3},
        WheelsetPose{6e-3, 0.11e-3, 0.6e-3, 4e-3}}) {
    const ReachTable::Reach reach = table.reachOf(pose, geometry);
    std::size_t left = 0;
    for (std::size_t j = 0; j < stretches.size(); ++j) left += table.mayTouch(j, reach) ? 1 : 0;
    EXPECT_GE(left, 1u);
    EXPECT_LE(2 * left, stretches.size());
  }
}

TEST(ReachTableTest, OutsideTheTableNothingIsPassedOver) {
  const loco::WheelRailGeometry geometry;
  const auto stretches = stretchesOf(geometry);
  const ReachTable table(geometry, stretches);
  for (const WheelsetPose& pose : {WheelsetPose{0.1, 0.0, 0.0, 0.0}, WheelsetPose{0.0, 0.0, 0.0, 0.5}}) {
    const ReachTable::Reach reach = table.reachOf(pose, geometry);
    for (std::size_t j = 0; j < stretches.size(); ++j) EXPECT_TRUE(table.mayTouch(j, reach));
  }
}

}  // namespace
