#include "ltd_sim/train_ability.hpp"

#include <gtest/gtest.h>

#include "brake_fixtures.hpp"
#include "ltd_sim/driver_controls.hpp"
#include "point_train.hpp"

namespace {

using fixtures::BrakeText;

BrakeText fullServiceAt(const std::string& bar) {
  BrakeText text;
  text.pipe.replace(text.pipe.find("3.5"), 3, bar);
  return text;
}

TEST(TrainAbilityTest, FullServiceIsTheBrakesOwnNotUic540s) {
  const ltd::TrainModel train = fixtures::brakedTrain();
  const double shoes_N = 0.36 * 0.1 * 108 * 120e3 * rail::kGravity_mps2;
  for (const auto& [bar, reduction_Pa] : {std::pair("3.0", 2.0e5), {"3.5", 1.5e5}, {"4.5", 0.5e5}}) {
    const ltd::TrainAbility can = ltd::computeAbility(train, fixtures::makeAirBrake(fullServiceAt(bar), train));
    EXPECT_DOUBLE_EQ(can.full_service_reduction_Pa, reduction_Pa);
    EXPECT_DOUBLE_EQ(can.first_reduction_Pa, 0.4e5);
    EXPECT_NEAR(can.full_service_N(10.0), shoes_N, 1e-9 * shoes_N) << bar;
  }
}

TEST(TrainAbilityTest, CountsMassAndLengthFromTheLeadingLocomotive) {
  const ltd::TrainModel train = fixtures::brakedTrain();
  const ltd::TrainAbility can = ltd::computeAbility(train, ltd::AirBrake());
  EXPECT_DOUBLE_EQ(can.mass_kg, 108 * 120e3);
  EXPECT_DOUBLE_EQ(can.weight_N, 108 * 120e3 * rail::kGravity_mps2);
  EXPECT_NEAR(can.ahead_m, 0.5 * 1641.0 / 107.0, 1e-9);
  EXPECT_NEAR(can.behind_m, 107.5 * 1641.0 / 107.0, 1e-9);
  EXPECT_FALSE(can.air_brake);
  EXPECT_FALSE(can.full_service_N);
}

/// What the driver's hand makes of a wish for this share of full service.
double pipeFor(double share, double reduction_Pa) {
  ltd::TrainAbility can = drivers::ability();
  can.full_service_reduction_Pa = reduction_Pa;
  return ltd::kChargedPipe_Pa - ltd::DriverControls::reductionFor(share, can);
}

TEST(DriverControlsTest, AskedForAllThatTheAirBrakeHasSetThePipeToItsFullService) {
  EXPECT_DOUBLE_EQ(pipeFor(1.0, 1.5e5), 3.5e5);
  EXPECT_DOUBLE_EQ(pipeFor(1.0, 2.0e5), 3.0e5);
  EXPECT_DOUBLE_EQ(pipeFor(1.2, 1.0e5), 4.0e5);  // and never beyond
  EXPECT_DOUBLE_EQ(pipeFor(1.0, 0.5e5), 4.5e5);
}

TEST(DriverControlsTest, TheFirstReductionIsHalfABarAndEveryStepGivesAtLeastTheShare) {
  EXPECT_DOUBLE_EQ(pipeFor(0.01, 1.5e5), 4.5e5);
  EXPECT_DOUBLE_EQ(pipeFor(0.5 / 1.5, 1.5e5), 4.5e5);
  EXPECT_DOUBLE_EQ(pipeFor(0.51 / 1.5, 1.5e5), 4.4e5);
  EXPECT_DOUBLE_EQ(pipeFor(0.79 / 1.5, 1.5e5), 4.2e5);
}

}  // namespace
