#include "ltd_sim/timetable_line.hpp"

#include "point_train.hpp"

namespace {

constexpr double kKmph = 1.0 / rail::kKmphPerMps;
constexpr double kCell_m = 10.0;  // of the line

TEST(TimetableLineTest, TheBrakingCurveReachesALowerLimitInTimeAndHoldsItUntilTheTailIsOut) {
  const rail::Track track =
      drivers::line("{from_km: 0, grade_permille: 0}",
                    "{from_km: 0, limit_kmph: 72}, {from_km: 5, limit_kmph: 36}, {from_km: 5.5, limit_kmph: 72}");
  ltd::TrainAbility can = drivers::ability();
  can.brake_response.release_per_s = 1e9;  // the curve does not fade
  const ltd::TimetableLine line(track, can, 0.2, 0.0);
  // the head is 11 m ahead, so the limit begins in the cell of 4989 m
  const double begin_m = 4980.0;
  EXPECT_NEAR(line.permittedSpeed(begin_m), 10.0, 1e-12);
  for (const double d : {10.0, 100.0, 500.0})  // v^2 = v_lim^2 + 2 a d
    EXPECT_NEAR(line.permittedSpeed(begin_m - d), std::sqrt(100.0 + 2.0 * 0.2 * d), 1e-9);
  EXPECT_NEAR(line.permittedSpeed(begin_m - 800.0), 20.0, 1e-9);
  EXPECT_NEAR(line.permittedSpeed(5500.0 + drivers::kBehind_m - 1.0), 10.0, 1e-12);
  EXPECT_NEAR(line.permittedSpeed(5500.0 + drivers::kBehind_m + kCell_m), 20.0, 1e-12);
}

TEST(TimetableLineTest, TowardsALimitTheCurveFadesAsTheBrakesLetGo) {
  const rail::Track track =
      drivers::line("{from_km: 0, grade_permille: 0}", "{from_km: 0, limit_kmph: 72}, {from_km: 5, limit_kmph: 36}");
  ltd::TrainAbility can = drivers::ability();
  can.brake_response.release_per_s = 0.01;
  const double rho = 0.01 * 0.6;  // full service of that train, m/s2
  const ltd::TimetableLine line(track, can, 0.2, 0.0);
  for (double s = 3500.0; s < 4900.0; s += 100.0) {
    const double v = line.permittedSpeed(s), after = line.permittedSpeed(s + kCell_m);
    const double a = (v * v - after * after) / (2.0 * kCell_m), middle = 0.5 * (v + after);
    if (v < 20.0) {
      EXPECT_NEAR(a, std::min(0.2, std::sqrt(2.0 * rho * (middle - 10.0))), 0.004) << s;  // of cells
    }
  }
}

TEST(TimetableLineTest, TheCurveAsksForAShareOfWhatFullServiceLeavesOnTheGrade) {
  const rail::Track track =
      drivers::line("{from_km: 0, grade_permille: -20}", "{from_km: 0, limit_kmph: 72}, {from_km: 5, limit_kmph: 36}");
  ltd::TrainAbility can = drivers::ability();
  can.brake_response.release_per_s = 1e9;
  const ltd::TimetableLine line(track, can, 0.4, 0.0);
  const double a = 0.85 * (0.6 - 0.020 * rail::kGravity_mps2);
  EXPECT_NEAR(line.permittedSpeed(4980.0 - 300.0), std::sqrt(100.0 + 2.0 * a * 300.0), 1e-6);
  EXPECT_NEAR(line.decelerationTo(4000.0), a, 1e-9);
  EXPECT_EQ(ltd::TimetableLine(track, can, 0.2, 0.0).decelerationTo(4000.0), 0.2);
}

TEST(TimetableLineTest, TheMarginIsTakenOffEveryLimit) {
  const rail::Track track = drivers::line("{from_km: 0, grade_permille: 0}", "{from_km: 0, limit_kmph: 72}");
  const ltd::TimetableLine line(track, drivers::ability(), 0.2, 2.0 * kKmph);
  EXPECT_NEAR(line.permittedSpeed(3000.0), 70.0 * kKmph, 1e-12);
  EXPECT_NEAR(line.smallestSpeed(), 70.0 * kKmph, 1e-12);
}

/// Constant force, no resistance: the times are those of uniform acceleration.
ltd::TrainAbility constantPull(double mps2) {
  ltd::TrainAbility can = drivers::ability();
  can.traction_N = [=](int, double) { return mps2 * drivers::kMass_kg; };
  can.resistance_N = nullptr;
  return can;
}

TEST(TimetableLineTest, RunningTimeOfUniformAccelerationCruisingAndBraking) {
  const rail::Track track = drivers::line("{from_km: 0, grade_permille: 0}", "{from_km: 0, limit_kmph: 72}");
  const ltd::TimetableLine line(track, constantPull(0.1), 0.2, 0.0);
  // 0.1 m/s2 to 10 m/s: 100 s and 500 m; 3250 m at 10 m/s: 325 s; 0.2 m/s2 to 0: 50 s and 250 m. Cells of 10 m split
  // the kinks by a second at most.
  EXPECT_NEAR(line.runningTime(1000.0, 0.0, 5000.0, 0.2, 10.0), 100.0 + 325.0 + 50.0, 1.0);
  EXPECT_NEAR(line.runningTime(1000.0, 10.0, 5000.0, 0.0, 10.0), 400.0, 1e-6);
}

TEST(TimetableLineTest, AGradeTakesItsShareOfThePull) {
  const rail::Track track = drivers::line("{from_km: 0, grade_permille: 5}", "{from_km: 0, limit_kmph: 72}");
  const ltd::TimetableLine line(track, constantPull(0.1), 0.2, 0.0);
  const double a = 0.1 - 0.005 * rail::kGravity_mps2;  // uphill
  EXPECT_NEAR(line.runningTime(1000.0, 0.0, 2000.0, 0.0, 20.0), std::sqrt(2.0 * 1000.0 / a), 0.5);
}

TEST(TimetableLineTest, SlowerCruisingTakesLonger) {
  const rail::Track track = drivers::line("{from_km: 0, grade_permille: 2}", "{from_km: 0, limit_kmph: 72}");
  const ltd::TimetableLine line(track, drivers::ability(), 0.2, 0.0);
  double last_s = 1e9;
  for (double v = 3.0; v <= 20.0; v += 0.5) {
    const double time_s = line.runningTime(1000.0, 5.0, 15000.0, 0.2, v);
    EXPECT_LT(time_s, last_s);
    last_s = time_s;
  }
}

}  // namespace
