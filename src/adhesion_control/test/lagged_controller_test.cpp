#include "adhesion_control/lagged_controller.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "adhesion_control/pass_through_controller.hpp"
#include "adhesion_control/pi_adhesion_controller.hpp"
#include "controller_fixtures.hpp"

namespace {

constexpr double kLag_s = 0.02;
constexpr double kReference_N_m = 40e3;

adhesion::LaggedController makeLagged(const adhesion::Setup& setup, double lag_s = kLag_s) {
  return adhesion::LaggedController(std::make_unique<adhesion::PassThroughController>(), lag_s, setup);
}

TEST(LaggedControllerTest, MotorTorqueFollowsTheExponentialExactly) {
  const adhesion::LaggedController controller = makeLagged(coCo());
  Driven driven(controller, coCo());
  driven.setReference(kReference_N_m);
  for (int k = 1; k <= 100; ++k) {
    driven.step();
    const double expected = kReference_N_m * (1.0 - std::exp(-k * 1e-3 / kLag_s));
    EXPECT_NEAR(driven.state[5], expected, 1e-12 * kReference_N_m * k) << k;  // an error of rounding per step
  }
}

TEST(LaggedControllerTest, WheelsetsGetTheMeanOverTheStep) {
  const adhesion::LaggedController controller = makeLagged(coCo());
  Driven driven(controller, coCo());
  driven.setReference(kReference_N_m);
  driven.step();
  const double x = 1e-3 / kLag_s;
  EXPECT_NEAR(driven.commands[0].torque_N_m, kReference_N_m * (1.0 - (1.0 - std::exp(-x)) / x), 1e-8);
}

TEST(LaggedControllerTest, ImpulseDoesNotDependOnTheMicroStep) {
  const auto impulse = [](rail::Nanoseconds h, int steps) {
    adhesion::Setup setup = coCo();
    setup.micro_step = h;
    const adhesion::LaggedController controller = makeLagged(setup);
    Driven driven(controller, setup);
    driven.setReference(kReference_N_m);
    double sum = 0.0;
    for (int k = 0; k < steps; ++k) {
      driven.step();
      sum += driven.commands[2].torque_N_m * rail::toSeconds(h);
    }
    return sum;
  };
  EXPECT_NEAR(impulse(100000, 500), impulse(5000000, 10), 1e-8);  // 50 ms; rounding of 500 sums of about 1 kN m s
  const double exact = kReference_N_m * (0.05 - kLag_s * (1.0 - std::exp(-0.05 / kLag_s)));
  EXPECT_NEAR(impulse(1000000, 50), exact, 1e-8);
}

TEST(LaggedControllerTest, AVeryShortLagIsNone) {
  for (const double lag_s : {1e-9, 1e-300}) {
    const adhesion::LaggedController controller = makeLagged(coCo(), lag_s);
    Driven driven(controller, coCo());
    driven.setReference(kReference_N_m);
    driven.step();
    EXPECT_NEAR(driven.commands[0].torque_N_m, kReference_N_m, 2e-6 * kReference_N_m);  // tau/h = 1e-6
    EXPECT_EQ(driven.state[0], kReference_N_m);
  }
}

TEST(LaggedControllerTest, LagsBehindAnyControllerAndKeepsItsFlags) {
  const adhesion::PiAdhesionController pi({}, coCo());
  const adhesion::LaggedController lagged(std::make_unique<adhesion::PiAdhesionController>(pi), kLag_s, coCo());
  EXPECT_EQ(lagged.stateSize(), pi.stateSize() + 6);
  EXPECT_EQ(lagged.initialState().size(), lagged.stateSize());
  Driven with(lagged, coCo()), without(pi, coCo());
  for (Driven* driven : {&with, &without}) {
    driven->setReference(kReference_N_m);
    driven->setSlip(0.02);
    driven->setSlip(1, 0.12);
    driven->step();
  }
  const double share = 1.0 - (1.0 - std::exp(-0.05)) / 0.05;  // h/tau = 0.05
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(with.commands[i].torque_N_m, without.commands[i].torque_N_m * share, 1e-8) << i;
    EXPECT_EQ(with.commands[i].active, i == 1) << i;
  }
}

}  // namespace
