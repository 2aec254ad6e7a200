#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ltd_sim/run_observer.hpp"

namespace ltd {

/// The files that every run leaves in its folder, offline and in the graph: scenario.resolved.yaml, summary.csv,
/// timeseries.csv, energy_sections.csv, couplers.csv and, last of all, outcome.yaml (outcome, reason, step, time_s,
/// location_km, exchange_digest).
class RunOutputs : public RunObserver {
 public:
  /// Makes the folder and opens the files; what an earlier run left there is removed.
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

/// Removes what RunOutputs left in a folder earlier, so that nothing stale stands beside a new outcome. Bags stay.
void removeOutputs(const std::string& folder);

/// Says in `folder`/outcome.yaml that a run was refused or broke off before it began. What an earlier run left there
/// stays, its outcome as outcome.before.yaml: a slip of the pen must not cost the last good run.
/// @param kind  kRefused or kFailed
void writeRefusal(const std::string& folder, Outcome::Kind kind, const std::string& reason);

/// Writes `folder`/outcome.yaml by a temporary file and rename, so that it is whole or absent.
void writeOutcome(const std::string& folder, const Outcome& outcome, double time_s, double location_km,
                  std::uint64_t step);

}  // namespace ltd
