#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

#include "ltd_sim/csv_file.hpp"
#include "ltd_sim/run_observer.hpp"

namespace ltd {

/// summary.csv, long form: model,vehicle,quantity,unit,location_km,value. For every locomotive at every report location
/// (place of the leading locomotive): traction_force, speed, time, energies at rail and rim, of slip, brakes and
/// shoes and, with a supply, behind the rim, interpolated linearly in place between the two steps around it. Once per
/// run, without vehicle and place: the energy account of the whole train and its residual, final values, and the
/// real-time factor (wall time, so never the same twice).
class SummaryWriter : public RunObserver {
 public:
  SummaryWriter(const Scenario& scenario, const std::string& path);
  void onStart(const TrainState& state) override;
  void onStep(const StepRecord& record) override;
  void onEnd(const TrainState& state, const Outcome& outcome) override;

 private:
  void reportLocos(double location_m, double w, const TrainSnapshot& before, const TrainSnapshot& after);
  using RowOf = std::function<void(const char* quantity, const char* unit, double value)>;
  static void reportSupply(const PowerSupply& supply, const PowerSupply::State& before, const PowerSupply::State& after,
                           double w, const RowOf& row);
  void runRow(const std::string& quantity, const std::string& unit, double value);
  void noteStepUse(const TrainForces& forces);
  double realTimeFactor() const;

  const Scenario& scenario_;
  CsvFile file_;
  std::size_t lead_;
  std::size_t next_location_ = 0;
  double largest_step_use_ = 0.0;
  double largest_draft_N_ = 0.0, largest_buff_N_ = 0.0;
  std::uint64_t steps_ = 0;
  std::chrono::steady_clock::time_point started_;  ///< end of the first step
};

}  // namespace ltd
