#pragma once

#include <string>
#include <vector>

#include "ltd_sim/csv_file.hpp"
#include "ltd_sim/run_observer.hpp"

namespace ltd {

/// couplers.csv: of every coupler its largest draft and buff in the run, and when and where they were. Coupler i is
/// behind vehicle i, counted from 1 at the head; times are those of the step's start, places those of the leading
/// locomotive. A coupler that was never pulled has draft 0 and no time.
class CouplerWriter : public RunObserver {
 public:
  /// @throws std::runtime_error if the file cannot be written
  CouplerWriter(const Scenario& scenario, const std::string& path);
  void onStep(const StepRecord& record) override;
  void onEnd(const TrainState& state, const Outcome& outcome) override;

 private:
  struct Extreme {
    double force_N = 0.0;  ///< >= 0
    double time_s = 0.0;
    double location_m = 0.0;
  };
  static void addCells(const Extreme& extreme, std::vector<std::string>& row);

  const Scenario& scenario_;
  CsvFile file_;
  std::vector<Extreme> draft_, buff_;  ///< per coupler
};

}  // namespace ltd
