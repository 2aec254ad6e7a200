#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/ros.h>
#include <train_msgs/JoinTrain.h>
#include <train_msgs/LocoForce.h>
#include <train_msgs/LocoTraction.h>
#include <train_msgs/StepLock.h>
#include <train_msgs/TrainStatus.h>

#include <condition_variable>
#include <csignal>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "loco_links.hpp"
#include "ltd_sim/cosimulation.hpp"
#include "ltd_sim/progress.hpp"
#include "ltd_sim/run_control.hpp"
#include "ltd_sim/run_outputs.hpp"
#include "ltd_sim/scenario.hpp"
#include "ltd_sim/step_lock.hpp"

namespace ltd {

/// The train as a ROS node: owns time, train and lock; see docs/cosimulation.md. Runs one scenario and ends.
///
/// An answer that completes a step is worked up at once in the thread that received it: that thread commits the step
/// and sends the next one, without a change of thread in between. The thread of run() watches deadlines, commands and
/// signals.
///
/// Publishes /loco_i/force, /train/state, /train/energy, /train/status, /train/configuration, /clock, /diagnostics;
/// subscribes /loco_i/traction; serves /train/join and /train/step_lock.
class LtdNode {
 public:
  struct Options {
    std::string out;     ///< folder of the results
    bool record = true;  ///< write a bag
    bool hold = false;   ///< start held
  };
  LtdNode(const Scenario& scenario, const Options& options);

  /// Runs until the scenario ends, somebody stops it, or `interrupted` becomes non-zero.
  /// @return exit status as of Outcome
  int run(const volatile std::sig_atomic_t& interrupted);

 private:
  StepLock::Settings lockSettings(const Options& options) const;
  bool onJoin(train_msgs::JoinTrain::Request& request, train_msgs::JoinTrain::Response& response);
  bool onStepLock(train_msgs::StepLock::Request& request, train_msgs::StepLock::Response& response);
  void onTraction(const train_msgs::LocoTraction& msg);
  RunControl::Situation situation() const;
  bool advance();
  void watch(const volatile std::sig_atomic_t& interrupted);
  std::uint8_t phase() const;
  void publishStatus();
  void publishDiagnostics();
  void sayOnce(const std::string& what);

  const Scenario& scenario_;
  std::uint64_t run_id_;
  RunControl control_;
  LocoLinks links_;
  StepLock lock_;
  RunOutputs outputs_;
  ProgressMeter progress_;
  std::vector<std::unique_ptr<RunObserver>> owned_observers_;
  std::unique_ptr<Cosimulation> cosimulation_;

  ros::NodeHandle node_;
  ros::Publisher status_publisher_, diagnostics_publisher_;
  ros::ServiceServer join_server_, step_lock_server_;
  std::mutex mutex_;  ///< guards everything above
  std::condition_variable news_;
  std::string said_;
  std::string broken_;  ///< what an observer could not do, found in the receiving thread
  double next_heartbeat_s_ = 0.0;
  std::uint8_t last_phase_ = 255;
  double first_step_wall_s_ = -1.0;
};

}  // namespace ltd
