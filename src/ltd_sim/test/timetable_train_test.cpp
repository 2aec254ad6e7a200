// The timetable's driver with the whole train of docs/whole_trips.md, 105 loaded wagons: limits, stops, descents.

#include <algorithm>
#include <cmath>

#include "ltd_sim/scenario.hpp"
#include "scratch_directory.hpp"
#include "train_fixtures.hpp"

namespace {

const std::string kConfig = CONFIG_DIR;
constexpr double kKmph = 1.0 / rail::kKmphPerMps;

/// What is seen of a run.
struct Watch : ltd::RunObserver {
  void onStep(const ltd::StepRecord& r) override {
    const ltd::DriverView& view = r.forces.view;
    excess_mps = std::max(excess_mps, view.speed_mps - view.speed_limit_mps);
    brake_notch_changes += r.forces.brake_notch[0] != last_brake_notch_;
    last_brake_notch_ = r.forces.brake_notch[0];
    if (view.t >= from) slowest_mps = std::min(slowest_mps, view.speed_mps);
    if (r.after.driver.timetable.waiting) stood_at_s = std::min(stood_at_s, rail::toSeconds(view.t));
    for (const ltd::Coupler::Force& coupler : r.forces.coupler)
      (stood_at_s < 1e8 ? draft_after_N : draft_before_N) =
          std::max(stood_at_s < 1e8 ? draft_after_N : draft_before_N, coupler.force_N);
    place_m = view.location_m;
    least_place_m = stood_at_s < 1e8 ? std::min(least_place_m, place_m) : 1e9;
  }
  rail::Nanoseconds from = 0;  ///< of slowest_mps
  double excess_mps = -1e9, slowest_mps = 1e9;
  int brake_notch_changes = 0;
  double stood_at_s = 1e9;  ///< first
  double draft_before_N = 0.0, draft_after_N = 0.0;
  double place_m = 0.0, least_place_m = 1e9;

