// Profiles that are shifted, noisy or stepped are refused; worn ones are not.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "loco_dynamics/profile/profile_file.hpp"
#include "profile_fixtures.hpp"

namespace {

using loco::ProfileKind;
using loco::ProfilePoints;

double bump(double x_mm) { return std::exp(-x_mm * x_mm); }

/// S1002 after long service: tread hollow by 1.5 mm, flange's flank 2.5 mm thinner.
ProfilePoints wornWheel(double step_mm) {
  const auto hollow = [](double y_mm) { return 1.5 * bump((y_mm - 3.0) / 16.0); };
  ProfilePoints points;
  for (double y = -70.0; y <= 60.0; y += step_mm) {
    const double flank = 2.5 / (1.0 + std::exp(-(y + 44.0) / 2.0)) / (1.0 + std::exp((y + 30.0) / 3.0));
    points.push_back(
        {1e-3 * y, 1e-3 * (loco::computeS1002Depth_mm(std::min(y + flank, 60.0)) - hollow(y) + hollow(0.0))});
  }
  return points;
}

/// UIC60 after long service in a curve: the crown 3 mm lower, its gauge corner 4 mm thinner.
ProfilePoints wornRail() {
  ProfilePoints points = loco::makeRailPoints("UIC60");
  for (loco::ProfilePoint& point : points) {
    const double y = 1e3 * point.y_m, z = 1e3 * point.z_m;
    point.z_m += 1e-3 * 3.0 * bump(y / 20.0);
    point.y_m += 1e-3 * 4.0 * bump((z - 8.0) / 8.0) / (1.0 + std::exp((y + 20.0) / 3.0));
  }
  return points;
}

std::string faults(ProfileKind kind, const ProfilePoints& points) {
  rail::Problems problems;
  loco::readProfileCsv(kind, fixtures::csvOf(points), "own.csv", problems);
  std::string text;
  for (const std::string& line : problems.lines()) text += line + "\n";
  return text;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// As instruments write it: to so many millimetres.
ProfilePoints rounded(ProfilePoints points, double digit_mm) {
  for (loco::ProfilePoint& point : points) point.z_m = 1e-3 * digit_mm * std::round(1e3 * point.z_m / digit_mm);
  return points;
}

ProfilePoints noisy(ProfilePoints points, double deviation_mm) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 1e-3 * deviation_mm);
  for (loco::ProfilePoint& point : points) point.z_m += noise(random);
  return points;
}

/// Every n-th point, the first and the last.
ProfilePoints thinned(const ProfilePoints& points, std::size_t n) {
  ProfilePoints thin;
  for (std::size_t i = 0; i < points.size(); i += n) thin.push_back(points[i]);
  return thin;
}

TEST(ProfileShapeTest, NewAndWornProfilesPass) {
  for (const double step_mm : {0.1, 0.25, 0.5, 0.6}) EXPECT_EQ(faults(ProfileKind::kWheel, wornWheel(step_mm)), "");
  EXPECT_EQ(faults(ProfileKind::kRail, wornRail()), "");
  EXPECT_EQ(faults(ProfileKind::kWheel, rounded(wornWheel(0.25), 1e-3)), "");
  EXPECT_EQ(faults(ProfileKind::kRail, rounded(wornRail(), 1e-3)), "");
  EXPECT_EQ(faults(ProfileKind::kRail, loco::makeRailPoints("UIC60")), "");
  for (const std::size_t n : {1U, 2U, 3U, 5U, 10U, 20U}) {
    for (const char* name : {"S1002", "coned_1_20"}) {
      EXPECT_EQ(faults(ProfileKind::kWheel, thinned(loco::makeWheelPoints(name), n)), "") << name << ' ' << n;
    }
  }
}

TEST(ProfileShapeTest, WheelsShiftedSidewaysAreRefused) {
  for (const double shift_mm : {-2.5, -0.7, 0.7, 2.5}) {
    ProfilePoints points = loco::makeWheelPoints("S1002");
    for (loco::ProfilePoint& point : points) point.y_m += 1e-3 * shift_mm;
    EXPECT_TRUE(has(faults(ProfileKind::kWheel, points), "own.csv: line 2: y_mm = -")) << shift_mm;
    EXPECT_TRUE(has(faults(ProfileKind::kWheel, points), "must be at y = -70 within 0.5 mm")) << shift_mm;
  }
}

TEST(ProfileShapeTest, NoiseIsRefused) {
  // 5 um rms on points 0.2 mm apart is 25 mrad of slope, 15 um on 0.6 mm 35 mrad
  EXPECT_TRUE(has(faults(ProfileKind::kWheel, noisy(loco::makeWheelPoints("S1002"), 5e-3)), "noise or a step"));
  EXPECT_TRUE(has(faults(ProfileKind::kWheel, noisy(wornWheel(0.6), 15e-3)), "noise or a step"));
  EXPECT_TRUE(has(faults(ProfileKind::kRail, noisy(loco::makeRailPoints("UIC60"), 5e-3)), "noise or a step"));
  EXPECT_EQ(faults(ProfileKind::kRail, noisy(loco::makeRailPoints("UIC60"), 0.5e-3)), "");
}

TEST(ProfileShapeTest, StepsAndSpikesAreNamedByLine) {
  for (const double height_mm : {-0.05, 0.05}) {
    ProfilePoints step = loco::makeWheelPoints("S1002"), spike = step;
    for (std::size_t i = 500; i < step.size(); ++i) step[i].z_m += 1e-3 * height_mm;
    EXPECT_TRUE(has(faults(ProfileKind::kWheel, step), "own.csv: line 502: z_mm")) << faults(ProfileKind::kWheel, step);
    spike[500].z_m += 1e-3 * height_mm;
    EXPECT_TRUE(has(faults(ProfileKind::kWheel, spike), "own.csv: line 502: z_mm"));
  }
  ProfilePoints spread = wornWheel(0.1);  // 0.05 mm within 0.5 mm
  for (std::size_t i = 0; i < spread.size(); ++i) {
    spread[i].z_m += 0.05e-3 * std::clamp((static_cast<double>(i) - 900.0) / 5.0, 0.0, 1.0);
  }
  EXPECT_TRUE(has(faults(ProfileKind::kWheel, spread), "noise or a step"));
}

/// Of a head measured on its gauge side, as most are, a mirror image has no gauge face.
TEST(ProfileShapeTest, AMirroredHalfHeadIsRefused) {
  ProfilePoints half = wornRail();
  half.erase(std::remove_if(half.begin(), half.end(), [](const auto& point) { return point.y_m > 26e-3; }), half.end());
  EXPECT_EQ(faults(ProfileKind::kRail, half), "");
  for (loco::ProfilePoint& point : half) point.y_m = -point.y_m;
  std::reverse(half.begin(), half.end());
  EXPECT_TRUE(has(faults(ProfileKind::kRail, half), "is the rail mirrored?")) << faults(ProfileKind::kRail, half);
}

}  // namespace
