#include <gtest/gtest.h>

#include <cmath>

#include "track_reading.hpp"

namespace {

using rail::Track;

/// Curvature 0 to 0.01 over 20 m from 100 m, 30 m circular, back over 20 m; cant likewise.
Track curve(const std::string& direction = "left", double cant_mm = 0.0) {
  const TrackReading reading = readTrack(
      "name: t\nstart_km: 0\nend_km: 1\ngrades: [{from_km: 0, grade_permille: 0}]\ncurves: [{start_km: 0.1, radius_m: "
      "100, "
      "direction: " +
      direction + ", transition_in_m: 20, circular_m: 30, transition_out_m: 20, cant_mm: " + std::to_string(cant_mm) +
      "}]\nspeed_limits: [{from_km: 0, limit_kmph: 80}]\n");
  EXPECT_TRUE(reading.faults.empty());
  return reading.track;
}

rail::TrackStretch stretch(const Track& track, double from_m, double to_m) {
  std::size_t hint = 0;
  return track.stretch(from_m, to_m, hint);
}

/// The same by Simpson's rule in small pieces.
rail::TrackStretch integrated(const Track& track, double from_m, double to_m) {
  const int n = 20000;
  const double d = (to_m - from_m) / n;
  rail::TrackStretch sum;
  for (int i = 0; i < n; ++i) {
    const double s = from_m + d * i, k0 = track.at(s).curvature_1pm, k1 = track.at(s + 0.5 * d).curvature_1pm;
    const double half_rad = sum.heading_rad + 0.5 * d * 0.5 * (k0 + k1);
    const double all_rad = sum.heading_rad + d / 6.0 * (k0 + 4.0 * k1 + track.at(s + d).curvature_1pm);
    sum.lateral_m += d / 6.0 * (sum.heading_rad + 4.0 * half_rad + all_rad);
    sum.heading_rad = all_rad;
  }
  return sum;
}

TEST(TrackPlanTest, OnACircleItIsAnArc) {
  const rail::TrackStretch s = stretch(curve(), 125.0, 132.0);
  EXPECT_DOUBLE_EQ(s.heading_rad, 0.07);
  EXPECT_DOUBLE_EQ(s.lateral_m, 0.5 * 0.01 * 49.0);
}

TEST(TrackPlanTest, OnAClothoidItIsACubicParabola) {
  const rail::TrackStretch s = stretch(curve(), 100.0, 110.0);
  EXPECT_NEAR(s.heading_rad, 0.0005 * 50.0, 1e-15);
  EXPECT_NEAR(s.lateral_m, 0.0005 * 1000.0 / 6.0, 1e-15);
}

TEST(TrackPlanTest, AcrossBreakPointsItIsTheIntegralForwardAndBackward) {
  const Track track = curve();
  for (const double from_m : {90.0, 99.99, 111.0, 119.0, 149.5, 168.0})
    for (const double D : {-60.0, -11.0, -0.3, 0.0, 0.3, 11.0, 60.0}) {
      const rail::TrackStretch exact = stretch(track, from_m, from_m + D), sum = integrated(track, from_m, from_m + D);
      EXPECT_NEAR(exact.heading_rad, sum.heading_rad, 1e-9) << from_m << " " << D;  // the sum's steps straddle kinks
      EXPECT_NEAR(exact.lateral_m, sum.lateral_m, 1e-7) << from_m << " " << D;
    }
}

TEST(TrackPlanTest, SeenFromTheOtherEndItIsTheSameLine) {
  const Track track = curve();
  const double from_m = 108.0, D = 9.0;  // across the transition's end
  const rail::TrackStretch there = stretch(track, from_m, from_m + D), back = stretch(track, from_m + D, from_m);
  EXPECT_NEAR(back.heading_rad, -there.heading_rad, 1e-16);
  EXPECT_NEAR(back.lateral_m, there.heading_rad * D - there.lateral_m, 1e-15);
}

TEST(TrackPlanTest, TheHintDoesNotChangeTheAnswer) {
  const Track track = curve();
  for (std::size_t hint = 0; hint < 8; ++hint) {
    std::size_t h = hint;
    EXPECT_EQ(track.stretch(121.0, 114.0, h).lateral_m, stretch(track, 121.0, 114.0).lateral_m);
  }
}

TEST(TrackPlanTest, BeyondItsEndsTheTrackGoesOnAsItEnds) {
  EXPECT_EQ(stretch(curve(), -50.0, -10.0).heading_rad, 0.0);
  EXPECT_EQ(stretch(curve(), 5.0, -10.0).lateral_m, 0.0);
  EXPECT_EQ(stretch(curve(), 1010.0, 990.0).heading_rad, 0.0);
}

TEST(TrackPlanTest, KnowsItsTightestCurve) { EXPECT_DOUBLE_EQ(curve("right").largestCurvature(), 0.01); }

TEST(TrackPlanTest, CantLiftsTheRailOutsideTheCurve) {
  std::size_t hint = 0;
  EXPECT_NEAR(curve("left", 80.0).cant(135.0, 3.0, hint).left_m, -0.080, 1e-12);
  EXPECT_NEAR(curve("right", 80.0).cant(135.0, 3.0, hint).left_m, 0.080, 1e-12);
  EXPECT_FALSE(curve().canted());
}

TEST(TrackPlanTest, CantsRollHasTheCantOverTheRailsDistanceAsItsSine) {
  std::size_t hint = 0;
  const Track track = curve("left", 150.0);
  EXPECT_NEAR(track.cant(135.0, 3.0, hint).computeRoll_rad(), -0.1001674211615598,
              1e-12);  // the left rail is the lower
  for (const double s : {100.5, 110.0, 118.0}) {
    const double d = 1e-4, up = track.cant(s + d, 3.0, hint).computeRoll_rad(),
                 down = track.cant(s - d, 3.0, hint).computeRoll_rad();
    EXPECT_NEAR((up - down) / (2.0 * d), track.cant(s, 3.0, hint).computeRollSlope_1pm(), 1e-9) << s;
  }
}

TEST(TrackPlanTest, CantBendsGraduallyOverItsWindow) {
  const Track track = curve("left", 80.0);
  std::size_t hint = 0;
  EXPECT_EQ(track.cant(98.4, 3.0, hint).left_m, 0.0);
  EXPECT_NEAR(track.cant(110.0, 3.0, hint).left_m, -0.040, 1e-12);
  EXPECT_NEAR(track.cant(110.0, 3.0, hint).slope, -0.004, 1e-12);
  EXPECT_NEAR(track.cant(100.0, 3.0, hint).slope, -0.002, 1e-12);                     // half-way through the bend
  EXPECT_NEAR(track.cant(100.0, 3.0, hint).left_m, -0.004 * 1.5 * 1.5 / 6.0, 1e-12);  // 1.5^2/2 0.004/3
  for (const double s : {98.9, 101.2, 119.3, 151.0, 170.5}) {
    const double d = 1e-4, up = track.cant(s + d, 3.0, hint).left_m, down = track.cant(s - d, 3.0, hint).left_m;
    EXPECT_NEAR((up - down) / (2.0 * d), track.cant(s, 3.0, hint).slope, 1e-9) << s;
  }
}

TEST(TrackPlanTest, TheOuterRailsHeightBendsGraduallyWhereTheCurveTurnsTheOtherWay) {
  const TrackReading reading = readTrack(
      "name: t\nstart_km: 0\nend_km: 1\ngrades: [{from_km: 0, grade_permille: 0}]\ncurves:\n"
      "  - {start_km: 0.1, radius_m: 300, direction: left, transition_in_m: 50, circular_m: 50, transition_out_m: 50, "
      "cant_mm: 150}\n"
      "  - {start_km: 0.25, radius_m: 300, direction: right, transition_in_m: 50, circular_m: 50, transition_out_m: "
      "50, "
      "cant_mm: 150}\nspeed_limits: [{from_km: 0, limit_kmph: 80}]\n");
  ASSERT_TRUE(reading.faults.empty());
  std::size_t hint = 0;
  double last = reading.track.cant(247.0, 3.0, hint).outer_slope;
  EXPECT_NEAR(last, -0.003, 1e-12);
  for (int i = 1; i <= 600; ++i) {
    const double s_m = 247.0 + 0.01 * i;
    const rail::TrackCant cant = reading.track.cant(s_m, 3.0, hint);
    EXPECT_NEAR(cant.outer_slope, last, 0.006 / 3.0 * 0.01 + 1e-12) << s_m;  // from -3 to +3 mm/m over the window
    EXPECT_GE(cant.outer_m, std::abs(cant.left_m) - 1e-12) << s_m;
    last = cant.outer_slope;
  }
  EXPECT_NEAR(last, 0.003, 1e-12);
  EXPECT_NEAR(reading.track.cant(250.0, 3.0, hint).outer_m, 0.003 * 0.75, 1e-12);  // mean of 3 mm/m |s| over +-1.5 m
  EXPECT_NEAR(reading.track.cant(250.0, 3.0, hint).left_m, 0.0, 1e-12);
  EXPECT_NEAR(reading.track.cant(175.0, 3.0, hint).outer_m, 0.150, 1e-12);
}

}  // namespace
