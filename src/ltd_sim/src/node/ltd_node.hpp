#pragma once

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
#include <set>
#include <string>
#include <vector>

#include "driver_link.hpp"
#include "loco_links.hpp"
#include "ltd_sim/cosimulation.hpp"
#include "ltd_sim/progress.hpp"
#include "ltd_sim/run_control.hpp"
#include "ltd_sim/run_outputs.hpp"
#include "ltd_sim/scenario.hpp"
#include "ltd_sim/step_lock.hpp"
#include "status_publisher.hpp"

namespace ltd {

/// The train as a ROS node: owns time, train and lock; see docs/cosimulation.md. Runs one scenario and ends.
///
/// An answer that completes a step is worked up at once in the thread that received it: that thread commits the step
/// and sends the next one, without a change of thread in between. The thread of run() watches deadlines, commands and
/// signals.
///
/// Publishes /loco_i/force, /train/state, /train/energy, /train/status, /train/configuration, /clock, /diagnostics;
/// subscribes /loco_i/traction; with a driver in another program publishes /train/driver_view and subscribes
/// /train/driver; serves /train/join and /train/step_lock.
class LtdNode {
 public:
  struct Options {
    std::string out;     ///< folder of the results
    bool record = true;  ///< write a bag
    bool hold = false;   ///< start held
    bool keep = false;   ///< stay after the run's end, for those who look at it
  };
  LtdNode(const Scenario& scenario, const Options& options);

  /// Runs until the scenario ends, somebody stops it, or `interrupted` becomes non-zero; then stays, if so asked, until
  /// `interrupted` becomes non-zero.
  /// @return exit status as of Outcome
  int run(const volatile std::sig_atomic_t& interrupted);

 private:
  StepLock::Settings lockSettings() const;
  bool onJoin(train_msgs::JoinTrain::Request& request, train_msgs::JoinTrain::Response& response);
  bool onStepLock(train_msgs::StepLock::Request& request, train_msgs::StepLock::Response& response);
  void onTraction(const train_msgs::LocoTraction& msg);
  void onDriver(const train_msgs::DriverCommand& msg);
  std::string waitsFor() const;
  RunControl::Situation situation() const;
  bool advance();
  void watch(const volatile std::sig_atomic_t& interrupted);
  std::uint8_t phase() const;
  void stay(const volatile std::sig_atomic_t& interrupted);
  void publishStatus();
  void sayOnce(const std::string& what);

  const Scenario& scenario_;
  const bool keep_;
  loco::ExchangeId id_;

  std::mutex mutex_;  ///< guards all below but links_
  std::condition_variable news_;
  RunControl control_;
  StepLock lock_;
  RunOutputs outputs_;
  ProgressMeter progress_;
  StatusPublisher status_;
  std::vector<std::unique_ptr<RunObserver>> owned_observers_;
  std::unique_ptr<Cosimulation> cosimulation_;
  std::set<std::string> said_;
  double next_heartbeat_s_ = 0.0;
  std::uint8_t last_phase_ = 255;
  bool begun_ = false;  ///< the first step has been sent

  // Last, so that nothing is received or served any more when the rest goes.
  ros::NodeHandle node_;
  LocoLinks links_;
  std::unique_ptr<DriverLink> driver_;  ///< if the driver is in another program
  ros::ServiceServer join_server_, step_lock_server_;
};

}  // namespace ltd
