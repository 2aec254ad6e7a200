#include "plots/creep_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "loco_dynamics/contact/creepage.hpp"
#include "loco_dynamics/contact/hertz.hpp"
#include "rail_core/document.hpp"

namespace viz {
namespace {

std::string resolvedText(const std::string& scenario, const std::vector<rail::Override>& overrides = {}) {
  rail::Problems problems;
  const auto document = rail::Document::load(std::string(CONFIG_DIR) + "/scenarios/" + scenario, overrides, problems);
  EXPECT_TRUE(problems.empty()) << problems.lines().front();
  return document.text();
}

/// Adhesion of the paper's contact, from the library's parts and the numbers of config/ (co_co_134t, paper_table1).
double adhesionByTheLibrary(double creep, double axle_load_N, double speed_mps, loco::CreepMethod method) {
  const loco::HertzContact hertz({1.0 / 0.5335, 1.0 / 0.3 - 2.25}, {210e9, 0.28});
  const auto ellipse = hertz.computeEllipse(0.5 * axle_load_N);
  const auto patch = loco::makeContactPatch(ellipse.a_m, ellipse.b_m, 0.5 * axle_load_N, 82e9, 0.28);
  loco::CreepLawParameters law;
  law.method = method;
  law.friction = {0.35, 0.40, 0.275};
  law.reduction = {0.075, 0.0008, 0.30};
  law.cells = law.strips = 100;
  const double slip_mps = creep * std::max(speed_mps, 0.5);  // as AxleAdhesion.msg defines creep
  const auto creepage = loco::computeCreepage({-slip_mps, 0.0, 0.0}, speed_mps);
  return loco::CreepLaw(law).computeForce(patch, creepage).x_N / (0.5 * axle_load_N);
}

TEST(CreepCurveTest, SaysWhatIsWrongWithTheText) {
  std::string why;
  EXPECT_FALSE(CreepCurve::read("train: {", 1, why));
  EXPECT_NE(why.find("/train/configuration"), std::string::npos) << why;
  EXPECT_FALSE(CreepCurve::read("name: nothing\n", 1, why));
  EXPECT_NE(why.find("train"), std::string::npos) << why;
}

TEST(CreepCurveTest, OnlyTwoDimensionalLocomotivesHaveOne) {
  std::string why;
  EXPECT_FALSE(CreepCurve::read(resolvedText("paper_1d.yaml"), 1, why));
  EXPECT_NE(why.find("1D"), std::string::npos) << why;
  EXPECT_FALSE(CreepCurve::read(resolvedText("paper_3d.yaml"), 1, why));
  EXPECT_NE(why.find("3D"), std::string::npos) << why;
  EXPECT_FALSE(CreepCurve::read(resolvedText("paper_2d.yaml"), 4, why));
  EXPECT_NE(why.find("no locomotive 4"), std::string::npos) << why;
  EXPECT_TRUE(CreepCurve::read(resolvedText("paper_2d.yaml"), 3, why));
}

TEST(CreepCurveTest, IsTheLibrarysToTheLastBit) {
  std::string why;
  const auto curve = CreepCurve::read(resolvedText("paper_2d.yaml"), 1, why);
  ASSERT_TRUE(curve) << why;
  for (const double speed_mps : {0.2, 2.0, 10.0}) {
    for (const double creep : {-0.05, 0.0, 1e-4, 0.005, 0.03, 0.2}) {
      const double expected = adhesionByTheLibrary(creep, 219e3, speed_mps, loco::CreepMethod::kClosed);
      EXPECT_DOUBLE_EQ(curve->computeAdhesion(creep, {219e3, speed_mps, 3000.0, false}), expected);
    }
  }
}

/// The paper's own law, on a grid of 100 x 100, whose error is below 0.1 % of mu N.
TEST(CreepCurveTest, AgreesWithModifiedFastsim) {
  std::string why;
  const auto curve = CreepCurve::read(resolvedText("paper_2d.yaml"), 1, why);
  ASSERT_TRUE(curve) << why;
  for (const double creep : {0.002, 0.01, 0.05})
    EXPECT_NEAR(curve->computeAdhesion(creep, {219e3, 8.0, 3000.0, false}),
                adhesionByTheLibrary(creep, 219e3, 8.0, loco::CreepMethod::kModfastsim), 1e-3 * 0.35);
}

TEST(CreepCurveTest, PointsGoThroughTheOriginAndReachBothEnds) {
  std::string why;
  const auto curve = CreepCurve::read(resolvedText("paper_2d.yaml"), 1, why);
  ASSERT_TRUE(curve) << why;
  const auto points = curve->computePoints(-0.02, 0.1, {219e3, 8.0, 3000.0, false});
  EXPECT_NEAR(points.front().x, -0.02, 1e-15);
  EXPECT_NEAR(points.back().x, 0.1, 1e-15);
  EXPECT_GT(points.size(), 50u);
  bool origin = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) {
      EXPECT_GT(points[i].x, points[i - 1].x);
    }
    if (points[i].x == 0.0) origin = points[i].y == 0.0;
  }
  EXPECT_TRUE(origin);
  EXPECT_EQ(curve->computePoints(0.0, 0.1, {219e3, 8.0, 3000.0, false}).front().x, 0.0);
}

TEST(CreepCurveTest, KnowsTheRailOfThePlace) {
  std::string why;
  const auto curve = CreepCurve::read(
      resolvedText("paper_2d.yaml",
                   {{"rail_sections",
                     "[{from_km: 3.2, to_km: 3.3, adhesion: {name: slippery, method: closed, friction: {mu0: "
                     "0.1, A: 0.4, B_s_per_m: 0.275}, reduction: {k0: 0.075, alpha_inf: 0.0008, beta: 0.3}}}]"}}),
      1, why);
  ASSERT_TRUE(curve) << why;
  EXPECT_GT(curve->computeAdhesion(0.1, {219e3, 8.0, 3100.0, false}), 0.2);
  EXPECT_LT(curve->computeAdhesion(0.1, {219e3, 8.0, 3250.0, false}), 0.1);
}

/// Three times (a 2D locomotive, a wagon, a 1D locomotive), then a 2D locomotive: whose curve is asked for shows in
/// whether there is one.
TEST(CreepCurveTest, CountsLocomotivesThroughRepeatedGroups) {
  const std::string dir = CONFIG_DIR;
  const std::string loco = "vehicle_file: " + dir + "/locomotives/co_co_134t.yaml";
  const std::string unit =
      "{repeat: 3, groups: [{kind: locomotive, count: 1, " + loco + "}, {kind: wagon, count: 1, vehicle_file: " + dir +
      "/vehicles/wagon_120t.yaml}, {kind: locomotive, count: 1, locomotive_model: 1d, " + loco + "}]}";
  const std::string text =
      resolvedText("paper_2d.yaml", {{"train.groups", "[" + unit + ", {kind: locomotive, count: 1, " + loco + "}]"}});
  std::string why;
  for (const int locomotive : {1, 3, 5, 7}) EXPECT_TRUE(CreepCurve::read(text, locomotive, why)) << why;
  for (const int locomotive : {2, 4, 6}) {
    EXPECT_FALSE(CreepCurve::read(text, locomotive, why));
    EXPECT_NE(why.find("1D"), std::string::npos) << locomotive << ": " << why;
  }
  EXPECT_FALSE(CreepCurve::read(text, 8, why));
  EXPECT_NE(why.find("no locomotive 8"), std::string::npos) << why;
}

}  // namespace
}  // namespace viz
