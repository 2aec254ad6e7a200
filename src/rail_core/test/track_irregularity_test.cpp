#include "rail_core/track_irregularity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "track_reading.hpp"

namespace rail {
namespace {

using Lines = std::vector<std::string>;
constexpr char kHeader[] = "chainage_km,lateral_mm,vertical_mm,cross_level_mm,gauge_widening_mm\n";

/// Of a track from 0 to 10 km.
TrackIrregularity read(const std::string& rows, Lines* faults = nullptr) {
  Problems problems;
  TrackIrregularity irregularity = TrackIrregularity::read(kHeader + rows, "rails.csv", 0.0, 10e3, problems);
  if (faults != nullptr) *faults = problems.lines();
  EXPECT_TRUE(faults != nullptr || problems.empty()) << problems.lines().front();
  return irregularity;
}
Lines faultsOf(const std::string& rows) {
  Lines faults;
  EXPECT_TRUE(read(rows, &faults).empty());
  return faults;
}

// --- bad input

TEST(TrackIrregularityTest, ChainageMustRiseInStepsThatMeanSomethingOnTheTrack) {
  EXPECT_EQ(faultsOf("1,0,0,0,0\n1.001,1,0,0,0\n1.001,1,0,0,0\n1,0,0,0,0"),
            (Lines{"rails.csv: line 4: chainage_km = 1.001: must be > that of the row before, 1.001",
                   "rails.csv: line 5: chainage_km = 1: must be > that of the row before, 1.001"}));
  EXPECT_EQ(faultsOf("1,0,0,0,0\n1.00005,0,0,0,0\n1.0051,0,0,0,0\n1.0101,0,0,0,0"),
            (Lines{"rails.csv: line 3: chainage_km = 1.00005: must be 0.1 m to 5 m behind the row before, 1",
                   "rails.csv: line 4: chainage_km = 1.0051: must be 0.1 m to 5 m behind the row before, 1.00005"}));
  EXPECT_EQ(faultsOf("9.998,0,0,0,0\n9.999,0,0,0,0\n10.001,0,0,0,0"),
            (Lines{"rails.csv: line 4: chainage_km = 10.001: must be on the track, 0 to 10 km"}));
  EXPECT_EQ(faultsOf("1,0,0,0,0\n1.001,0,0,0,0"), (Lines{"rails.csv: chainage_km: must have three rows at least"}));
}

TEST(TrackIrregularityTest, ValuesMustBePossibleAndBeginAndEndAtZero) {
  EXPECT_EQ(faultsOf("1,0,0,0,0\n1.004,31,-31,30.5,-16\n1.008,28,-28,28,-14\n1.012,0,0,0,0"),
            (Lines{"rails.csv: line 3: lateral_mm = 31: must be a number >= -30 and <= 30",
                   "rails.csv: line 3: vertical_mm = -31: must be a number >= -30 and <= 30",
                   "rails.csv: line 3: cross_level_mm = 30.5: must be a number >= -30 and <= 30",
                   "rails.csv: line 3: gauge_widening_mm = -16: must be a number >= -15 and <= 40"}));
  EXPECT_EQ(
      faultsOf("1,1,0,0,0\n1.001,1,0,0,0\n1.002,1,0,0,2"),
      (Lines{"rails.csv: line 2: lateral_mm = 1: must be 0 in the first and in the last row, where the rails lie as "
             "designed",
             "rails.csv: line 4: lateral_mm = 1: must be 0 in the first and in the last row, where the rails lie as "
             "designed",
             "rails.csv: line 4: gauge_widening_mm = 2: must be 0 in the first and in the last row, where the rails "
             "lie as designed"}));
}

TEST(TrackIrregularityTest, StepsAndKinksAreRefused) {
  EXPECT_EQ(
      faultsOf("1,0,0,0,0\n1.001,0,0,0,0\n1.0015,0,6,0,0\n1.0025,0,6,0,0\n1.0045,0,0,0,0"),
      (Lines{"rails.csv: line 4: vertical_mm = 6: a step: it changes by 12 mm a metre, must be 10 at most",
             "rails.csv: line 4: vertical_mm = 6: a kink: its slope changes by -12 mm a metre here, must be 10 at "
             "most"}));
  EXPECT_EQ(faultsOf("1,0,0,0,0\n1.001,6,0,0,0\n1.002,0,0,0,0"),
            (Lines{"rails.csv: line 3: lateral_mm = 6: a kink: its slope changes by -12 mm a metre here, must be 10 at "
                   "most"}));
  EXPECT_FALSE(read("1,0,0,0,0\n1.001,5,0,0,0\n1.002,0,0,0,0").empty());
}

TEST(TrackIrregularityTest, ColumnsAreNamed) {
  Problems problems;
  TrackIrregularity::read("chainage_km,lateral_mm,vertical_mm,cross_level_mm,gauge_mm\n1,0,0,0,0\n", "rails.csv", 0.0,
                          10e3, problems);
  EXPECT_EQ(problems.lines(), (Lines{"rails.csv: line 1: unknown column 'gauge_mm'",
                                     "rails.csv: line 1: column 'gauge_widening_mm' is missing"}));
}

TEST(TrackIrregularityTest, ATrackHasItAsAnOptionalTable) {
  const std::string head =
      "name: n\nstart_km: 0\nend_km: 10\ngrades: [{from_km: 0, grade_permille: 0}]\ncurves: []\n"
      "speed_limits: [{from_km: 0, limit_kmph: 80}]\n";
  EXPECT_TRUE(readTrack(head).track.irregularity().empty());
  const auto with = [&head](const std::string& last) {
    return readTrack(head + "irregularity: \"" + std::string(kHeader, sizeof(kHeader) - 2) +
                     "\\n1,0,0,0,0\\n1.001,3,0,0,0\\n" + last + ",0,0,0,0\\n\"\n");
  };
  EXPECT_EQ(with("1.002").faults, Lines{});
  EXPECT_NEAR(with("1.002").track.irregularity().at(1001.0).left.y_m, 3e-3, 1e-15);
  EXPECT_EQ(with("1.1").faults,
            Lines{"track.yaml: line 4: chainage_km = 1.1: must be 0.1 m to 5 m behind the row before, 1.001"});
}

// --- limits, signs, values

TEST(TrackIrregularityTest, RailsMoveToTheLeftUpRollAndApart) {
  const TrackIrregularity all = read("1,0,0,0,0\n1.002,1,2,4,8\n1.004,0,0,0,0");
  const RailOffsets rails = all.at(1002.0);
  EXPECT_NEAR(rails.left.y_m, 1e-3 + 4e-3, 1e-15);
  EXPECT_NEAR(rails.right.y_m, 1e-3 - 4e-3, 1e-15);
  EXPECT_NEAR(rails.left.z_m, 2e-3 + 2e-3, 1e-15);
  EXPECT_NEAR(rails.right.z_m, 2e-3 - 2e-3, 1e-15);
}

TEST(TrackIrregularityTest, OutsideItsRowsTheRailsLieAsDesignedAndJoinWithoutAKink) {
  const TrackIrregularity bump = read("1,0,0,0,0\n1.002,4,2,1,3\n1.004,0,0,0,0");
  for (const double s_m : {0.0, 1000.0, 1004.0, 5000.0, std::nan("")}) {
    EXPECT_FALSE(bump.covers(s_m));
    EXPECT_EQ(bump.at(s_m).left.y_m, 0.0);
    EXPECT_EQ(bump.at(s_m).right.z_slope, 0.0);
  }
  for (const double s_m : {1000.0 + 1e-6, 1004.0 - 1e-6}) {
    EXPECT_TRUE(bump.covers(s_m));
    EXPECT_NEAR(bump.at(s_m).left.y_m, 0.0, 1e-13);     // curvature 6 * 4 mm / (2 m)^2 times (1 um)^2
    EXPECT_NEAR(bump.at(s_m).left.y_slope, 0.0, 1e-7);  // and times 1 um
  }
}

TEST(TrackIrregularityTest, ItIsACubicThroughEachPairOfRowsWithoutStepOfSlopeOrCurvature) {
  const TrackIrregularity uneven =
      read("1,0,0,0,0\n1.001,1,-2,3,1\n1.0035,-1,3,-2,2\n1.004,-2,1,-1,1\n1.008,2,2,0,-2\n1.01,0,0,0,0");
  const double h = 1e-3;
  const auto slope = [&](double s_m) { return uneven.at(s_m).left.z_slope; };
  for (const double s_m : {1001.0, 1003.5, 1004.0, 1008.0}) {
    EXPECT_NEAR(slope(s_m - 1e-9), slope(s_m + 1e-9), 1e-10) << s_m;
    const double before = (slope(s_m - 1e-9) - slope(s_m - h)) / h, after = (slope(s_m + h) - slope(s_m + 1e-9)) / h;
    EXPECT_NEAR(before, after, 5e-5) << s_m;  // third derivatives of 1e-2 and 1 mm; curvatures are 1e-3 and more
  }
  for (double s_m = 1000.3; s_m < 1009.0; s_m += 0.71) {
    const double by_difference = (uneven.at(s_m + h).right.y_m - uneven.at(s_m - h).right.y_m) / (2.0 * h);
    EXPECT_NEAR(uneven.at(s_m).right.y_slope, by_difference, 1e-8) << s_m;  // third derivative times h^2 / 6
  }
}

TEST(TrackIrregularityTest, ASineIsMetToTheFourthPowerOfTheSpacing) {
  const auto errorAt = [](int rows) {  // of 1 - cos, 20 m long, whose slope is 0 at both ends
    std::ostringstream text;
    text.precision(12);
    for (int i = 0; i <= rows; ++i) {
      const double x = i == rows ? 0.0 : static_cast<double>(i) / rows;
      text << 1.0 + 0.02 * i / rows << ',' << 5.0 * (1.0 - std::cos(2.0 * M_PI * x)) << ",0,0,0\n";
    }
    const TrackIrregularity wave = read(text.str());
    double largest_m = 0.0;
    for (double x = 0.001; x < 1.0; x += 0.001)
      largest_m =
          std::max(largest_m, std::abs(wave.at(1000.0 + 20.0 * x).left.y_m - 5e-3 * (1.0 - std::cos(2.0 * M_PI * x))));
    return largest_m;
  };
  const double coarse_m = errorAt(20), fine_m = errorAt(40);
  EXPECT_LT(coarse_m, 5e-3 * 5.0 / 384.0 * std::pow(2.0 * M_PI / 20.0, 4));  // the bound of cubic splines
  EXPECT_NEAR(coarse_m / fine_m, 16.0, 2.0);
}

}  // namespace
}  // namespace rail
