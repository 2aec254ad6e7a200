#include "point_train.hpp"

namespace {

using drivers::PointTrain;

const std::string kLevel = "{from_km: 0, grade_permille: 0}";
constexpr double kKmph = 1.0 / rail::kKmphPerMps;

void print(const char* what, const PointTrain& train) {
  std::printf(
      "%s: t %.1f s %.1f v %.2f excess %.2f km/h notches %d (rev %d) db %d air %d pipe %.2f dbmax %d v %.1f..%.1f "
      "km/h\n",
      what, train.seconds(), train.s, train.v, train.seen.largest_excess_mps * 3.6, train.seen.notch_changes,
      train.seen.reversals, train.seen.brake_notch_changes, train.seen.air_changes, train.seen.smallest_pipe_Pa / 1e5,
      train.seen.largest_brake_notch, train.seen.smallest_mps * 3.6, train.seen.largest_mps * 3.6);
  for (const auto& n : train.state.timetable.notes) std::printf("   %s\n", n.c_str());
}

TEST(TimetableDriverTest, KeepsLimitsUntilTheTailHasLeftAndStopsAtTheStop) {
  const rail::Track track = drivers::line(
      "{from_km: 0, grade_permille: 0}, {from_km: 4, grade_permille: 5}, {from_km: 7, grade_permille: -6}, {from_km: "
      "12, grade_permille: 0}",
      "{from_km: 0, limit_kmph: 80}, {from_km: 5, limit_kmph: 40}, {from_km: 5.5, limit_kmph: 80}, {from_km: 10, "
      "limit_kmph: 60}, {from_km: 11, limit_kmph: 80}");
  const ltd::Driver driver = drivers::timetable("{location_km: 15, stop: true}", track, drivers::ability());
  PointTrain train(driver, track, 1000.0, 0.0);
  train.run(3600.0, [](const PointTrain& x) { return x.state.timetable.waiting; });
  print("limits", train);
  EXPECT_LT(train.seen.largest_excess_mps, 1.0 * kKmph);
  EXPECT_NEAR(train.s, 15000.0, 20.0);
  train.run(train.seconds() + 60.0);
  EXPECT_EQ(train.v, 0.0);
}

TEST(TimetableDriverTest, TrainsOfDifferentStrengthArriveAtTheSameTime) {
  const rail::Track track =
      drivers::line(kLevel + ", {from_km: 8, grade_permille: 4}, {from_km: 11, grade_permille: -4}",
                    "{from_km: 0, limit_kmph: 80}, {from_km: 5, limit_kmph: 50}, {from_km: 6, limit_kmph: 80}");
  for (const double strength : {1.0, 0.8}) {
    const ltd::Driver driver = drivers::timetable(
        "{location_km: 10, time_s: 700}, {location_km: 20, time_s: 1350}, {location_km: 25, time_s: 1800, stop: true}",
        track, drivers::ability(strength));
    PointTrain train(driver, track, 1000.0, 0.0, strength);
    train.run(3600.0, [](const PointTrain& x) { return x.state.timetable.waiting; });
    print("equal", train);
    std::printf("   10 km %.1f, 20 km %.1f\n", train.seen.time_at_km10[100], train.seen.time_at_km10[200]);
    EXPECT_NEAR(train.seen.time_at_km10[100], 700.0, 5.0);
    EXPECT_NEAR(train.seen.time_at_km10[200], 1350.0, 5.0);
    EXPECT_NEAR(train.seconds(), 1800.0, 5.0);
    EXPECT_NEAR(train.s, 25000.0, 20.0);
  }
}

TEST(TimetableDriverTest, HoldsSpeedDownALongGradeWithDynamicBrakeThenAir) {
  for (const double permille : {-10.0, -25.0}) {
    const rail::Track track = drivers::line(
        kLevel + ", {from_km: 3, grade_permille: " + std::to_string(permille) + "}, {from_km: 23, grade_permille: 0}",
        "{from_km: 0, limit_kmph: 60}");
    const ltd::Driver driver = drivers::timetable("{location_km: 30}", track, drivers::ability());
    PointTrain train(driver, track, 1000.0, 55.0 * kKmph);
    train.run(3600.0, [](const PointTrain& x) { return x.s > 22000.0; });
    print("grade", train);
    EXPECT_LT(train.seen.largest_excess_mps, 1.0 * kKmph);
    EXPECT_GT(train.seen.smallest_mps, 45.0 * kKmph);
  }
}

TEST(TimetableDriverTest, AirAlone) {
  for (const char* release : {"brake_release: direct\n", "brake_release: graduated\n"}) {
    const rail::Track track = drivers::line(kLevel + ", {from_km: 3, grade_permille: -10}, {from_km: 23, grade_permille: 0}", "{from_km: 0, limit_kmph: 60}");
    ltd::TrainAbility can = drivers::ability();
    can.brake_notches = 0;
    const ltd::Driver driver = drivers::timetable("{location_km: 25, stop: true}", track, can, release);
    PointTrain train(driver, track, 1000.0, 55.0 * kKmph);
    train.run(3600.0, [](const PointTrain& x) { return x.s > 22000.0; });
    print("air alone", train);
    train.run(3600.0, [](const PointTrain& x) { return x.state.timetable.waiting; });
    print("air alone stop", train);
  }
}

TEST(TimetableDriverTest, SaysHowLateWhenATimetableCannotBeKept) {
  const rail::Track track = drivers::line(kLevel, "{from_km: 0, limit_kmph: 60}");
  const ltd::Driver driver = drivers::timetable("{location_km: 12, time_s: 500}", track, drivers::ability());
  PointTrain train(driver, track, 1000.0, 0.0);
  train.run(1200.0, [](const PointTrain& x) { return x.s > 13000.0; });
  print("late", train);
  ASSERT_EQ(driver.notes(train.state).size(), 1u);
}

TEST(TimetableDriverTest, StopsAndGoesOnAndKeepsTime) {
  const rail::Track track = drivers::line(kLevel, "{from_km: 0, limit_kmph: 80}");
  const ltd::Driver driver = drivers::timetable(
      "{location_km: 8, time_s: 600, stop: true, dwell_s: 60}, {location_km: 16, time_s: 1300, stop: true}", track,
      drivers::ability());
  PointTrain train(driver, track, 1000.0, 0.0);
  train.run(3600.0, [](const PointTrain& x) { return x.state.timetable.waiting; });
  print("stop1", train);
  train.run(3600.0, [](const PointTrain& x) { return x.state.timetable.waiting && x.state.timetable.point == 1; });
  print("stop2", train);
}

}  // namespace
