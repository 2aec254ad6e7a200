#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "ltd_sim/run_observer.hpp"

namespace ltd {

/// How far a run is and how fast it goes, against the wall clock.
struct Progress {
  double time_s = 0.0;
  double location_m = 0.0;
  double speed_mps = 0.0;
  int notch = 0;
  double real_time_factor = 0.0;  ///< simulation over wall time since the last report
  double time_left_s = -1.0;      ///< wall time to the end of the run at the present speed; -1 if nobody can tell
};

/// "3.412 km  96.3 s  23.8 km/h  notch 8  41 x real time  12 s left"
std::string toString(const Progress& progress);

/// Reports the progress of a run every `interval_s` of wall time.
class ProgressMeter : public RunObserver {
 public:
  using Report = std::function<void(const Progress&)>;
  ProgressMeter(const Scenario& scenario, double interval_s, Report report);
  void onStart(const TrainState& state) override;
  void onStep(const StepRecord& record) override;
  const Progress& last() const { return progress_; }

 private:
  using Clock = std::chrono::steady_clock;
  double simulatedSecondsLeft(const TrainState& state) const;

  const Scenario& scenario_;
  double interval_s_;
  Report report_;
  std::size_t lead_;
  Progress progress_;
  Clock::time_point last_report_, last_look_;
  double last_time_s_ = 0.0;
};

}  // namespace ltd
