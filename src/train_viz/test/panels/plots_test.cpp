#include "plots/plots.hpp"

#include <gtest/gtest.h>

#include "panels/plot_settings.hpp"
#include "plots/legend_corner.hpp"
#include "rail_core/document.hpp"

namespace viz {
namespace {

/// Two locomotives, three couplers, at 3.0 and 3.1 km.
RunData exampleRun() {
  RunData run;
  for (int i = 0; i < 2; ++i) {
    TrainSample train;
    train.time_s = 1.0 + i;
    train.place_m = 3000.0 + 100.0 * i;
    train.speed_mps = 10.0;
    train.speed_limit_mps = 20.0;
    train.notch = {1.0 + i, 4.0};
    train.brake_notch = {0.0, 3.0};
    train.traction_N = {100e3, -50e3};
    train.coupler_N = {300e3 - 100e3 * i, -20e3, 5e3};
    run.add(train);
    run.add(EnergySample{train.time_s, {2e6 * i, 3e6 * i}, {2.5e6 * i, 3.5e6 * i}, {0.0, 1e6 * i}});
    run.add(AdhesionSample{train.time_s, train.place_m, 10.0, {{0.01 * (1 + i), 0.1, 219e3}, {0.02, 0.2, 219e3}}});
  }
  return run;
}

const Curve& curveNamed(const PlotData& plot, const std::string& name) {
  for (const Curve& curve : plot.curves)
    if (curve.name == name) return curve;
  ADD_FAILURE() << "no curve " << name << " in " << plot.title;
  static const Curve none;
  return none;
}

TEST(PlotsTest, AnEmptyRunSaysWhatItWaitsFor) {
  for (const PlotKind kind : allPlots()) {
    const PlotData plot = computePlot(kind, RunData());
    EXPECT_TRUE(plot.empty());
    EXPECT_FALSE(plot.remark.empty()) << plot.title;
  }
}

TEST(PlotsTest, EveryAxisNamesItsUnit) {
  const RunData run = exampleRun();
  for (const PlotKind kind : allPlots()) {
    const PlotData plot = computePlot(kind, run);
    EXPECT_NE(plot.x_title.find('['), std::string::npos) << plot.title;
    EXPECT_NE(plot.y_title.find('['), std::string::npos) << plot.title;
    EXPECT_FALSE(plot.empty());
  }
}

TEST(PlotsTest, TractionIsInKilonewtonsOverKilometres) {
  const PlotData plot = computePlot(PlotKind::kTraction, exampleRun());
  ASSERT_EQ(plot.curves.size(), 2u);
  const Point last = curveNamed(plot, "locomotive 2").points.back();
  EXPECT_DOUBLE_EQ(last.x, 3.1);
  EXPECT_DOUBLE_EQ(last.y, -50.0);
}

TEST(PlotsTest, EnergyIsTheChosenLocomotives) {
  RunData run = exampleRun();
  EXPECT_DOUBLE_EQ(curveNamed(computePlot(PlotKind::kEnergy, run), "at the rail, Eq. (4)").points.back().y, 2.0);
  run.setLocomotive(2);
  const PlotData plot = computePlot(PlotKind::kEnergy, run);
  EXPECT_DOUBLE_EQ(curveNamed(plot, "at the wheel rims").points.back().y, 3.5);
  EXPECT_DOUBLE_EQ(curveNamed(plot, "recovered at the rims").points.back().y, 1.0);
  run.setLocomotive(3);
  EXPECT_EQ(computePlot(PlotKind::kEnergy, run).remark, "the train has no locomotive 3");
}

TEST(PlotsTest, CouplersCountFromTheHeadWithDraftAboveAndBuffBelow) {
  const PlotData plot = computePlot(PlotKind::kCouplers, exampleRun());
  const Curve& now = curveNamed(plot, "now");
  ASSERT_EQ(now.points.size(), 3u);
  EXPECT_EQ(now.points[0].x, 1.0);
  EXPECT_DOUBLE_EQ(now.points[0].y, 200.0);
  EXPECT_DOUBLE_EQ(now.points[1].y, -20.0);
  EXPECT_DOUBLE_EQ(curveNamed(plot, "largest draft so far").points[0].y, 300.0);
  EXPECT_DOUBLE_EQ(curveNamed(plot, "largest buff so far").points[1].y, -20.0);
}

TEST(PlotsTest, SpeedIsInKilometresPerHourAndNotchesAreAtTheRight) {
  RunData run = exampleRun();
  run.setLocomotive(2);
  const PlotData plot = computePlot(PlotKind::kSpeed, run);
  EXPECT_DOUBLE_EQ(curveNamed(plot, "speed").points.back().y, 36.0);
  EXPECT_DOUBLE_EQ(curveNamed(plot, "speed limit").points.back().y, 72.0);
  EXPECT_EQ(curveNamed(plot, "brake notch").points.back().y, 3.0);
  EXPECT_TRUE(curveNamed(plot, "notch").right_axis);
  EXPECT_FALSE(plot.right_title.empty());
}

TEST(PlotsTest, AdhesionHasTheCurveBehindThePoints) {
  RunData run = exampleRun();
  PlotData plot = computePlot(PlotKind::kAdhesion, run);
  EXPECT_EQ(plot.curves.size(), 4u) << "two axles, passed and now";
  EXPECT_DOUBLE_EQ(curveNamed(plot, "axle 1").points.back().x, 0.02);
  EXPECT_EQ(curveNamed(plot, "axle 1, passed").points.size(), 2u);
  rail::Problems problems;
  run.setRun(1, rail::Document::load(std::string(CONFIG_DIR) + "/scenarios/paper_2d.yaml", {}, problems).text());
  plot = computePlot(PlotKind::kAdhesion, run);
  ASSERT_EQ(plot.curves.size(), 5u) << plot.remark;
  EXPECT_EQ(plot.curves[0].style, CurveStyle::kBackground);
  ASSERT_TRUE(run.creepCurve());
  const Point last = plot.curves[0].points.back();
  EXPECT_EQ(last.y, run.creepCurve()->computeAdhesion(last.x, {219e3, 10.0, 3100.0, false}));
}

TEST(PlotsTest, NamesFindTheirPlots) {
  for (const PlotKind kind : allPlots()) EXPECT_EQ(plotNamed(nameOf(kind)), kind);
  EXPECT_FALSE(plotNamed("tracktion"));
}

TEST(PlotSettingsTest, ReadsNamesAndRefusesOthers) {
  std::string problem;
  EXPECT_EQ(plotsOf(namesOf(allPlots()), problem), allPlots());
  EXPECT_EQ(problem, "");
  EXPECT_EQ(plotsOf(" speed ,energy", problem), (std::vector<PlotKind>{PlotKind::kSpeed, PlotKind::kEnergy}));
  EXPECT_EQ(plotsOf("speed, tracktion", problem), std::vector<PlotKind>{PlotKind::kSpeed});
  EXPECT_NE(problem.find("'tracktion'"), std::string::npos);
}

TEST(PlotSettingsTest, TheAdhesionTopicHasTheLocomotivesNumber) {
  PlotSettings settings;
  settings.locomotive = 12;
  EXPECT_EQ(adhesionTopicOf(settings), "/loco_12/adhesion");
  settings.adhesion_topic = "/one/adhesion";
  EXPECT_EQ(adhesionTopicOf(settings), "/one/adhesion");
}

PlotData lineFrom(double from, double to) {
  PlotData plot;
  Curve line{"line", CurveStyle::kLine, 0, false, true, {}};
  for (int i = 0; i <= 100; ++i) line.points.push_back({3.0 + 0.01 * i, from + 0.01 * i * (to - from)});
  plot.curves = {line};
  return plot;
}

TEST(LegendCornerTest, StaysWhereItHidesNothing) {
  EXPECT_EQ(emptiestCorner(PlotData()), LegendCorner::kBottomRight);
  EXPECT_EQ(emptiestCorner(lineFrom(0.0, 400.0)), LegendCorner::kBottomRight);
  PlotData plot = lineFrom(0.0, 400.0);
  plot.legend = LegendCorner::kTopLeft;
  EXPECT_EQ(emptiestCorner(plot), LegendCorner::kTopLeft);
}

TEST(LegendCornerTest, GivesWayToABrakingTrain) {
  EXPECT_EQ(emptiestCorner(lineFrom(0.0, -350.0)), LegendCorner::kTopRight);
  EXPECT_EQ(emptiestCorner(lineFrom(80.0, 0.0)), LegendCorner::kTopRight);
}

/// Notches that are all 0 lie at the bottom, though they span nothing.
TEST(LegendCornerTest, NotchesAllZeroAreSeen) {
  PlotData plot = lineFrom(80.0, 80.0);
  plot.curves.push_back(lineFrom(0.0, 0.0).curves[0]);
  plot.curves.back().right_axis = true;
  plot.curves.push_back(plot.curves.back());
  EXPECT_EQ(emptiestCorner(plot), LegendCorner::kTopLeft) << "one curve instead of two";
}

/// Notches are measured on the axis at the right: 8 of 8 is at the top.
TEST(LegendCornerTest, EachCurveIsPlacedByItsOwnAxis) {
  PlotData plot = lineFrom(80.0, 0.0);  // leaves top right and bottom left
  plot.curves.push_back(lineFrom(8.0, 8.0).curves[0]);
  plot.curves.back().right_axis = true;
  EXPECT_EQ(emptiestCorner(plot), LegendCorner::kBottomLeft);
}

}  // namespace
}  // namespace viz
