#include "loco_dynamics/step_limit.hpp"

#include <cmath>

#include "loco_2d_fixtures.hpp"

namespace {

using loco::BodyLayout;

const std::vector<loco::Dof> kPlanar = {loco::kX, loco::kZ, loco::kPitch};

/// One bogie frame between a held car body and held wheelsets: a single mass k, c, m.
loco::LinearModel oneMass(double k, double c, double m) {
  loco::LinearModel model;
  model.coordinates = {{BodyLayout::bogie(0), loco::kZ}};
  model.names = {"bogie frame 1, vertical"};
  model.inertia = Eigen::VectorXd::Constant(1, m);
  model.stiffness = Eigen::MatrixXd::Constant(1, 1, k);
  model.damping = Eigen::MatrixXd::Constant(1, 1, c);
  model.damper_stretch = Eigen::MatrixXd(0, 1);
  return model;
}

loco::StepLimit paperLimit(const std::vector<rail::Override>& overrides, double wheel_stiffness_N_per_m) {
  return loco::computeStepLimit(loco::linearise(fixtures::paperStructure(overrides), loco::allCoordinates(kPlanar),
                                                {wheel_stiffness_N_per_m, 100e3, 0.75},
                                                {loco::Branch::kStiffest, true}));
}

TEST(StepLimitTest, AnUndampedMassBears2OverOmega) {
  const loco::StepLimit limit = loco::computeStepLimit(oneMass(4e6, 0.0, 100.0));  // 200 rad/s
  EXPECT_NEAR(limit.stable_s, 2.0 / 200.0, 2e-6);
  EXPECT_NEAR(limit.frequency_Hz, 200.0 / (2.0 * M_PI), 1e-9);
  EXPECT_EQ(limit.mode, "bogie frame 1, vertical");
}

TEST(StepLimitTest, ADampedMassBearsTheRootOfTheStepsPolynomial) {
  // lambda^2 - (2 - h c/m - h^2 k/m) lambda + (1 - h c/m) leaves the unit circle at -1: h^2 k/m + 2 h c/m = 4
  const double k = 4e6, c = 3000.0, m = 100.0, b = c / m, a = k / m;
  const loco::StepLimit limit = loco::computeStepLimit(oneMass(k, c, m));
  EXPECT_NEAR(limit.stable_s, (-b + std::sqrt(b * b + 4.0 * a)) / a, 2e-6);
  EXPECT_NEAR(limit.damping, c / (2.0 * std::sqrt(k * m)), 1e-9);
}

TEST(StepLimitTest, AMaxwellDamperIsASpringIfStiffAndAnExplicitDamperIfSoft) {
  loco::LinearModel model = oneMass(0.0, 0.0, 1e4);
  model.damper_stretch = Eigen::MatrixXd::Constant(1, 1, 1.0);
  model.damper_spring_N_per_m = Eigen::VectorXd::Constant(1, 1e9);
  model.damper_slope_N_s_per_m = Eigen::VectorXd::Constant(1, 1e12);
  EXPECT_NEAR(loco::computeStepLimit(model).stable_s, 2.0 * std::sqrt(1e4 / 1e9), 2e-5);
  model.damper_slope_N_s_per_m[0] = 1e3;  // x follows within a step: v (1 - h c/m)
  EXPECT_NEAR(loco::computeStepLimit(model).stable_s, 2.0 * 1e4 / 1e3, 0.05);
}

TEST(StepLimitTest, LateralRollAndYawMotionsBearTheStepThatThePlanarOnesBear) {
  const loco::StepLimit planar = paperLimit({}, 1.82e9);
  const loco::StepLimit spatial = loco::computeStepLimit(
      loco::linearise(fixtures::paperStructure(),
                      loco::allCoordinates({loco::kX, loco::kY, loco::kZ, loco::kRoll, loco::kPitch, loco::kYaw}),
                      {1.82e9, 100e3, 0.75}, {loco::Branch::kStiffest, true}));
  EXPECT_NEAR(spatial.stable_s, planar.stable_s, 1e-3 * planar.stable_s);
  EXPECT_EQ(spatial.mode, planar.mode);  // wheels on rails
}

TEST(StepLimitTest, BelowTheLimitNothingGrowsAndBeyondItDoes) {
  const loco::LinearModel model = oneMass(4e6, 3000.0, 100.0);
  const double stable_s = loco::computeStepLimit(model).stable_s;
  EXPECT_LT(loco::computeSpectralRadius(model, 0.99 * stable_s), 1.0);
  EXPECT_GT(loco::computeSpectralRadius(model, 1.01 * stable_s), 1.001);
}

TEST(StepLimitTest, ThePapersLocomotiveIsBoundByItsWheelsOnTheRail) {
  const loco::StepLimit limit = paperLimit({}, 1.8229e9);  // Hertz's tangent at 109.5 kN
  EXPECT_EQ(limit.mode.substr(0, 8), "wheelset");
  EXPECT_NE(limit.mode.find(", vertical"), std::string::npos);
  EXPECT_NEAR(limit.frequency_Hz, 165.0, 1.0);
  EXPECT_NEAR(limit.stable_s, 1.84e-3, 0.02e-3);  // an independent prototype is sound to 1.8 ms and wrong at 1.85
  EXPECT_GE(limit.largest_s(), 1.5e-3);
  EXPECT_LT(limit.largest_s(), 1.55e-3);
}

TEST(StepLimitTest, AStifferPinOrDamperTakesOverAndIsNamed) {
  const loco::StepLimit pin = paperLimit({{"secondary.centre_pin.longitudinal.1.slope_N_per_m", "1e11"}}, 1.8229e9);
  EXPECT_LT(pin.stable_s, 0.8e-3);
  EXPECT_NE(pin.mode.find("bogie frame"), std::string::npos) << pin.mode;
  EXPECT_NE(pin.mode.find(", longitudinal"), std::string::npos) << pin.mode;
  const loco::StepLimit damper = paperLimit({{"primary.outer_axle_vertical_damping_N_s_per_m", "3e7"}}, 1.8229e9);
  EXPECT_LT(damper.stable_s, 0.2e-3);
  EXPECT_GT(damper.damping, 1.0);
}

}  // namespace
