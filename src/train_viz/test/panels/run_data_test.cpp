#include "plots/run_data.hpp"

#include <gtest/gtest.h>

namespace viz {
namespace {

TrainSample trainAt(double time_s, double place_m) {
  TrainSample sample;
  sample.time_s = time_s;
  sample.place_m = place_m;
  sample.speed_mps = 5.0;
  sample.notch = {1.0, 2.0};
  sample.brake_notch = {0.0, 0.0};
  sample.traction_N = {100e3, 200e3};
  sample.coupler_N = {10e3 * time_s, -5e3 * time_s};
  return sample;
}

EnergySample energyAt(double time_s, double rail_J) {
  return {time_s, {rail_J, 2.0 * rail_J}, {1.1 * rail_J, 2.2 * rail_J}, {0.0, 3.0}};
}

AdhesionSample adhesionAt(double time_s, double creep) { return {time_s, 100.0, 5.0, {{creep, 0.2, 200e3}}}; }

TEST(RunDataTest, SeriesAreByPlaceAndLocomotive) {
  RunData run;
  run.add(trainAt(1.0, 3000.0));
  run.add(trainAt(2.0, 3005.0));
  ASSERT_EQ(run.locomotives().size(), 2u);
  const auto points = run.locomotives()[1].traction_N.points();
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[1].x, 3005.0);
  EXPECT_EQ(points[1].y, 200e3);
  EXPECT_EQ(run.locomotives()[1].notch.newest().y, 2.0);
  EXPECT_EQ(run.speed().newest().y, 5.0);
}

TEST(RunDataTest, CouplersKeepTheirLargestDraftAndBuff) {
  RunData run;
  run.add(trainAt(3.0, 3000.0));
  run.add(trainAt(4.0, 3005.0));
  TrainSample later = trainAt(5.0, 3010.0);
  later.coupler_N = {1e3, 1e3};
  run.add(later);
  ASSERT_EQ(run.couplers().size(), 2u);
  EXPECT_EQ(run.couplers()[0].largest_N, 40e3);
  EXPECT_EQ(run.couplers()[0].least_N, 0.0);
  EXPECT_EQ(run.couplers()[1].least_N, -20e3);
}

TEST(RunDataTest, EnergyStandsAtThePlaceOfItsTime) {
  RunData run;
  run.add(trainAt(1.0, 3000.0));
  run.add(energyAt(1.0, 1e6));
  run.add(energyAt(2.0, 2e6));  // before its state
  EXPECT_EQ(run.locomotives()[0].rail_J.points().size(), 1u);
  run.add(trainAt(2.0, 3010.0));
  run.add(trainAt(4.0, 3030.0));
  run.add(energyAt(3.0, 3e6));  // the state of its time was lost: between those around it
  const auto points = run.locomotives()[0].rail_J.points();
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[1].x, 3010.0);
  EXPECT_EQ(points[1].y, 2e6);
  EXPECT_EQ(points[2].x, 3020.0);
  EXPECT_EQ(run.locomotives()[1].recovered_J.newest().y, 3.0);
}

TEST(RunDataTest, EnergiesThatNoStateFollowsAreForgottenInTheEnd) {
  RunData run;
  for (int i = 0; i < 10000; ++i) run.add(energyAt(i, 1.0));
  run.add(trainAt(5000.0, 0.0));
  run.add(trainAt(20000.0, 1.0));
  ASSERT_EQ(run.locomotives().size(), 2u);
  // the last 2048, and places between those two
  EXPECT_DOUBLE_EQ(run.locomotives()[0].rail_J.points().front().x, (10000.0 - 2048.0 - 5000.0) / 15000.0);
}

TEST(RunDataTest, TimeThatGoesBackIsANewRun) {
  RunData run;
  run.setRun(7, "");
  run.add(trainAt(5.0, 3050.0));
  run.add(energyAt(5.0, 1e6));
  run.add(adhesionAt(5.0, 0.01));
  run.add(energyAt(6.0, 1e6));  // waits; must not come into the new run
  run.add(trainAt(1.0, 3000.0));
  EXPECT_EQ(run.speed().points().size(), 1u);
  EXPECT_TRUE(run.axles().empty());
  EXPECT_EQ(run.couplers()[0].largest_N, 10e3);
  run.add(trainAt(7.0, 3000.0));
  EXPECT_TRUE(run.locomotives()[0].rail_J.empty());
}

TEST(RunDataTest, AnotherRunIdIsANewRun) {
  RunData run;
  run.setRun(7, "");
  run.add(trainAt(1.0, 3000.0));
  run.setRun(7, "");  // latched, comes again
  EXPECT_EQ(run.speed().points().size(), 1u);
  run.setRun(8, "");
  EXPECT_TRUE(run.speed().empty());
}

TEST(RunDataTest, AConfigurationThatComesLateTakesNothingAway) {
  RunData run;
  run.add(trainAt(1.0, 3000.0));
  run.setRun(7, "");
  EXPECT_EQ(run.speed().points().size(), 1u);
  run.add(trainAt(0.5, 2000.0));  // the next run's first state comes before its configuration
  run.setRun(8, "");
  EXPECT_EQ(run.speed().points().size(), 1u);
  EXPECT_EQ(run.speed().newest().x, 2000.0);
}

TEST(RunDataTest, AnotherLocomotiveForgetsAdhesionOnly) {
  RunData run;
  run.add(trainAt(1.0, 3000.0));
  run.add(adhesionAt(1.0, 0.01));
  run.setLocomotive(1);
  EXPECT_EQ(run.axles().size(), 1u);
  run.setLocomotive(2);
  EXPECT_TRUE(run.axles().empty());
  EXPECT_FALSE(run.adhesion());
  EXPECT_EQ(run.speed().points().size(), 1u);
}

TEST(RunDataTest, RevisionTellsOfEveryChange) {
  RunData run;
  std::uint64_t before = run.revision();
  const auto changed = [&] {
    const bool is = run.revision() != before;
    before = run.revision();
    return is;
  };
  EXPECT_FALSE(changed());
  run.add(trainAt(1.0, 0.0));
  EXPECT_TRUE(changed());
  run.add(energyAt(1.0, 1.0));
  EXPECT_TRUE(changed());
  run.add(adhesionAt(1.0, 0.0));
  EXPECT_TRUE(changed());
  run.setRun(1, "text");
  EXPECT_TRUE(changed());
  run.clear();
  EXPECT_TRUE(changed());
}

}  // namespace
}  // namespace viz
