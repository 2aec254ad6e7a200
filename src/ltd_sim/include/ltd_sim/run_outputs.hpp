#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ltd_sim/run_observer.hpp"

namespace ltd {

/// The files that every run leaves in its folder, offline and in the graph: scenario.resolved.yaml, summary.csv,
/// timeseries.csv, energy_sections.csv and, last of all, outcome.yaml (outcome, reason, step, time_s, location_km,
/// exchange_digest).
class RunOutputs : public RunObserver {
 public:
  /// Makes the folder and opens the files; an outcome.yaml of an earlier run there is removed.
  /// @throws std::runtime_error with path and reason.
  RunOutputs(const Scenario& scenario, const std::string& folder);
  void onStart(const TrainState& state) override;
  void onStep(const StepRecord& record) override;
  void onEnd(const TrainState& state, const Outcome& outcome) override;

 private:
  const Scenario& scenario_;
  std::string folder_;
  std::vector<std::unique_ptr<RunObserver>> writers_;
};

/// Writes `folder`/outcome.yaml by a temporary file and rename, so that it is whole or absent.
void writeOutcome(const std::string& folder, const Outcome& outcome, double time_s, double location_km,
                  std::uint64_t step);

}  // namespace ltd
