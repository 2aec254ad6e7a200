#include "loco_dynamics/bogie_in_curve.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "loco_3d_fixtures.hpp"
#include "loco_dynamics/loco_factory.hpp"

namespace {

const std::string kScenario = std::string(CONFIG_DIR) + "/scenarios/paper_3d.yaml";

std::vector<std::string> faults(const std::vector<rail::Override>& overrides) {
  rail::Problems problems;
  const rail::Document document = rail::Document::load(kScenario, overrides, problems);
  const auto locomotive = loco::makeLocomotive(document, "train.groups.0.vehicle", problems);
  EXPECT_EQ(locomotive == nullptr, !problems.empty());
  return problems.lines();
}

TEST(BogieInCurveTest, TheFlangesPlayIsTheGaugeLessTheDistanceOverTheFlanges) {
  // UIC 510-2: flanges of 32.5 mm and 1360 mm between their backs
  EXPECT_NEAR(loco::computeFlangePlay_m(loco::WheelRailGeometry()), 1.435 - (1.360 + 2.0 * 32.5e-3), 0.02e-3);
  loco::WheelRailDimensions worn;
  worn.gauge_m = 1.445;
  worn.flange_back_m = 1.359;
  EXPECT_NEAR(loco::computeFlangePlay_m(loco::WheelRailGeometry(worn)),
              loco::computeFlangePlay_m(loco::WheelRailGeometry()) + 11e-3, 1e-12);
}

TEST(BogieInCurveTest, ACurveWhoseChordNeedsMoreThanThePlayIsRefusedWithItsKeyAndTheSmallestRadius) {
  EXPECT_NEAR(loco::computeSmallestRadius_m(3.7, 10e-3), 3.7 * 3.7 / 0.08, 1e-9);
  EXPECT_EQ(faults({{"track.curves.0.radius_m", "160"}}),
            std::vector<std::string>{"--set: track.curves.0.radius_m = 160: must be at least 171.2 m: a bogie with a "
                                     "wheelbase of 3.7 m, whose flanges have 10 mm of play between the rails, fits "
                                     "into no tighter curve"});
  EXPECT_EQ(faults({{"track.curves.0.radius_m", "172"}}), std::vector<std::string>());
}

TEST(BogieInCurveTest, AWiderGaugeTakesTighterCurves) {
  EXPECT_EQ(faults({{"track.curves.0.radius_m", "160"}, {"train.groups.0.vehicle.profiles.gauge_mm", "1436"}}),
            std::vector<std::string>());
}

TEST(BogieInCurveTest, ATablesCurveIsRefusedWithItsFile) {
  rail::Problems problems;
  const rail::Document document = rail::Document::load(
      kScenario, {{"track_file", std::string(CONFIG_DIR) + "/tracks/rolling_line.yaml"}}, problems);
  rail::YamlReader root(document, problems);
  const loco::LocoStructure structure = fixtures::paperParameters3d().structure;
  EXPECT_NE(loco::readTrackForBogies(root, structure, 10e-3), nullptr);
  EXPECT_EQ(loco::readTrackForBogies(root, structure, 0.1e-3), nullptr);
  ASSERT_EQ(problems.lines().size(), 1u);
  const std::string line = problems.lines().front();
  EXPECT_EQ(line.substr(line.find("rolling_line.yaml")),
            "rolling_line.yaml: table_file = rolling_line.csv: has a radius_m of 450, must be at least 17113 m: a "
            "bogie with a wheelbase of 3.7 m, whose flanges have 0.1 mm of play between the rails, fits into no "
            "tighter curve");
}

}  // namespace