 private:
  int last_brake_notch_ = 0;
};

class TimetableTrainTest : public fixtures::ScratchDirectory {
 protected:
  /// @param line  grades and limits; @param points  with a of the curves; @param run  overrides of place and speed
  fixtures::FinishedRun drive(const std::string& grades, const std::string& limits, const std::string& points,
                              double a_mps2, const std::string& brake, std::vector<rail::Override> run, Watch& watch) {
    write("line.yaml", "name: test\nstart_km: 0\nend_km: 30\ncurves: []\ngrades: [" + grades + "]\nspeed_limits: [" +
                           limits + "]\n");
    write("driver.yaml", "kind: timetable\nbrake_release: graduated\npoints: [" + points +
                             "]\nservice_deceleration_mps2: " + std::to_string(a_mps2) +
                             "\ngroups: {lead: {follows: lead}}\n");
    const std::vector<rail::Override> all = {{"train_file", kConfig + "/trains/mine_to_port.yaml"},
                                             {"track_file", path("line.yaml")},
                                             {"driver_file", path("driver.yaml")},
                                             {"air_brake_file", kConfig + "/brakes/" + brake},
                                             {"run.end_at_standstill_s", "20"},  // counts at the last point only
                                             {"steps.macro_step_s", "0.002"},
                                             {"steps.micro_step_s", "0.002"}};
    run.insert(run.begin(), all.begin(), all.end());
    const ltd::Scenario scenario = ltd::Scenario::load(kConfig + "/scenarios/emergency_stop.yaml", run);
    return fixtures::run(scenario, {&watch});
  }
};

const std::string kLevel = "{from_km: 0, grade_permille: 0}";

TEST_F(TimetableTrainTest, ALowerLimitIsKeptInEveryPositionOfTheBrake) {
  struct Case {
    const char *brake, *a_mps2, *from_kmph, *from_km;
  };
  for (const Case& c : {Case{"uic_g.yaml", "0.3", "43", "7.1"},  // 0.34 are allowed
                        {"uic_g.yaml", "0.3", "75", "6.6"},
                        {"uic_g.yaml", "0.2", "75", "6.6"},
                        {"uic_p.yaml", "0.3", "75", "6.6"},
                        {"ecp.yaml", "0.3", "75", "6.6"}}) {
    Watch watch;
    const fixtures::FinishedRun run = drive(kLevel, "{from_km: 0, limit_kmph: 80}, {from_km: 8, limit_kmph: 25}",
                                            "{location_km: 20}", std::stod(c.a_mps2), c.brake,
                                            {{"run.start_speed_kmph", c.from_kmph},
                                             {"run.start_location_km", c.from_km},
                                             {"run.end_location_km", "8.3"},
                                             {"run.end_time_s", "300"},
                                             {"output.report_locations_km", "[]"},
                                             {"output.section_boundaries_km", "[]"}},
                                            watch);
    const std::string which = std::string(c.brake) + ", " + c.a_mps2 + " m/s2 from " + c.from_kmph + " km/h";
    EXPECT_TRUE(run.outcome.notes.empty()) << which << fixtures::joined(run.outcome.notes);
    EXPECT_LT(watch.excess_mps, 0.5 * kKmph) << which;
    EXPECT_GT(watch.place_m, 8299.0) << which << run.outcome.reason;  // and he does not come to a stand for it
  }
}

TEST_F(TimetableTrainTest, AfterAStopHePullsOnlyOnceTheTailIsFree) {
  Watch watch;
  const fixtures::FinishedRun run =
      drive(kLevel + ", {from_km: 6, grade_permille: -4}", "{from_km: 0, limit_kmph: 80}",
            "{location_km: 10.5, stop: true, dwell_s: 20}, {location_km: 20}", 0.08, "uic_g.yaml",
            {{"run.start_speed_kmph", "0"},
             {"run.start_location_km", "9.2"},
             {"run.end_location_km", "10.8"},
             {"run.end_time_s", "600"},
             {"output.report_locations_km", "[]"},
             {"output.section_boundaries_km", "[]"}},
            watch);
  EXPECT_EQ(run.outcome.reason, "reached 10.800 km");
  // Leaving is no worse than the start with brakes that were never on; with the tail braked it is 2.5 MN.
  EXPECT_LT(watch.draft_after_N, 1.1 * watch.draft_before_N);
  EXPECT_GT(watch.draft_before_N, 1.0e6);
}

TEST_F(TimetableTrainTest, AStandstillEndsTheRunAtTheLastPointOnly) {
  Watch watch;
  const fixtures::FinishedRun run =
      drive(kLevel, "{from_km: 0, limit_kmph: 80}",
            "{location_km: 9.4, stop: true, dwell_s: 40}, {location_km: 9.5, stop: true}", 0.08, "ecp.yaml",
            {{"run.start_speed_kmph", "20"},
             {"run.start_location_km", "9.2"},
             {"run.end_location_km", "10"},
             {"run.end_time_s", "900"},
             {"output.report_locations_km", "[]"},
             {"output.section_boundaries_km", "[]"}},
            watch);
  EXPECT_TRUE(run.outcome.reason == "stands at 9.500 km" || run.outcome.reason.find("stands at 9.49") == 0)
      << run.outcome.reason;
}

TEST_F(TimetableTrainTest, UphillHeLeavesWithoutRollingBack) {
  Watch watch;
  const fixtures::FinishedRun run =
      drive("{from_km: 0, grade_permille: 5}", "{from_km: 0, limit_kmph: 80}",
            "{location_km: 9.6, stop: true, dwell_s: 20}, {location_km: 20}", 0.08, "uic_g.yaml",
            {{"run.start_speed_kmph", "20"},
             {"run.start_location_km", "9.2"},
             {"run.end_location_km", "9.8"},
             {"run.end_time_s", "600"},
             {"output.report_locations_km", "[]"},
             {"output.section_boundaries_km", "[]"}},
            watch);
  EXPECT_EQ(run.outcome.reason, "reached 9.800 km");
  EXPECT_NEAR(watch.least_place_m, 9600.0, 20.0);
  EXPECT_LT(watch.stood_at_s, 1e8);
}

TEST_F(TimetableTrainTest, DownALongGradeAirStaysAndTheDynamicBrakeTrimsSeldom) {
  Watch watch;
  watch.from = 60 * rail::kNanosecondsPerSecond;
  const fixtures::FinishedRun run =
      drive("{from_km: 0, grade_permille: -9}", "{from_km: 0, limit_kmph: 60}", "{location_km: 25}", 0.08, "uic_g.yaml",
            {{"run.start_speed_kmph", "53"},
             {"run.start_location_km", "5"},
             {"run.end_location_km", "15"},
             {"run.end_time_s", "1200"},
             {"output.report_locations_km", "[]"},
             {"output.section_boundaries_km", "[]"}},
            watch);
  EXPECT_EQ(run.outcome.kind, ltd::Outcome::Kind::kFinished) << run.outcome.reason;
  EXPECT_LT(watch.excess_mps, 0.0);
  EXPECT_GT(watch.slowest_mps, 52.0 * kKmph);
  EXPECT_LE(watch.brake_notch_changes, 25);  // in 11 minutes; to 8 and back would be 16
}

}  // namespace
