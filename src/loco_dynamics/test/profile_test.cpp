// Profiles by themselves: formulas, curves, tables, how the rail is put on the track.

#include <gtest/gtest.h>

#include <cmath>

#include "loco_dynamics/profile/height_table.hpp"
#include "loco_dynamics/profile/standard_profiles.hpp"
#include "loco_dynamics/profile/wheel_rail_geometry.hpp"

namespace {

using loco::ProfilePoints;

TEST(ProfileTest, S1002HasItsPublishedDepths) {
  EXPECT_NEAR(loco::computeS1002Depth_mm(-55.0), 28.0, 1e-9);  // flange tip
  EXPECT_EQ(loco::computeS1002Depth_mm(0.0), 0.0);
  EXPECT_NEAR(loco::computeS1002Depth_mm(60.0), -2.6357, 5e-5);
}

TEST(ProfileTest, S1002PiecesMeetWithin012Micrometres) {
  for (const double joint : {32.15796, -26.0, -35.0, -38.426669, -39.764473, -49.662510, -62.764706}) {
    constexpr double kNear = 1e-9;
    EXPECT_NEAR(loco::computeS1002Depth_mm(joint - kNear), loco::computeS1002Depth_mm(joint + kNear), 1.2e-4) << joint;
  }
}

TEST(ProfileTest, ConeRunsTangentiallyIntoTheFlangeOfS1002) {
  EXPECT_NEAR(loco::computeConed120Depth_mm(-26.0), 1.3, 1e-12);
  EXPECT_NEAR(loco::computeConed120Depth_mm(40.0), -2.0, 1e-12);
  EXPECT_NEAR(loco::computeConed120Depth_mm(-26.8601), loco::computeConed120Depth_mm(-26.8599),
              3e-4);  // 2.119 is rounded
  const double slope = (loco::computeConed120Depth_mm(-26.861) - loco::computeConed120Depth_mm(-26.871)) / 0.01;
  EXPECT_NEAR(slope, -0.05, 5e-4);
  EXPECT_NEAR(loco::computeConed120Depth_mm(-55.0), 28.0 - 2.119, 1e-9);
}

TEST(ProfileTest, Uic60ArcsMeetTangentially) {
  for (const double joint : {10.5, 26.0}) {
    for (const double y : {joint, -joint}) {
      constexpr double kNear = 1e-7, kStep = 1e-3;  // just beside the joint: 1 um of slope's run is 1e-6 of slope
      const double before = loco::computeUic60Depth_mm(y - kNear), after = loco::computeUic60Depth_mm(y + kNear);
      EXPECT_NEAR(before, after, 2e-6) << y;
      EXPECT_NEAR((before - loco::computeUic60Depth_mm(y - kNear - kStep)) / kStep,
                  (loco::computeUic60Depth_mm(y + kNear + kStep) - after) / kStep, 2e-4)
          << y;
    }
  }
  EXPECT_EQ(loco::computeUic60Depth_mm(0.0), 0.0);
  EXPECT_NEAR(loco::computeUic60Depth_mm(36.010), 14.2621, 2e-3);  // nearly vertical: 1 um across is 20 um down
}

ProfilePoints circle(double radius_m, double step_rad) {
  ProfilePoints points;
  for (double angle = -1.2; angle <= 1.2; angle += step_rad) {
    points.push_back({radius_m * std::sin(angle), radius_m * (1.0 - std::cos(angle))});
  }
  return points;
}

TEST(ProfileTest, CurveFindsACirclesCurvature) {
  const loco::ProfileCurve curve(circle(0.02, 0.02));
  for (const double part : {0.3, 0.5, 0.62}) {  // away from the ends, where the spline's curvature is zero
    EXPECT_NEAR(curve.at(part * curve.length_m()).computeCurvature_1pm(), 50.0, 5e-3) << part;  // (0.02)^2/12 of it
  }
}

/// Every named profile against its formula, up to 70 degrees.
TEST(ProfileTest, TablesMeetTheFormulas) {
  const loco::WheelRailGeometry geometry;
  double largest_mm = 0.0;
  for (double s_mm = -54.0; s_mm < 59.0; s_mm += 0.0373) {
    largest_mm =
        std::max(largest_mm, std::abs(1e3 * geometry.wheel().at(1e-3 * s_mm).z_m - loco::computeS1002Depth_mm(s_mm)));
  }
  EXPECT_LT(largest_mm, 3e-4);  // the joints' 0.12 um, and what the spline makes of them at 70 degrees
}

TEST(ProfileTest, RailStandsWhereGaugeAndInclinationPutIt) {
  const loco::WheelRailGeometry geometry;
  EXPECT_NEAR(geometry.railTop_m(), 0.76054, 1e-5);  // the rail's origin that belongs to the reference tables
  EXPECT_EQ(geometry.tapingLine_m(), 0.75);
  EXPECT_NEAR(geometry.rail().at(0.0).z_m, 0.0, 1e-9);
  EXPECT_NEAR(geometry.rail().at(0.0).slope, 0.0, 1e-6);
  // the crown of 300 mm runs from 10.5 + 7.5 mm on the gauge side to 3 mm on the field side
  EXPECT_NEAR(geometry.rail().at(-0.0175).slope_1pm, 1.0 / 0.3, 0.06);
  EXPECT_NEAR(geometry.rail().at(-0.0190).slope_1pm, 1.0 / 0.08, 0.3);
  EXPECT_NEAR(geometry.rail().at(0.0025).slope_1pm, 1.0 / 0.3, 0.06);
  EXPECT_NEAR(geometry.rail().at(0.0040).slope_1pm, 1.0 / 0.08, 0.3);
  loco::WheelRailDimensions upright;
  upright.inclination = 0.0;
  const loco::WheelRailGeometry straight(upright);
  EXPECT_NEAR(straight.railTop_m(), 0.7175 + 0.03600, 5e-5);  // 14 mm below the top of an upright head
  EXPECT_NEAR(straight.rail().at(-0.009).z_m, straight.rail().at(0.009).z_m, 1e-9);
}

TEST(ProfileTest, AFlangeClimbsUpToTheEndOfItsSteepestPart) {
  const double alike_m = 1e-4;  // where an arc of 20 mm has turned by 2 mrad, and the scan's step on 70 degrees
  const loco::WheelRailGeometry s1002;
  EXPECT_NEAR(s1002.computeClimbRise_m(), 1e-3 * loco::computeS1002Depth_mm(-39.764473), alike_m);
  const loco::WheelRailGeometry cone(loco::makeWheelPoints("coned_1_20"), loco::makeRailPoints("UIC60"), {});
  EXPECT_NEAR(cone.computeClimbRise_m(), s1002.computeClimbRise_m() - 2.119e-3, alike_m);
}

TEST(ProfileTest, NamesOfNoProfileGiveNoPoints) {
  EXPECT_TRUE(loco::makeWheelPoints("s1002").empty());
  EXPECT_TRUE(loco::makeRailPoints("S1002").empty());
}

}  // namespace
