#pragma once

#include <string>

#include "ltd_sim/csv_file.hpp"
#include "ltd_sim/run_observer.hpp"

namespace ltd {

/// timeseries.csv: one row per timeseries interval, from the start on: place, time, speed and notch of the leading
/// locomotive, its traction, traction, power and energy of all locomotives, and the largest draft and buff force in the
/// train since the row before, with the coupler it was in (from 1; empty if there was none); the lowest speed limit
/// under the train, brake notch, pressure in the pipe at the leading locomotive, force of the wagons' shoes, and what
/// the locomotives' brakes took at the rail and their motors got of it.
class TimeseriesWriter : public RunObserver {
 public:
  TimeseriesWriter(const Scenario& scenario, const std::string& path);
  void onStart(const TrainState& state) override;
  void onStep(const StepRecord& record) override;
  void onEnd(const TrainState& state, const Outcome& outcome) override;

 private:
  struct Extreme {
    double force_N = 0.0;
    std::size_t coupler = 0;  ///< from 1; 0: none
  };
  void noteCouplers(const TrainForces& forces);
  /// What of a step's forces goes into a row; before the first step as given here.
  struct Told {
    int notch = 0, brake_notch = 0;
    double speed_limit_mps = 0.0, pipe_pressure_Pa = 0.0, air_brake_N = 0.0;
  };
  void writeRow(const TrainState& state, const Told& told);

  const Scenario& scenario_;
  CsvFile file_;
  Extreme draft_, buff_;
};

}  // namespace ltd
