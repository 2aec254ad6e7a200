#include "point_train.hpp"

namespace {

const std::string kPoints = "points: [{location_km: 12, time_s: 900}, {location_km: 20, stop: true}]\n";
const std::string kHabits = "service_deceleration_mps2: 0.2\nbrake_release: direct\n";

/// Exactly one fault, with all the parts, for a train that can do this on a line of 40 km with 10 permille down.
void expectFault(const std::string& text, const std::vector<std::string>& parts,
                 const ltd::TrainAbility& can = drivers::ability()) {
  const rail::Track track = drivers::line("{from_km: 0, grade_permille: 0}, {from_km: 9, grade_permille: -10}",
                                          "{from_km: 0, limit_kmph: 60}, {from_km: 5, limit_kmph: 15}");
  const auto faults = fixtures::faultsIn(
      "kind: timetable\n" + text + "groups: {lead: {follows: lead}}\n", [&](rail::YamlReader reader) {
        return ltd::Driver::read(reader, {"lead"}, {8}, {8}, drivers::kStep, track, can);
      });
  EXPECT_EQ(faults.size(), 1u) << fixtures::joined(faults);
  EXPECT_TRUE(fixtures::anyHas(faults, parts)) << fixtures::joined(faults);
}

TEST(TimetableReadTest, RefusesPointsThatMakeNoTimetable) {
  const auto points = [](const std::string& list) { return "points: [" + list + "]\n" + kHabits; };
  expectFault(kHabits, {"points", "is missing"});
  expectFault(points("{location_km: 41}"), {"points.0.location_km = 41", "beyond the track"});
  expectFault(points("{location_km: 9}, {location_km: 9}"), {"points.1.location_km = 9", "ahead of the point before"});
  expectFault(points("{location_km: 9, time_s: 50}, {location_km: 10, time_s: 50}"),
              {"points.1.time_s = 50", "after the times before"});
  expectFault(points("{location_km: 9, time_s: 50, stop: true, dwell_s: 60}, {location_km: 10, time_s: 110}"),
              {"points.1.time_s = 110", "after the times before"});
  expectFault(points("{location_km: 9, dwell_s: 50}"), {"points.0.dwell_s = 50", "stop: true only"});
  expectFault(points("{location_km: 9, stop: true}, {location_km: 10}"), {"points.0.stop", "must have a dwell_s"});
  expectFault(points("{location_km: 9, time: 50}"), {"points.0.time", "unknown key"});
}

TEST(TimetableReadTest, RefusesHabitsThatLineOrTrainForbid) {
  const std::string direct = "brake_release: direct\n";
  expectFault(kPoints + direct, {"service_deceleration_mps2", "is missing"});
  expectFault(kPoints + "service_deceleration_mps2: 0.2\n", {"brake_release", "is missing"});
  expectFault(kPoints + kHabits + "limit_margin_kmph: 15\n", {"limit_margin_kmph = 15", "lowest speed limit"});
  expectFault(kPoints + kHabits + "planning_period_s: 0\n", {"planning_period_s = 0", "> 0"});
  expectFault(kPoints + kHabits + "late_tolerance: 5\n", {"late_tolerance", "late_tolerance_s"});
  // 0.6 m/s2 of the brakes less 0.0981 of the grade
  expectFault(kPoints + direct + "service_deceleration_mps2: 0.51\n",
              {"service_deceleration_mps2 = 0.51", "steepest descent, 0.5019"});
}

TEST(TimetableReadTest, RefusesValvesThatHisFirstReductionDoesNotMove) {
  ltd::TrainAbility can = drivers::ability();
  can.first_reduction_Pa = 0.6e5;
  expectFault(kPoints + kHabits,
              {"kind = timetable", "with 0.5 bar at first and holds at stops with as much at least",
               "first_reduction_bar 0.6 must not be larger"},
              can);
}

TEST(TimetableReadTest, RefusesAStopOnAGradeThatFullServiceDoesNotHold) {
  // 10 permille down pull with 275 kN; the test's full service has 1680 kN
  ltd::TrainAbility can = drivers::ability();
  can.full_service_N = [](double v_mps) { return v_mps > 0.0 ? 1.68e6 : 0.4e6; };
  expectFault("points: [{location_km: 20, stop: true}]\nservice_deceleration_mps2: 0.04\nbrake_release: direct\n",
              {"points.0.location_km = 20", "would not stay on the grade there", "it pulls with 275 kN",
               "full service, 400 kN, must be 1.5 times that"},
              can);
}

TEST(TimetableReadTest, RefusesATrainWithoutBrakesOrUnknown) {
  ltd::TrainAbility can = drivers::ability();
  can.full_service_N = nullptr;
  expectFault(kPoints + kHabits, {"service_deceleration_mps2 = 0.2", "full service gives"}, can);
  expectFault(kPoints + kHabits, {"kind = timetable", "traction and brakes are known"}, {});
}

}  // namespace
