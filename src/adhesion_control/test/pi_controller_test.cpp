#include "adhesion_control/pi_controller.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using adhesion::PiController;

constexpr double kReference_N_m = 40e3;
constexpr double kPeriod_s = 1e-3;

PiController makeController() { return PiController({0.07, 150e3, 1000e3}); }

TEST(PiControllerTest, BelowTheLimitWithoutIntegralItDoesNotAct) {
  const PiController controller = makeController();
  for (const double slip : {-1.0, 0.0, 0.03, 0.07}) {
    double integral = 0.0;
    EXPECT_EQ(controller.step(slip, kReference_N_m, kPeriod_s, integral), 0.0) << slip;
    EXPECT_EQ(integral, 0.0) << slip;
  }
}

TEST(PiControllerTest, WithoutReferenceItHasNothingToTakeAway) {
  const PiController controller = makeController();
  double integral = 5e3;
  EXPECT_EQ(controller.step(0.5, 0.0, kPeriod_s, integral), 0.0);
  EXPECT_EQ(integral, 0.0);
}

TEST(PiControllerTest, ReductionIsProportionalPartPlusIntegralAtTheSample) {
  const PiController controller = makeController();
  double integral = 2000.0;
  // e = 0.03: K_p e = 4500; K_i e T_s = 30. Tolerance: rounding of 0.1 - 0.07.
  EXPECT_NEAR(controller.step(0.10, kReference_N_m, kPeriod_s, integral), 6500.0, 1e-8);
  EXPECT_NEAR(integral, 2030.0, 1e-8);
  // e = -0.01: K_p e = -1500; K_i e T_s = -10
  EXPECT_NEAR(controller.step(0.06, kReference_N_m, kPeriod_s, integral), 530.0, 1e-8);
  EXPECT_NEAR(integral, 2020.0, 1e-8);
}

TEST(PiControllerTest, IntegralGrowsWithThePeriod) {
  const PiController controller = makeController();
  double integral = 0.0;
  controller.step(0.08, kReference_N_m, 5e-3, integral);
  EXPECT_NEAR(integral, 1000e3 * 0.01 * 5e-3, 1e-9);
}

TEST(PiControllerTest, BrakingIsTheMirrorImageBitForBit) {
  const PiController controller = makeController();
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> slip(-0.3, 0.3), reference(0.0, 45e3);
  double integral = 0.0, mirrored_integral = 0.0;
  int acted = 0;
  for (int i = 0; i < 10000; ++i) {
    const double s = slip(random), T_ref = reference(random);
    const double R = controller.step(s, T_ref, kPeriod_s, integral);
    EXPECT_EQ(controller.step(-s, -T_ref, kPeriod_s, mirrored_integral), -R);
    EXPECT_EQ(mirrored_integral, -integral);
    if (R > 0.0 && R < T_ref) ++acted;
  }
  EXPECT_GT(acted, 1000);  // not only the clamps were compared
}

TEST(PiControllerTest, LockedWheelInBrakingReleasesTheTorque) {
  const PiController controller = makeController();
  double integral = 0.0;
  EXPECT_EQ(controller.step(-1.0, -kReference_N_m, kPeriod_s, integral), -kReference_N_m);
  EXPECT_NEAR(integral, -1000e3 * 0.93 * kPeriod_s, 1e-9);
}

TEST(PiControllerTest, TorqueAndIntegralStayBetweenZeroAndReference) {
  const PiController controller = makeController();
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> slip(-2.0, 2.0), reference(-45e3, 45e3);
  double integral = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const double T_ref = reference(random);
    const double T = T_ref - controller.step(slip(random), T_ref, kPeriod_s, integral);
    EXPECT_GE(T / T_ref, 0.0);
    EXPECT_LE(T / T_ref, 1.0);
    EXPECT_GE(integral / T_ref, 0.0);
    EXPECT_LE(integral / T_ref, 1.0);
  }
}

TEST(PiControllerTest, RecoversAtOnceFromALongSlip) {
  const PiController controller = makeController();
  double integral = 0.0;
  for (int i = 0; i < 60000; ++i) controller.step(0.9, kReference_N_m, kPeriod_s, integral);  // one minute
  EXPECT_EQ(integral, kReference_N_m);
  // The first sample with grip, at s = 0.05: T = K_p 0.02 = 3 kN m at once, then 20 N m more with each sample.
  EXPECT_NEAR(kReference_N_m - controller.step(0.05, kReference_N_m, kPeriod_s, integral), 3000.0, 1e-8);
  EXPECT_NEAR(kReference_N_m - controller.step(0.05, kReference_N_m, kPeriod_s, integral), 3020.0, 1e-8);
}

TEST(PiControllerTest, ActsAtOnceAfterALongTimeBelowTheLimit) {
  const PiController controller = makeController();
  double integral = 0.0;
  for (int i = 0; i < 60000; ++i) controller.step(0.01, kReference_N_m, kPeriod_s, integral);
  EXPECT_NEAR(controller.step(0.09, kReference_N_m, kPeriod_s, integral), 3000.0, 1e-8);
}

TEST(PiControllerTest, AReferenceThatFallsTakesTheIntegralDown) {
  const PiController controller = makeController();
  double integral = 30e3;
  // I is cut to 10 kN m before it is used: R = 10e3 - 150e3 * 0.02, not 30e3 - 3e3 clamped to 10e3.
  EXPECT_NEAR(controller.step(0.05, 10e3, kPeriod_s, integral), 7000.0, 1e-8);
  EXPECT_NEAR(integral, 10e3 - 20.0, 1e-8);
}

TEST(PiControllerTest, ChangeOfSignPassesThroughZeroWithoutJump) {
  const PiController controller = makeController();
  const double slip = 0.075, step = 10.0;
  double integral = 20e3;
  double T_last = 40e3 - controller.step(slip, 40e3, kPeriod_s, integral);
  for (double T_ref = 40e3 - step; T_ref >= -40e3; T_ref -= step) {
    const double T = T_ref - controller.step(slip, T_ref, kPeriod_s, integral);
    // no more than the reference moves, plus K_i e T_s
    EXPECT_LE(std::abs(T - T_last), step + 1000e3 * 0.005 * kPeriod_s + 1e-8) << T_ref;
    T_last = T;
  }
  EXPECT_EQ(T_last, -40e3);  // a slipping wheel may be braked in full
  EXPECT_EQ(integral, 0.0);
}

TEST(PiControllerTest, ChangeOfSignInOneStepForgetsTheIntegral) {
  const PiController controller = makeController();
  double integral = 20e3;
  EXPECT_EQ(controller.step(0.0, -kReference_N_m, kPeriod_s, integral), 0.0);
  EXPECT_EQ(integral, 0.0);
}

TEST(PiControllerTest, ANumberThatIsNoneIsPassedOn) {
  const PiController controller = makeController();
  double integral = 0.0;
  EXPECT_TRUE(std::isnan(controller.step(std::nan(""), kReference_N_m, kPeriod_s, integral)));
}

}  // namespace
