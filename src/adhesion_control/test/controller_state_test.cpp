// What the lock asks of every controller: a state that travels, and an inner loop that does not allocate.

#include <gtest/gtest.h>

#include <cstring>

#include "adhesion_control/controller_factory.hpp"
#include "controller_fixtures.hpp"
#include "counted_allocations.hpp"

namespace {

using Grouping = adhesion::PiAdhesionController::Grouping;

/// Everything on: states of every kind, a sample phase that a restart must not lose.
adhesion::ControlParameters makeParameters(const std::string& law, Grouping grouping) {
  adhesion::ControlParameters parameters;
  parameters.law = law;
  parameters.torque_lag_s = 0.01;
  parameters.pi.grouping = grouping;
  parameters.pi.sampling_period = 7000000;
  return parameters;
}

class ControllerStateTest : public ::testing::TestWithParam<adhesion::ControlParameters> {};

TEST_P(ControllerStateTest, AnotherObjectGoesOnWithTheSameBits) {
  const auto continuous = adhesion::makeController(GetParam(), coCo());
  Driven whole(*continuous, coCo());
  std::vector<double> message = whole.state;
  RandomMeasurements measurements;
  for (int k = 0; k < 1000; ++k) {
    measurements.next(whole);
    const auto fresh = adhesion::makeController(GetParam(), coCo());
    Driven part(*fresh, coCo());
    part.state = message;
    part.axles = whole.axles;
    whole.step();
    part.step();
    message = part.state;
    ASSERT_EQ(message.size(), whole.state.size());
    ASSERT_EQ(std::memcmp(message.data(), whole.state.data(), message.size() * sizeof(double)), 0) << k;
    for (std::size_t i = 0; i < 6; ++i) {
      ASSERT_EQ(part.commands[i].torque_N_m, whole.commands[i].torque_N_m) << k;
      ASSERT_EQ(part.commands[i].active, whole.commands[i].active) << k;
    }
  }
}

TEST_P(ControllerStateTest, NothingElseIsRemembered) {
  const auto controller = adhesion::makeController(GetParam(), coCo());
  Driven first(*controller, coCo()), second(*controller, coCo());
  RandomMeasurements measurements;
  measurements.next(first);
  second.axles = first.axles;
  first.step();
  for (int k = 0; k < 10; ++k) {
    Driven other(*controller, coCo());
    measurements.next(other);
    other.step();
  }
  second.step();
  EXPECT_EQ(first.state, second.state);
}

TEST_P(ControllerStateTest, StepDoesNotAllocate) {
  const auto controller = adhesion::makeController(GetParam(), coCo());
  Driven driven(*controller, coCo());
  RandomMeasurements measurements;
  const long before = countedAllocations();
  for (int k = 0; k < 100; ++k) {
    measurements.next(driven);
    driven.step();
  }
  EXPECT_EQ(countedAllocations(), before);
  EXPECT_GT(before, 0);  // the counter counts
}

INSTANTIATE_TEST_SUITE_P(AllLaws, ControllerStateTest,
                         ::testing::Values(makeParameters("pi", Grouping::kAxle),
                                           makeParameters("pi", Grouping::kBogie),
                                           makeParameters("none", Grouping::kAxle)));

}  // namespace
