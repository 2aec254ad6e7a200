#pragma once

#include <tf2_msgs/TFMessage.h>

#include <memory>
#include <vector>

#include "loco_dynamics/locomotive.hpp"
#include "ltd_sim/run_observer.hpp"
#include "rail_core/world_track.hpp"

namespace ltd {

/// Frames of all locomotives for tf, from the states of committed steps (REP-103, REP-105):
///   map                 the world: origin at the track's start on the rail tops, x along the track there, z up
///   train               the leading locomotive's CoG on the track's centre line, in the map's axes
///   loco_i/base_link    the track frame at the locomotive's CoG
///   loco_i/car_body, loco_i/bogie_frame_1, loco_i/wheelset_1 ...   bodies at their CoGs, children of base_link
class BodyFrames {
 public:
  explicit BodyFrames(const Scenario& scenario);
  /// @return transforms of all locomotives at the end of the step; valid until the next call
  const tf2_msgs::TFMessage& compute(const StepRecord& record);
  /// @return those at the start, in the equilibria that the locomotives start from; likewise
  const tf2_msgs::TFMessage& computeStart(const TrainState& state);

 private:
  void add(std::size_t i, rail::Nanoseconds t, double location_m, const std::vector<double>& state);
  void addTrain(rail::Nanoseconds t, double location_m);

  rail::WorldTrack track_;
  rail::Nanoseconds macro_step_;
  std::vector<std::size_t> vehicles_;                           ///< per locomotive
  std::vector<std::unique_ptr<loco::Locomotive>> locomotives_;  ///< to read states, not to compute
  tf2_msgs::TFMessage msg_;
};

}  // namespace ltd
