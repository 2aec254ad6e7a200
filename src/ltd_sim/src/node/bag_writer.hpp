#pragma once

#include <rosbag/bag.h>
#include <train_msgs/Adhesion.h>
#include <train_msgs/LocoForce.h>
#include <train_msgs/LocoTraction.h>
#include <train_msgs/TrainEnergy.h>
#include <train_msgs/TrainState.h>

#include <memory>
#include <string>
#include <vector>

#include "body_frames.hpp"
#include "ltd_sim/run_observer.hpp"

namespace ltd {

/// Writes a run's bag: /train/configuration first, /train/state, /train/energy and /loco_i/adhesion at the telemetry
/// interval, /tf at that of the time series (tf interpolates), and, if the scenario says record_exchange, every
/// committed /loco_i/force and /loco_i/traction. Offline and graph write the same payloads; the ids of a session
/// (epoch, incarnation) are left 0. A recorded traction message goes without the locomotive's state and without what
/// /loco_i/adhesion says: the forces are enough to repeat a locomotive's run.
class BagWriter : public RunObserver {
 public:
  /// Opens `folder`/SCENARIO.bag. @throws std::runtime_error with path and reason.
  BagWriter(const Scenario& scenario, const std::string& folder, std::uint64_t run_id);
  ~BagWriter() override;
  void onStart(const TrainState& state) override;
  void onStep(const StepRecord& record) override;
  void onEnd(const TrainState& state, const Outcome& outcome) override;

 private:
  void writeTelemetry(const TrainState& state, const TrainForces& forces);
  void writeAdhesion(rail::Nanoseconds t, const std::vector<const loco::LocoTraction*>& answers);
  void writeExchange(const StepRecord& record);

  const Scenario& scenario_;
  std::uint64_t run_id_;
  BodyFrames frames_;
  const TrainForces* forces_ = nullptr;  ///< of the last step; the co-simulation's
  ros::Time written_;                    ///< stamp of the last telemetry
  std::unique_ptr<rosbag::Bag> bag_;
  std::vector<std::string> force_topics_, traction_topics_, adhesion_topics_;
  train_msgs::TrainState state_msg_;
  train_msgs::TrainEnergy energy_msg_;
  train_msgs::Adhesion adhesion_msg_;
  train_msgs::LocoForce force_msg_;
  train_msgs::LocoTraction traction_msg_;
};

}  // namespace ltd
