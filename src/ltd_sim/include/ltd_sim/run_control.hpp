#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "rail_core/sim_time.hpp"

namespace ltd {

/// What users ask of a run through /train/step_lock: hold, step, run, pace and stop. Decides whether the next macro
/// step may begin; knows no clock (wall time is an argument) and no ROS.
class RunControl {
 public:
  /// Where the run is: the start of the next step.
  struct Situation {
    std::uint64_t step = 0;
    rail::Nanoseconds time = 0;
    double location_m = 0.0;                                                     ///< of the leading locomotive
    rail::Nanoseconds end_time = std::numeric_limits<rail::Nanoseconds>::max();  ///< of the scenario
    double end_location_m = std::numeric_limits<double>::infinity();             ///< of the scenario
  };
  struct Reply {
    bool accepted = false;
    std::string message;  ///< what will happen, or the rule that the request breaks
  };

  explicit RunControl(bool start_held) : mode_(start_held ? Mode::kHold : Mode::kRun) {}

  /// HOLD, RUN, STEP n, RUN_UNTIL_TIME s, RUN_UNTIL_PLACE km, PACE times real time (0: as fast as it goes), STOP.
  Reply request(const std::string& command, double value, const Situation& now, double wall_s);

  /// True if the next step may begin; turns to hold where a target is reached.
  bool mayBegin(const Situation& now, double wall_s);
  /// Wall time until the pace lets the next step begin [s]; 0 if nothing but a command holds it.
  double paceWait(const Situation& now, double wall_s) const;

  bool held() const { return mode_ == Mode::kHold; }
  bool stopRequested() const { return stop_; }

 private:
  enum class Mode { kHold, kRun, kUntilStep, kUntilTime, kUntilPlace };
  Reply setTarget(const std::string& command, double value, const Situation& now);
  double due_s(const Situation& now) const;  ///< wall time before which the pace allows no step
  void restartPace(const Situation& now, double wall_s);

  Mode mode_;
  bool stop_ = false;
  std::uint64_t until_step_ = 0;
  rail::Nanoseconds until_time_ = 0;
  double until_place_m_ = 0.0;
  double pace_ = 0.0;  ///< largest times real time; 0: none
  rail::Nanoseconds pace_time_ = 0;
  double pace_wall_s_ = 0.0;
};

}  // namespace ltd
