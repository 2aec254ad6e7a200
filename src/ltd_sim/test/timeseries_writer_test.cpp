#include "ltd_sim/timeseries_writer.hpp"

#include "hand_made_run.hpp"
#include "scratch_directory.hpp"

namespace {

using Row = std::vector<std::string>;

class TimeseriesWriterTest : public fixtures::ScratchDirectory {
 protected:
  TimeseriesWriterTest() { run_.scenario.output.timeseries_interval = 2 * run_.scenario.macro_step; }
  fixtures::HandMadeRun run_;
};

TEST_F(TimeseriesWriterTest, HasARowAtTheStartAndOneEveryInterval) {
  ltd::TimeseriesWriter writer(run_.scenario, path("timeseries.csv"));
  run_.start(writer);
  for (int k = 0; k < 5; ++k) run_.moveBy(writer, 1.0);
  writer.onEnd(run_.state, {});
  std::vector<std::string> times;
  for (const Row& row : cells("timeseries.csv")) times.push_back(row[1]);
  EXPECT_EQ(times, (std::vector<std::string>{"time_s", "0", "0.004", "0.008"}));
}

TEST_F(TimeseriesWriterTest, ShowsTheLeadingLocomotiveAndTheSumsOverAllOfThem) {
  ltd::TimeseriesWriter writer(run_.scenario, path("timeseries.csv"));
  run_.start(writer);
  run_.state.step = 1;
  ltd::TrainState next = run_.state;
  next.s_m[1] = 3001.5;
  next.v_mps = {1.0, 2.5, 3.0, 4.0};
  next.traction_N = {100.0, 300.0};
  next.account.traction_rail = 7000.0;
  next.account.traction_rim = 8000.0;
  next.account.brake_rail = 500.0;
  next.account.recovered_rim = 250.0;
  run_.forces.brake_notch = {2, 0};
  run_.forces.view.speed_limit_mps = 15.0;
  run_.forces.view.pipe_pressure_Pa = 4.5e5;
  run_.forces.view.air_brake_N = -1000.0;
  run_.stepTo(writer, next);
  writer.onEnd(run_.state, {});
  const std::vector<Row> rows = cells("timeseries.csv");
  EXPECT_EQ(rows[0], (Row{"location_km", "time_s", "speed_mps", "notch", "traction_force_N", "traction_force_train_N",
                          "power_rail_train_W", "energy_rail_train_J", "energy_rim_train_J", "largest_draft_N",
                          "largest_draft_coupler", "largest_buff_N", "largest_buff_coupler", "speed_limit_mps",
                          "brake_notch", "pipe_pressure_bar", "air_brake_force_N", "energy_brake_rail_train_J",
                          "energy_recovered_rim_train_J"}));
  EXPECT_EQ(rows[1], (Row{"3", "0", "2", "0", "0", "0", "0", "0", "0", "0", "", "0", "", "22.22222222222222", "0", "5",
                          "0", "0", "0"}));
  // Power: 100 N at 2.5 m/s and 300 N at 4 m/s.
  EXPECT_EQ(rows[2], (Row{"3.0015", "0.004", "2.5", "5", "100", "400", "1450", "7000", "8000", "0", "", "0", "", "15",
                          "2", "4.5", "-1000", "500", "250"}));
}

TEST_F(TimeseriesWriterTest, ShowsAtTheStartTooTheLowestLimitUnderTheTrainNotTheLocomotives) {
  run_.scenario.track = fixtures::readMap(
      "{name: test line, start_km: 0, end_km: 10, grades: [{from_km: 0, grade_permille: 0}], curves: [], "
      "speed_limits: [{from_km: 0, limit_kmph: 36}, {from_km: 2.97, limit_kmph: 72}]}",
      rail::Track::read);  // the last vehicle is at 2.963 km, the leading locomotive at 3 km
  ltd::TimeseriesWriter writer(run_.scenario, path("timeseries.csv"));
  run_.start(writer);
  writer.onEnd(run_.state, {});
  EXPECT_EQ(cells("timeseries.csv")[1][13], "10");
}

TEST_F(TimeseriesWriterTest, ShowsTheLargestDraftAndBuffSinceTheRowBeforeWithTheirCouplers) {
  ltd::TimeseriesWriter writer(run_.scenario, path("timeseries.csv"));
  run_.start(writer);
  const auto stepWith = [&](double first_N, double second_N, double third_N) {
    run_.forces.coupler[0].force_N = first_N;
    run_.forces.coupler[1].force_N = second_N;
    run_.forces.coupler[2].force_N = third_N;
    run_.moveBy(writer, 1.0);
  };
  stepWith(10.0, 50.0, -30.0);
  stepWith(20.0, -40.0, 0.0);  // row
  stepWith(0.0, 0.0, -5.0);
  stepWith(0.0, 0.0, -4.0);  // row
  writer.onEnd(run_.state, {});
  const std::vector<Row> rows = cells("timeseries.csv");
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(Row(rows[2].begin() + 9, rows[2].begin() + 13), (Row{"50", "2", "40", "2"}));
  EXPECT_EQ(Row(rows[3].begin() + 9, rows[3].begin() + 13), (Row{"0", "", "5", "3"}));
}

}  // namespace
