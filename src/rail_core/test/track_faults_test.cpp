#include <gtest/gtest.h>

#include "track_reading.hpp"

namespace rail {
namespace {

using Lines = std::vector<std::string>;

/// Faults of a track of lists from 0 to 10 km, of which one list is given in full.
Lines gradeFaults(const std::string& grades) {
  return readTrack(
             "{name: n, start_km: 0, end_km: 10, curves: [], speed_limits: [{from_km: 0, limit_kmph: 80}], grades: " +
             grades + "}")
      .faults;
}
Lines limitFaults(const std::string& limits) {
  return readTrack(
             "{name: n, start_km: 0, end_km: 10, curves: [], grades: [{from_km: 0, grade_permille: 0}], "
             "speed_limits: " +
             limits + "}")
      .faults;
}
Lines curveFaults(const std::string& curves) {
  return readTrack(
             "{name: n, start_km: 0, end_km: 10, grades: [{from_km: 0, grade_permille: 0}], speed_limits: "
             "[{from_km: 0, limit_kmph: 80}], curves: " +
             curves + "}")
      .faults;
}

std::string curve(const std::string& start_km, const std::string& radius_m = "300", const std::string& in_m = "50",
                  const std::string& circular_m = "200", const std::string& cant_mm = "0") {
  return "{start_km: " + start_km + ", radius_m: " + radius_m + ", direction: left, transition_in_m: " + in_m +
         ", circular_m: " + circular_m + ", transition_out_m: 50, cant_mm: " + cant_mm + "}";
}

// --- lists

TEST(TrackFaultsTest, GradesMustBeginAtTheStartRiseAndLieInTheTrack) {
  EXPECT_EQ(gradeFaults("[]"), Lines{"track.yaml: grades = [...]: must not be empty"});
  EXPECT_EQ(gradeFaults("[{from_km: 1, grade_permille: 0}]"),
            Lines{"track.yaml: grades.0.from_km = 1: the first must be start_km = 0"});
  EXPECT_EQ(gradeFaults(
                "[{from_km: 0, grade_permille: 0}, {from_km: 5, grade_permille: 0}, {from_km: 5, grade_permille: 1}]"),
            Lines{"track.yaml: grades.2.from_km = 5: must be > that of the entry before, 5"});
  EXPECT_EQ(gradeFaults("[{from_km: 0, grade_permille: 0}, {from_km: 10, grade_permille: 0}]"),
            Lines{"track.yaml: grades.1.from_km = 10: must be < end_km = 10"});
  EXPECT_EQ(gradeFaults("[{from_km: 0, grade_permille: 101}]"),
            Lines{"track.yaml: grades.0.grade_permille = 101: must be a number >= -100 and <= 100"});
  EXPECT_EQ(gradeFaults("[{from_km: 0, grade_permil: 1}]"),
            (Lines{"track.yaml: grades.0.grade_permille: is missing: must be a number >= -100 and <= 100",
                   "track.yaml: grades.0.grade_permil = 1: unknown key, did you mean 'grade_permille'?"}));
}

TEST(TrackFaultsTest, SpeedLimitsMustBeginAtTheStartAndBePositive) {
  EXPECT_EQ(limitFaults("[]"), Lines{"track.yaml: speed_limits = [...]: must not be empty"});
  EXPECT_EQ(limitFaults("[{from_km: -1, limit_kmph: 80}]"),
            Lines{"track.yaml: speed_limits.0.from_km = -1: the first must be start_km = 0"});
  EXPECT_EQ(limitFaults("[{from_km: 0, limit_kmph: 0}]"),
            Lines{"track.yaml: speed_limits.0.limit_kmph = 0: must be a number > 0"});
}

TEST(TrackFaultsTest, CurvesMustBeInOrderApartAndInTheTrack) {
  EXPECT_EQ(curveFaults("[" + curve("5") + ", " + curve("3") + "]"),
            Lines{"track.yaml: curves.1.start_km = 3: curves must be in order, the one before starts at 5"});
  EXPECT_EQ(curveFaults("[" + curve("5") + ", " + curve("5.299") + "]"),
            Lines{"track.yaml: curves.1.start_km = 5.299: overlaps the curve before, which ends at 5.3"});
  EXPECT_EQ(curveFaults("[" + curve("5") + ", " + curve("5.3") + "]"), Lines{});
  EXPECT_EQ(curveFaults("[" + curve("9.8") + "]"),
            Lines{"track.yaml: curves.0.start_km = 9.8: the curve ends at 10.1 km, beyond the track's end_km = 10"});
  EXPECT_EQ(curveFaults("[" + curve("9.7") + "]"), Lines{});
  EXPECT_EQ(curveFaults("[" + curve("-0.1") + "]"),
            Lines{"track.yaml: curves.0.start_km = -0.1: must be >= the track's start_km = 0"});
}

TEST(TrackFaultsTest, CurvesMustBePossible) {
  EXPECT_EQ(curveFaults("[" + curve("5", "49") + "]"),
            Lines{"track.yaml: curves.0.radius_m = 49: must be a number >= 50"});
  EXPECT_EQ(curveFaults("[" + curve("5", "-300") + "]"),
            Lines{"track.yaml: curves.0.radius_m = -300: must be a number >= 50"});
  EXPECT_EQ(curveFaults("[" + curve("5", "300", "-1") + "]"),
            Lines{"track.yaml: curves.0.transition_in_m = -1: must be a number >= 0"});
  EXPECT_EQ(curveFaults("[" + curve("5", "300", "50", "200", "301") + "]"),
            Lines{"track.yaml: curves.0.cant_mm = 301: must be a number >= 0 and <= 300"});
  EXPECT_EQ(curveFaults("[{start_km: 5, radius_m: 300, direction: up, transition_in_m: 0, circular_m: 10, "
                        "transition_out_m: 0, cant_mm: 0}]"),
            Lines{"track.yaml: curves.0.direction = up: must be one of: left, right"});
  EXPECT_EQ(curveFaults("[{start_km: 5, radius_m: 300, direction: left, transition_in_m: 0, circular_m: 0, "
                        "transition_out_m: 0, cant_mm: 0}]"),
            Lines{"track.yaml: curves.0.circular_m = 0: the curve has no length"});
}

TEST(TrackFaultsTest, TrackMustHaveALength) {
  const Lines faults = readTrack(
                           "{name: n, start_km: 3, end_km: 3, curves: [], grades: [{from_km: 3, grade_permille: 0}], "
                           "speed_limits: [{from_km: 3, limit_kmph: 80}]}")
                           .faults;
  EXPECT_EQ(faults, Lines{"track.yaml: end_km = 3: must be > start_km = 3"});
}

TEST(TrackFaultsTest, MissingAndUnknownKeysComeOutAtOnce) {
  EXPECT_EQ(readTrack("{nam: n, end_km: x}").faults,
            (Lines{"track.yaml: name: is missing: must be text, and not empty",
                   "track.yaml: start_km: is missing: must be a number", "track.yaml: end_km = x: must be a number",
                   "track.yaml: grades: is missing: must be a list of maps",
                   "track.yaml: curves: is missing: must be a list of maps",
                   "track.yaml: speed_limits: is missing: must be a list of maps",
                   "track.yaml: nam = n: unknown key, did you mean 'name'?"}));
}

// --- table

TEST(TrackFaultsTest, RowsMustBePossible) {
  EXPECT_EQ(readTrack(tableText("0,-101,0,0,80\n1,0,49,0,80\n2,0,-49,-1,80\n3,0,0,301,0")).faults,
            (Lines{"track.yaml: line 2: grade_permille = -101: must be a number >= -100 and <= 100",
                   "track.yaml: line 3: radius_m = 49: must be 0 (straight), <= -50 (right) or >= 50 (left)",
                   "track.yaml: line 4: radius_m = -49: must be 0 (straight), <= -50 (right) or >= 50 (left)",
                   "track.yaml: line 4: cant_mm = -1: must be a number >= 0 and <= 300",
                   "track.yaml: line 5: cant_mm = 301: must be a number >= 0 and <= 300",
                   "track.yaml: line 5: speed_limit_kmph = 0: must be a number > 0"}));
}

TEST(TrackFaultsTest, ChainageMustNotGoBackOrStandStill) {
  EXPECT_EQ(readTrack(tableText("0,0,0,0,80\n2,0,0,0,80\n1.5,0,0,0,80")).faults,
            Lines{"track.yaml: line 4: chainage_km = 1.5: must not go back, the row before is at 2"});
  EXPECT_EQ(readTrack(tableText("0,0,0,0,80\n1,0,0,0,80\n1,0,0,0,80\n1,0,0,0,80\n2,0,0,0,80")).faults,
            Lines{"track.yaml: line 5: chainage_km = 1: two rows make a jump, a third has no meaning"});
  EXPECT_EQ(readTrack(tableText("1,0,0,0,80\n1,0,0,0,80")).faults,
            Lines{"track.yaml: chainage_km: must have two different values at least"});
}

TEST(TrackFaultsTest, TableNeedsItsColumnsAndWhatLiesBetweenRows) {
  EXPECT_EQ(
      readTrack("{name: n, table: \"chainage_km\\n1\\n\", between_rows: {grade: cubic}, start_km: 0}").faults,
      (Lines{"track.yaml: between_rows.grade = cubic: must be one of: constant, linear",
             "track.yaml: between_rows.curvature: is missing: must be one of: constant, linear",
             "track.yaml: line 1: column 'grade_permille' is missing",
             "track.yaml: line 1: column 'radius_m' is missing", "track.yaml: line 1: column 'cant_mm' is missing",
             "track.yaml: line 1: column 'speed_limit_kmph' is missing",
             "track.yaml: start_km = 0: unknown key, known here: name, table, between_rows, irregularity"}));
}

TEST(TrackFaultsTest, FaultyTrackCanStillBeCalled) {
  const Track track = readTrack("{}").track;
  EXPECT_EQ(track.at(5.0).grade, 0.0);
  EXPECT_EQ(track.largestGrade(), 0.0);
}

}  // namespace
}  // namespace rail
