#pragma once

#include <ros/ros.h>
#include <train_msgs/Adhesion.h>
#include <train_msgs/TrainEnergy.h>
#include <train_msgs/TrainState.h>

#include <chrono>
#include <vector>

#include "body_frames.hpp"
#include "ltd_sim/run_observer.hpp"

namespace ltd {

/// Publishes a run as it goes, at the scenario's telemetry interval in simulation time: /train/state, /train/energy,
/// /clock and, for locomotives with wheels, /loco_i/adhesion, all of committed steps; /train/configuration once; /tf no
/// more than 30 times a second of wall time, for eyes. All but the clock are latched, and the start, every step in
/// which the train is held, and the end are published, too, without the energies: who comes late sees the train where
/// it stands.
class TelemetryPublisher : public RunObserver {
 public:
  TelemetryPublisher(const Scenario& scenario, std::uint64_t run_id);
  void onStart(const TrainState& state) override;
  void onStep(const StepRecord& record) override;
  void onHold(const StepRecord& record) override;

 private:
  void publishState(const StepRecord& record);
  void publishClock(rail::Nanoseconds t);
  void publishFrames(const StepRecord& record);

  const Scenario& scenario_;
  std::uint64_t run_id_;
  BodyFrames frames_;
  std::chrono::steady_clock::time_point frames_sent_;
  std::uint64_t shown_step_ = 0, frames_step_ = 0;  ///< of the last state and of the last frames
  ros::NodeHandle node_;
  ros::Publisher configuration_, state_, energy_, clock_, tf_;
  std::vector<ros::Publisher> adhesion_;  ///< per locomotive; empty where there is nothing to say
  train_msgs::TrainState state_msg_;
  train_msgs::TrainEnergy energy_msg_;
  train_msgs::Adhesion adhesion_msg_;
};

}  // namespace ltd
