#include "point_train.hpp"

namespace {

using drivers::PointTrain;
using drivers::timetable;

const std::string kLevel = "{from_km: 0, grade_permille: 0}";
constexpr double kKmph = 1.0 / rail::kKmphPerMps;

bool stands(const PointTrain& train) { return train.state.timetable.waiting; }

/// From 3 to 23 km down this grade, limit 60 km/h.
rail::Track descent(double permille) {
  return drivers::line(
      kLevel + ", {from_km: 3, grade_permille: " + std::to_string(permille) + "}, {from_km: 23, grade_permille: 0}",
      "{from_km: 0, limit_kmph: 60}");
}

TEST(TimetableDriverTest, KeepsLimitsUntilTheTailHasLeftAndStopsAtTheStop) {
  const rail::Track track = drivers::line(
      kLevel + ", {from_km: 4, grade_permille: 5}, {from_km: 7, grade_permille: -6}, {from_km: 12, grade_permille: 0}",
      "{from_km: 0, limit_kmph: 80}, {from_km: 5, limit_kmph: 40}, {from_km: 5.5, limit_kmph: 80}, "
      "{from_km: 10, limit_kmph: 60}, {from_km: 11, limit_kmph: 80}");
  const ltd::Driver driver = timetable("{location_km: 15, stop: true}", track, drivers::ability());
  PointTrain train(driver, track, 1000.0, 0.0);
  train.run(3600.0, stands);
  EXPECT_LT(train.seen.largest_excess_mps, 1.0 * kKmph);
  EXPECT_GT(train.seen.largest_excess_mps, -3.0 * kKmph);  // and does not dawdle
  EXPECT_GT(train.seen.largest_mps, 76.0 * kKmph);
  EXPECT_NEAR(train.s, 15000.0, 20.0);
  train.run(train.seconds() + 60.0);
  EXPECT_EQ(train.v, 0.0);
  EXPECT_EQ(driver.lead(train.state).independent_brake, 1.0);
  EXPECT_LE(driver.lead(train.state).pipe_pressure_Pa, 4.5e5);
}

TEST(TimetableDriverTest, TrainsOfDifferentStrengthReachThePointsAtTheSameTimes) {
  const rail::Track track =
      drivers::line(kLevel + ", {from_km: 8, grade_permille: 4}, {from_km: 11, grade_permille: -4}",
                    "{from_km: 0, limit_kmph: 80}, {from_km: 5, limit_kmph: 50}, {from_km: 6, limit_kmph: 80}");
  for (const double strength : {1.0, 0.8}) {
    const ltd::Driver driver = timetable(
        "{location_km: 10, time_s: 700}, {location_km: 20, time_s: 1350}, {location_km: 25, time_s: 1800, stop: true}",
        track, drivers::ability(strength));
    PointTrain train(driver, track, 1000.0, 0.0, strength);
    train.run(3600.0, stands);
    EXPECT_NEAR(train.seen.time_at_km10[100], 700.0, 5.0);
    EXPECT_NEAR(train.seen.time_at_km10[200], 1350.0, 5.0);
    EXPECT_NEAR(train.seconds(), 1800.0, 5.0);
    EXPECT_NEAR(train.s, 25000.0, 20.0);
    EXPECT_TRUE(driver.notes(train.state).empty());
  }
}

TEST(TimetableDriverTest, OnASteepGradeHeHoldsWithMoreThanTheFirstReduction) {
  for (const auto& [permille, bar] : {std::pair(0.0, 4.5), {30.0, 3.8}}) {
    const rail::Track track =
        drivers::line("{from_km: 0, grade_permille: " + std::to_string(permille) + "}", "{from_km: 0, limit_kmph: 50}");
    const ltd::Driver driver = timetable("{location_km: 2, stop: true}", track, drivers::ability());
    PointTrain train(driver, track, 1000.0, 40.0 * kKmph);
    train.run(900.0, stands);
    train.run(train.seconds() + 30.0);
    // 30 permille pull with 0.294 m/s2: 1.5 times that of 0.6 m/s2 are 0.735 of 1.5 bar, in steps of 0.1
    EXPECT_NEAR(driver.lead(train.state).pipe_pressure_Pa, bar * 1e5, 1.0) << permille;
    EXPECT_EQ(train.v, 0.0);
  }
}

TEST(TimetableDriverTest, StopsOnTheWayWaitsAndGoesOn) {
  const rail::Track track = drivers::line(kLevel, "{from_km: 0, limit_kmph: 80}");
  const ltd::Driver driver =
      timetable("{location_km: 8, time_s: 600, stop: true, dwell_s: 60}, {location_km: 16, time_s: 1300, stop: true}",
                track, drivers::ability());
  PointTrain train(driver, track, 1000.0, 0.0);
  train.run(3600.0, stands);
  const double arrived_s = train.seconds();
  EXPECT_NEAR(arrived_s, 600.0, 5.0);
  EXPECT_NEAR(train.s, 8000.0, 20.0);
  train.run(3600.0, [](const PointTrain& x) { return x.v > 0.5; });
  EXPECT_GT(train.seconds(), arrived_s + 60.0);
  EXPECT_LT(train.seconds(), arrived_s + 80.0);  // notch by notch against the brake that still releases
  train.run(3600.0, stands);
  EXPECT_NEAR(train.seconds(), 1300.0, 5.0);
  EXPECT_NEAR(train.s, 16000.0, 20.0);
}

/// The share of one locomotive of 134 t with two wagons of 120 t. The same train to him, or he counts shoes twice.
TEST(TimetableDriverTest, HeBrakesAlikeWhicheverVehiclesTheShoesAreOn) {
  const rail::Track track =
      drivers::line(kLevel + ", {from_km: 3, grade_permille: -25}, {from_km: 6, grade_permille: 0}",
                    "{from_km: 0, limit_kmph: 60}, {from_km: 8, limit_kmph: 30}, {from_km: 9, limit_kmph: 60}");
  for (const char* release : {"direct", "graduated"}) {
    const ltd::Driver driver = timetable("{location_km: 12, stop: true}", track, drivers::ability(),
                                         std::string("brake_release: ") + release + "\n");
    PointTrain wagons(driver, track, 1000.0, 55.0 * kKmph), all(driver, track, 1000.0, 55.0 * kKmph);
    all.loco_shoes_share = 134.0 / 374.0;
    while (!stands(wagons) && wagons.seconds() < 3600.0) {
      wagons.step();
      all.step();
      ASSERT_NEAR(all.s, wagons.s, 1e-3) << release << " at " << wagons.seconds() << " s";  // of sums' last bits
    }
    EXPECT_TRUE(stands(all)) << release;
    EXPECT_GE(wagons.seen.air_changes, 2) << release;
  }
}

TEST(TimetableDriverTest, CruisingTheNotchDoesNotHunt) {
  const rail::Track track = drivers::line(kLevel, "{from_km: 0, limit_kmph: 60}");
  const ltd::Driver driver = timetable("{location_km: 30}", track, drivers::ability());
  PointTrain train(driver, track, 1000.0, 55.0 * kKmph);
  train.run(120.0);
  const int settled = train.seen.notch_changes;
  train.run(1320.0);
  EXPECT_LE(train.seen.notch_changes - settled, 40);  // in 20 minutes: a step each 30 s at the most
  EXPECT_GT(train.v, 55.0 * kKmph);
}

TEST(TimetableDriverTest, DownALongGradeTheDynamicBrakeAloneHoldsTheSpeedIfItCan) {
  const rail::Track track = descent(-10.0);
  const ltd::Driver driver = timetable("{location_km: 30}", track, drivers::ability());
  PointTrain train(driver, track, 1000.0, 55.0 * kKmph);
  train.run(3600.0, [](const PointTrain& x) { return x.s > 22000.0; });
  EXPECT_LT(train.seen.largest_excess_mps, 1.0 * kKmph);
  EXPECT_GT(train.v, 55.0 * kKmph);
  EXPECT_EQ(train.seen.air_changes, 0);
  EXPECT_GE(train.seen.largest_brake_notch, 3);  // 206 kN at 75 kN a notch
  EXPECT_LE(train.seen.brake_notch_changes, 40);
}

TEST(TimetableDriverTest, DownASteeperGradeAirJoinsOnceAndTheDynamicBrakeTrims) {
  const rail::Track track = descent(-25.0);
  const ltd::Driver driver = timetable("{location_km: 30}", track, drivers::ability());
  PointTrain train(driver, track, 1000.0, 55.0 * kKmph);
  train.run(3600.0, [](const PointTrain& x) { return x.s > 22000.0; });
  EXPECT_LT(train.seen.largest_excess_mps, 1.0 * kKmph);
  EXPECT_EQ(train.seen.air_changes, 1);
  EXPECT_EQ(train.seen.smallest_pipe_Pa, 4.5e5);
  EXPECT_GT(train.v, 54.0 * kKmph);
  EXPECT_GT(driver.lead(train.state).brake_notch, 0);
}

TEST(TimetableDriverTest, WithoutDynamicBrakeAirIsAppliedAndReleasedOnceAMinuteAtMost) {
  for (const char* release : {"brake_release: direct\n", "brake_release: graduated\n"}) {
    const rail::Track track = descent(-10.0);
    ltd::TrainAbility can = drivers::ability();
    can.brake_notches = 0;
    const ltd::Driver driver = timetable("{location_km: 25, stop: true}", track, can, release);
    PointTrain train(driver, track, 1000.0, 55.0 * kKmph);
    train.run(3600.0, [](const PointTrain& x) { return x.s > 22000.0; });
    EXPECT_LT(train.seen.largest_excess_mps, 1.0 * kKmph) << release;
    EXPECT_GT(train.seen.smallest_mps, 45.0 * kKmph) << release;
    EXPECT_LE(train.seen.air_changes, 44) << release;  // in 22 minutes
    train.run(3600.0, stands);
    EXPECT_NEAR(train.s, 25000.0, 20.0) << release;
  }
}

TEST(TimetableDriverTest, BrakesThatAreSlowToFillAreAppliedSoMuchEarlier) {
  const rail::Track track = drivers::line(kLevel, "{from_km: 0, limit_kmph: 70}, {from_km: 6, limit_kmph: 40}");
  ltd::TrainAbility can = drivers::ability();
  can.brake_notches = 0;
  for (const double lag_s : {5.0, 20.0}) {
    const double share_per_s = 0.5 / lag_s;  // half of full service is worth as much after delay 0 + lag
    can.brake_response = {0.5 * lag_s, share_per_s, 0.5 * lag_s, share_per_s, 2.0 * lag_s, 3.0 * lag_s};
    const ltd::Driver driver = timetable("{location_km: 20}", track, can,
                                         "service_deceleration_mps2: 0.3\nbrake_release: graduated\n"
                                         "limit_margin_kmph: 0\n");
    PointTrain train(driver, track, 3000.0, 65.0 * kKmph);
    train.air_lag_s = lag_s;
    train.run(600.0, [](const PointTrain& x) { return x.s > 6500.0; });
    EXPECT_LT(train.seen.largest_excess_mps, 0.5 * kKmph) << lag_s;
    EXPECT_GT(train.seen.smallest_mps, 25.0 * kKmph) << lag_s;  // braked in time he need not brake hard, too late 16
  }
}

TEST(TimetableDriverTest, SaysHowLateWhenATimetableCannotBeKept) {
  const rail::Track track = drivers::line(kLevel, "{from_km: 0, limit_kmph: 60}");
  const ltd::Driver driver =
      timetable("{location_km: 12, time_s: 500}, {location_km: 13, time_s: 2000}", track, drivers::ability());
  PointTrain train(driver, track, 1000.0, 0.0);
  train.run(1200.0, [](const PointTrain& x) { return x.s > 12500.0; });
  const double late_s = std::round(train.seen.time_at_km10[120] - 500.0);
  EXPECT_GT(late_s, 160.0);  // 11 km take 660 s at 60 km/h
  ASSERT_EQ(driver.notes(train.state).size(), 1u);
  const std::string note = driver.notes(train.state).front();
  EXPECT_TRUE(fixtures::contains(note, "timetable: 12.000 km reached 2")) << note;
  EXPECT_NEAR(std::stod(note.substr(note.find("reached ") + 8)), late_s, 1.0);
}

TEST(TimetableDriverTest, WithinTheToleranceNothingIsSaid) {
  const rail::Track track = drivers::line(kLevel, "{from_km: 0, limit_kmph: 60}");
  const ltd::Driver driver =
      timetable("{location_km: 12, time_s: 500}", track, drivers::ability(), "late_tolerance_s: 300\n");
  PointTrain train(driver, track, 1000.0, 0.0);
  train.run(1200.0, [](const PointTrain& x) { return x.s > 12500.0; });
  EXPECT_TRUE(driver.notes(train.state).empty());
}

TEST(TimetableDriverTest, ACopyOfTheStateGoesOnWithTheSameBits) {
  const rail::Track track = descent(-25.0);
  const ltd::Driver driver = timetable("{location_km: 15, time_s: 1000, stop: true}", track, drivers::ability());
  PointTrain train(driver, track, 1000.0, 0.0);
  train.run(333.3);
  PointTrain copy(train);
  train.run(700.0);
  copy.run(700.0);
  EXPECT_EQ(train.s, copy.s);
  EXPECT_EQ(train.v, copy.v);
  EXPECT_TRUE(driver.lead(train.state) == driver.lead(copy.state));
  EXPECT_EQ(train.state.changes.size(), copy.state.changes.size());
}

TEST(TimetableDriverTest, NeverCommandsANotchAndABrakeNotchAtOnce) {
  const rail::Track track =
      drivers::line(kLevel + ", {from_km: 3, grade_permille: -15}, {from_km: 4, grade_permille: 8}",
                    "{from_km: 0, limit_kmph: 70}, {from_km: 6, limit_kmph: 30}");
  const ltd::Driver driver = timetable("{location_km: 9, stop: true}", track, drivers::ability());
  PointTrain train(driver, track, 1000.0, 0.0);
  while (!stands(train) && train.seconds() < 2000.0) {
    train.step();
    const ltd::DriverCommand& lead = driver.lead(train.state);
    ASSERT_FALSE(lead.notch > 0 && lead.brake_notch > 0) << "at " << train.seconds() << " s";
  }
  EXPECT_NEAR(train.s, 9000.0, 20.0);
}

}  // namespace
