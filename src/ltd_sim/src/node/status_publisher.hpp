#pragma once

#include <ros/ros.h>
#include <train_msgs/TrainStatus.h>

#include "ltd_sim/cosimulation.hpp"
#include "ltd_sim/progress.hpp"
#include "ltd_sim/step_lock.hpp"

namespace ltd {

/// Publishes what a run is doing: /train/status (latched; LTD's heartbeat) and /diagnostics.
class StatusPublisher {
 public:
  explicit StatusPublisher(const Scenario& scenario);

  /// @param phase      of TrainStatus
  /// @param id         run and epoch
  /// @param waits_for  who keeps the run waiting, in words; empty: nobody
  void publish(std::uint8_t phase, const loco::ExchangeId& id, const std::string& waits_for,
               const Cosimulation& cosimulation, const StepLock& lock, const Progress& progress);

 private:
  void publishDiagnostics(const std::string& waits_for, const Cosimulation& cosimulation, const StepLock& lock);

  const Scenario& scenario_;
  ros::NodeHandle node_;
  ros::Publisher status_, diagnostics_;
};

}  // namespace ltd
