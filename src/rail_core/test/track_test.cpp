#include "rail_core/track.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "track_reading.hpp"

namespace rail {
namespace {

/// A track that has been read without faults, otherwise the test fails.
Track goodTrack(const std::string& text) {
  const TrackReading reading = readTrack(text);
  EXPECT_EQ(reading.faults, std::vector<std::string>{});
  return reading.track;
}

Track fileTrack(const std::string& name) {
  Problems problems;
  const Document document = Document::load(std::string(TEST_DATA_DIR) + "/data/" + name, {}, problems);
  Track track = Track::read(YamlReader(document, problems));
  EXPECT_EQ(problems.lines(), std::vector<std::string>{});
  return track;
}

/// Grades, a right and a left curve next to each other, two limits; from 2 km to 5 km.
const char kHills[] =
    "name: hills\n"
    "start_km: 2\n"
    "end_km: 5\n"
    "grades: [{from_km: 2, grade_permille: 10}, {from_km: 3, grade_permille: -5}, {from_km: 4.35, grade_permille: 0}]\n"
    "curves:\n"
    "  - {start_km: 2.5, radius_m: 400, direction: right, transition_in_m: 0, circular_m: 100, transition_out_m: 0,"
    " cant_mm: 100}\n"
    "  - {start_km: 2.6, radius_m: 500, direction: left, transition_in_m: 40, circular_m: 0, transition_out_m: 20,"
    " cant_mm: 60}\n"
    "speed_limits: [{from_km: 2, limit_kmph: 90}, {from_km: 3.2, limit_kmph: 36}]\n";

// --- the paper's line

TEST(TrackTest, PapersCurveHasItsExactCurvature) {
  for (const char* const file : {"paper_track_lists.yaml", "paper_track_table.yaml"}) {
    const Track track = fileTrack(file);
    EXPECT_DOUBLE_EQ(track.at(3325.0).curvature_1pm, 1.0 / 600.0) << file;
    EXPECT_EQ(track.at(3350.0).curvature_1pm, 1.0 / 300.0) << file;
    EXPECT_EQ(track.at(3450.0).curvature_1pm, 1.0 / 300.0) << file;
    EXPECT_NEAR(track.at(3590.0).curvature_1pm, 1.0 / 1500.0, 1e-17) << file;
    for (const double outside : {-50.0, 0.0, 3299.999, 3300.0, 3600.0, 3600.001, 9999.0, 10000.0, 11000.0}) {
      EXPECT_EQ(track.at(outside).curvature_1pm, 0.0) << file << " " << outside;
    }
  }
}

TEST(TrackTest, ListsAndTableOfThePapersLineAgreeEverywhere) {
  const Track lists = fileTrack("paper_track_lists.yaml"), table = fileTrack("paper_track_table.yaml");
  EXPECT_EQ(lists.name(), table.name());
  EXPECT_EQ(lists.start_m(), table.start_m());
  EXPECT_EQ(lists.end_m(), table.end_m());
  for (double s = -100.0; s < 10100.0; s += 0.73) {
    const TrackPoint a = lists.at(s), b = table.at(s);
    EXPECT_NEAR(a.curvature_1pm, b.curvature_1pm, 1e-17) << s;  // 1e-17 is some last bits of 1/300
    EXPECT_EQ(a.grade, b.grade);
    EXPECT_EQ(a.cant_m, b.cant_m);
    EXPECT_EQ(a.speed_limit_mps, b.speed_limit_mps);
    EXPECT_EQ(a.height_m, b.height_m);
  }
}

// --- lists

TEST(TrackTest, ValueAtABreakPointIsThatOfThePieceAhead) {
  const Track track = goodTrack(kHills);
  EXPECT_EQ(track.at(2999.999).grade, 0.01);
  EXPECT_EQ(track.at(3000.0).grade, -0.005);
  EXPECT_EQ(track.at(3199.999).speed_limit_mps, 25.0);
  EXPECT_EQ(track.at(3200.0).speed_limit_mps, 10.0);
  EXPECT_EQ(track.at(2500.0).curvature_1pm, -1.0 / 400.0);
  EXPECT_EQ(track.at(2599.999).curvature_1pm, -1.0 / 400.0);
  EXPECT_EQ(track.at(2600.0).curvature_1pm, 0.0);
}

TEST(TrackTest, CantGoesWithCurvatureAndIsNeverNegative) {
  const Track track = goodTrack(kHills);
  EXPECT_EQ(track.at(2550.0).cant_m, 0.1);  // of a right curve too
  EXPECT_DOUBLE_EQ(track.at(2610.0).cant_m, 0.015);
  EXPECT_DOUBLE_EQ(track.at(2610.0).curvature_1pm, 0.25 / 500.0);
  EXPECT_DOUBLE_EQ(track.at(2640.0).curvature_1pm, 1.0 / 500.0);
  EXPECT_DOUBLE_EQ(track.at(2655.0).curvature_1pm, 0.25 / 500.0);
  EXPECT_EQ(track.at(2660.0).cant_m, 0.0);
}

TEST(TrackTest, HeightIsTheIntegralOfTheGradeFromTheStart) {
  const Track track = goodTrack(kHills);
  EXPECT_EQ(track.at(2000.0).height_m, 0.0);
  EXPECT_DOUBLE_EQ(track.at(2500.0).height_m, 5.0);
  EXPECT_DOUBLE_EQ(track.at(3000.0).height_m, 10.0);
  EXPECT_DOUBLE_EQ(track.at(3100.0).height_m, 9.5);
  EXPECT_DOUBLE_EQ(track.at(5000.0).height_m, 10.0 - 6.75);
}

TEST(TrackTest, BeyondBothEndsTheValuesHoldAndTheHeightGoesOn) {
  const Track track = goodTrack(tableText("1,4,0,0,80\n2,8,400,90,60\n3,20,300,30,40", "linear", "linear"));
  const TrackPoint before = track.at(0.0), after = track.at(3500.0);
  EXPECT_EQ(before.grade, 0.004);
  EXPECT_EQ(before.curvature_1pm, 0.0);
  EXPECT_DOUBLE_EQ(before.height_m, -4.0);
  EXPECT_EQ(after.grade, 0.02);
  EXPECT_EQ(after.curvature_1pm, 1.0 / 300.0);
  EXPECT_EQ(after.cant_m, 0.03);
  EXPECT_DOUBLE_EQ(after.speed_limit_mps, 40.0 / 3.6);
  EXPECT_DOUBLE_EQ(after.height_m, 6.0 + 14.0 + 10.0);
}

TEST(TrackTest, NanIsNotHidden) {
  const TrackPoint point = goodTrack(kHills).at(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(std::isnan(point.grade));
  EXPECT_TRUE(std::isnan(point.height_m));
}

TEST(TrackTest, LargestAndSmallestGradeAreThoseReached) {
  const Track hills = goodTrack(kHills);
  EXPECT_EQ(hills.largestGrade(), 0.01);
  EXPECT_EQ(hills.smallestGrade(), -0.005);
  const Track jump = goodTrack(tableText("0,0,0,0,80\n1,12,0,0,80\n1,-3,0,0,80\n2,1,0,0,80", "linear"));
  EXPECT_DOUBLE_EQ(jump.largestGrade(), 0.012);  // only reached from the left
  EXPECT_EQ(jump.smallestGrade(), -0.003);
}

TEST(TrackTest, ChainagesComputedInTwoWaysAreOneBreakPoint) {
  // 4762.3 + 10.1 + 32.3 + 46.1 is 4850.800000000001 and 4.8508 * 1000 is 4850.799999999999: no overlap all the same.
  const TrackReading reading = readTrack(
      "{name: n, start_km: 4, end_km: 5, grades: [{from_km: 4, grade_permille: 0}],"
      " speed_limits: [{from_km: 4, limit_kmph: 80}], curves: ["
      "{start_km: 4.7623, radius_m: 300, direction: left, transition_in_m: 10.1, circular_m: 32.3,"
      " transition_out_m: 46.1, cant_mm: 0},"
      "{start_km: 4.8508, radius_m: 400, direction: left, transition_in_m: 0, circular_m: 149.2, transition_out_m: 0,"
      " cant_mm: 0}]}");
  EXPECT_EQ(reading.faults, std::vector<std::string>{});
  EXPECT_EQ(reading.track.at(4850.8).curvature_1pm, 1.0 / 400.0);
  EXPECT_EQ(reading.track.at(5000.0).curvature_1pm, 0.0);
}

// --- table

TEST(TrackTest, ConstantRowsHoldUntilTheNextRow) {
  const Track track = goodTrack(tableText("0,5,-400,80,90\n1,10,0,0,60\n2,0,0,0,60"));
  EXPECT_EQ(track.at(999.0).grade, 0.005);
  EXPECT_EQ(track.at(999.0).curvature_1pm, -1.0 / 400.0);
  EXPECT_EQ(track.at(999.0).cant_m, 0.08);
  EXPECT_EQ(track.at(1000.0).curvature_1pm, 0.0);
  EXPECT_DOUBLE_EQ(track.at(2000.0).height_m, 15.0);
}

TEST(TrackTest, LinearGradeIsIntegratedExactly) {
  const Track track = goodTrack(tableText("0,0,0,0,80\n1,10,0,0,80\n3,-10,0,0,80", "linear"));
  EXPECT_DOUBLE_EQ(track.at(500.0).grade, 0.005);
  EXPECT_DOUBLE_EQ(track.at(500.0).height_m, 1.25);  // 0.5 * 0.01/1000 * 500^2
  EXPECT_DOUBLE_EQ(track.at(1000.0).height_m, 5.0);
  EXPECT_DOUBLE_EQ(track.at(1500.0).height_m, 5.0 + 3.75);
  EXPECT_DOUBLE_EQ(track.at(2000.0).height_m, 10.0);  // the top
  EXPECT_DOUBLE_EQ(track.at(3000.0).height_m, 5.0);
}

TEST(TrackTest, TwoRowsAtOneChainageMakeAJump) {
  const Track track = goodTrack(tableText("0,0,0,0,80\n1,10,300,0,80\n1,2,0,0,50\n2,4,0,0,50", "linear", "linear"));
  EXPECT_NEAR(track.at(999.9999999).grade, 0.01, 1e-9);
  EXPECT_NEAR(track.at(999.9999999).curvature_1pm, 1.0 / 300.0, 1e-9);
  EXPECT_EQ(track.at(1000.0).grade, 0.002);
  EXPECT_EQ(track.at(1000.0).curvature_1pm, 0.0);
  EXPECT_DOUBLE_EQ(track.at(1000.0).speed_limit_mps, 50.0 / 3.6);
  EXPECT_DOUBLE_EQ(track.at(2000.0).height_m, 5.0 + 3.0);
}

TEST(TrackTest, CurvatureNotRadiusIsJoined) {
  const Track track = goodTrack(tableText("0,0,200,0,80\n1,0,-600,0,80", "constant", "linear"));
  EXPECT_DOUBLE_EQ(track.at(500.0).curvature_1pm, 0.5 * (1.0 / 200.0 - 1.0 / 600.0));
}

// --- the memory

TEST(TrackTest, AnyStaleHintGivesTheSameAsNone) {
  const Track track = goodTrack(kHills);
  for (double s = 1900.0; s < 5100.0; s += 7.7) {
    const TrackPoint expected = track.at(s);
    for (std::size_t stale : {0u, 1u, 3u, 5u, 8u, 1000000u}) {
      const TrackPoint point = track.at(s, stale);
      EXPECT_EQ(point.grade, expected.grade);
      EXPECT_EQ(point.curvature_1pm, expected.curvature_1pm);
      EXPECT_EQ(point.speed_limit_mps, expected.speed_limit_mps);
      EXPECT_EQ(point.height_m, expected.height_m);
    }
  }
}

TEST(TrackTest, HintFollowsAVehicleForwardAndBackAndIsAlwaysThePieceOfThePoint) {
  const Track track = goodTrack(kHills);
  std::size_t hint = 0;
  std::size_t largest = 0;
  for (double s = 1900.0; s < 5100.0; s += 0.5) {
    const std::size_t before = hint;
    EXPECT_EQ(track.at(s, hint).height_m, track.at(s).height_m);
    EXPECT_GE(hint, before);
    largest = hint;
  }
  EXPECT_EQ(largest, 8u);  // break points 2000 2500 2600 2640 2660 3000 3200 4350 5000
  for (double s = 5100.0; s > 1900.0; s -= 300.0) EXPECT_EQ(track.at(s, hint).height_m, track.at(s).height_m);
  EXPECT_EQ(hint, 0u);
}

/// Curvature 0 to 0.01 and cant 0 to 80 mm over 20 m from the track's very start.
Track curveAtTheStart() {
  return goodTrack(
      "name: t\nstart_km: 1\nend_km: 2\ngrades: [{from_km: 1, grade_permille: 0}]\ncurves: [{start_km: 1, radius_m: "
      "100, "
      "direction: left, transition_in_m: 20, circular_m: 30, transition_out_m: 20, cant_mm: 80}]\n"
      "speed_limits: [{from_km: 1, limit_kmph: 80}]\n");
}

TEST(TrackTest, BeforeTheStartThePlanIsThatOfTheStartItself) {
  const Track track = curveAtTheStart();
  std::size_t hint = 0;
  const TrackStretch before = track.stretch(980.0, 996.0, hint);  // straight: the ramp must not go on backwards
  EXPECT_EQ(before.heading_rad, 0.0);
  EXPECT_EQ(before.lateral_m, 0.0);
  const TrackStretch across = track.stretch(990.0, 1010.0, hint);
  EXPECT_NEAR(across.heading_rad, 0.0005 * 100.0 / 2.0, 1e-15);
  EXPECT_NEAR(across.lateral_m, 0.0005 * 1000.0 / 6.0, 1e-15);
  const TrackStretch back = track.stretch(1010.0, 990.0, hint);  // the same line, seen from its other end
  EXPECT_NEAR(back.heading_rad, -across.heading_rad, 1e-15);
  EXPECT_NEAR(back.lateral_m, across.heading_rad * 20.0 - across.lateral_m, 1e-14);
}

TEST(TrackTest, BeforeTheStartCantIsThatOfTheStartItself) {
  const Track track = curveAtTheStart();
  std::size_t hint = 0;
  const TrackCant before = track.cant(990.0, 3.0, hint);
  EXPECT_EQ(before.left_m, 0.0);
  EXPECT_EQ(before.slope, 0.0);
  const TrackCant across = track.cant(1000.0, 3.0, hint);
  EXPECT_NEAR(across.left_m, -0.004 * 1.5 * 1.5 / 6.0, 1e-15);
  EXPECT_NEAR(across.slope, -0.004 * 0.5, 1e-15);
  const TrackCant joint = track.cant(1020.5, 3.0, hint);  // 1 m of the ramp's end, 2 m of the circle
  EXPECT_NEAR(joint.left_m, -(0.078 * 1.0 + 0.080 * 2.0) / 3.0, 1e-12);
  EXPECT_NEAR(joint.slope, -0.004 / 3.0, 1e-12);
}

TEST(TrackTest, EqualRowsAreOnePiece) {
  std::string rows;
  for (int i = 0; i < 100; ++i) rows += std::to_string(i) + ",5,0,0,80\n";
  const Track track = goodTrack(tableText(rows + "100,5,0,0,80"));
  std::size_t hint = 50;
  track.at(99999.0, hint);
  EXPECT_EQ(hint, 0u);
}

}  // namespace
}  // namespace rail
