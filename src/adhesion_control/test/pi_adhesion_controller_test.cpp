#include "adhesion_control/pi_adhesion_controller.hpp"

#include <gtest/gtest.h>

#include "adhesion_control/pass_through_controller.hpp"
#include "controller_fixtures.hpp"

namespace {

using adhesion::PiAdhesionController;
using Grouping = PiAdhesionController::Grouping;

constexpr double kReference_N_m = 40e3;
constexpr double kTolerance_N_m = 1e-6;  // slip goes through omega and back: 150e3 N m times a few 1e-16 over 0.5335

PiAdhesionController makeController(Grouping grouping, rail::Nanoseconds sampling_period = 0) {
  return PiAdhesionController({{0.07, 150e3, 1000e3}, grouping, sampling_period}, coCo());
}

TEST(PiAdhesionControllerTest, AllReferencesPassWhenAllWheelsRoll) {
  for (const Grouping grouping : {Grouping::kAxle, Grouping::kBogie}) {
    const PiAdhesionController controller = makeController(grouping);
    Driven driven(controller, coCo());
    driven.setSlip(0.02);
    driven.setReference(kReference_N_m);
    driven.step();
    for (const auto& command : driven.commands) {
      EXPECT_EQ(command.torque_N_m, kReference_N_m);
      EXPECT_FALSE(command.active);
    }
  }
}

TEST(PiAdhesionControllerTest, PerAxleOnlyTheSlippingAxleLosesTorque) {
  const PiAdhesionController controller = makeController(Grouping::kAxle);
  Driven driven(controller, coCo());
  driven.setSlip(0.02);
  driven.setSlip(4, 0.09);
  driven.setReference(kReference_N_m);
  driven.step();
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(driven.commands[i].torque_N_m, i == 4 ? 37e3 : 40e3, kTolerance_N_m) << i;
    EXPECT_EQ(driven.commands[i].active, i == 4) << i;
  }
}

TEST(PiAdhesionControllerTest, PerBogieTheLargestSlipCountsForAllItsAxles) {
  const PiAdhesionController controller = makeController(Grouping::kBogie);
  for (std::size_t worst = 3; worst < 6; ++worst) {
    Driven driven(controller, coCo());
    driven.setSlip(0.075);
    driven.setSlip(worst, 0.09);
    driven.setSlip(1, -0.5);  // sliding while the others pull: not the largest
    driven.setReference(kReference_N_m);
    driven.step();
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_NEAR(driven.commands[i].torque_N_m, i < 3 ? 40e3 - 750.0 : 37e3, kTolerance_N_m) << i;
      EXPECT_TRUE(driven.commands[i].active) << i;
    }
  }
}

TEST(PiAdhesionControllerTest, PerBogieInBrakingTheLargestSlideCounts) {
  const PiAdhesionController controller = makeController(Grouping::kBogie);
  Driven driven(controller, coCo());
  driven.setSlip(-0.02);
  driven.setSlip(2, -0.09);
  driven.setSlip(0, 0.5);
  driven.setReference(-kReference_N_m);
  driven.step();
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(driven.commands[i].torque_N_m, i < 3 ? -37e3 : -40e3, kTolerance_N_m) << i;
  }
}

TEST(PiAdhesionControllerTest, PerBogieAnAxleLosesNoMoreThanItsOwnReference) {
  const PiAdhesionController controller = makeController(Grouping::kBogie);
  Driven driven(controller, coCo());
  driven.setSlip(0.02);
  driven.setSlip(0, 0.11);  // R = 6 kN m
  driven.setReference(kReference_N_m);
  driven.axles[1].torque_reference_N_m = 4e3;
  driven.step();
  EXPECT_NEAR(driven.commands[0].torque_N_m, 34e3, kTolerance_N_m);
  EXPECT_EQ(driven.commands[1].torque_N_m, 0.0);
  EXPECT_NEAR(driven.commands[2].torque_N_m, 34e3, kTolerance_N_m);
}

TEST(PiAdhesionControllerTest, HoldsTheReductionBetweenSamples) {
  const PiAdhesionController controller = makeController(Grouping::kAxle, 4000000);  // every 4th micro step
  Driven driven(controller, coCo());
  driven.setReference(kReference_N_m);
  std::vector<double> torque;
  for (int k = 0; k < 9; ++k) {
    driven.setSlip(0.08 + 0.01 * k);
    driven.step();
    torque.push_back(driven.commands[3].torque_N_m);
  }
  const double T_0 = 40e3 - 150e3 * 0.01;
  const double T_4 = 40e3 - 150e3 * 0.05 - 1000e3 * 0.01 * 4e-3;  // I has grown over 4 ms with the e of sample 0
  const double T_8 = 40e3 - 150e3 * 0.09 - 1000e3 * (0.01 + 0.05) * 4e-3;
  const std::vector<double> expected = {T_0, T_0, T_0, T_0, T_4, T_4, T_4, T_4, T_8};
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(torque[k], expected[k], kTolerance_N_m) << k;
}

TEST(PiAdhesionControllerTest, BetweenSamplesAFallingReferenceIsObeyedAtOnce) {
  const PiAdhesionController controller = makeController(Grouping::kAxle, 4000000);
  Driven driven(controller, coCo());
  driven.setSlip(0.09);  // R = 3 kN m
  driven.setReference(kReference_N_m);
  driven.step();
  for (const auto& [reference, torque] : {std::pair{10e3, 7e3}, {1e3, 0.0}, {-5e3, -5e3}}) {
    driven.setReference(reference);
    driven.step();
    EXPECT_NEAR(driven.commands[0].torque_N_m, torque, kTolerance_N_m);
  }
}

TEST(PiAdhesionControllerTest, TorqueStaysBetweenZeroAndReference) {
  for (const Grouping grouping : {Grouping::kAxle, Grouping::kBogie}) {
    const PiAdhesionController controller = makeController(grouping, 3000000);
    Driven driven(controller, coCo());
    RandomMeasurements measurements;
    for (int k = 0; k < 5000; ++k) {
      measurements.next(driven);
      driven.step();
      for (std::size_t i = 0; i < 6; ++i) {
        const double share = driven.commands[i].torque_N_m / driven.axles[i].torque_reference_N_m;
        EXPECT_GE(share, 0.0);
        EXPECT_LE(share, 1.0);
        EXPECT_EQ(driven.commands[i].active, share != 1.0);
      }
    }
  }
}

TEST(PassThroughControllerTest, GivesTheReferenceWhateverTheWheelsDo) {
  const adhesion::PassThroughController controller;
  Driven driven(controller, coCo());
  EXPECT_TRUE(driven.state.empty());
  for (const double slip : {-1.0, 0.0, 5.0}) {
    for (const double reference : {kReference_N_m, -kReference_N_m}) {
      driven.setSlip(slip);
      driven.setReference(reference);
      driven.step();
      for (const auto& command : driven.commands) {
        EXPECT_EQ(command.torque_N_m, reference);
        EXPECT_FALSE(command.active);
      }
    }
  }
}

}  // namespace
