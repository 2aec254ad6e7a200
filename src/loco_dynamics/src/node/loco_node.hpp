#pragma once

#include <ros/ros.h>
#include <train_msgs/LocoForce.h>
#include <train_msgs/LocoTraction.h>
#include <train_msgs/TrainStatus.h>

#include <atomic>
#include <mutex>
#include <string>

#include "loco_dynamics/loco_session.hpp"
#include "loco_dynamics/node/immediate_queue.hpp"

namespace loco {

/// One locomotive as a ROS node: joins the train, answers LocoForce with LocoTraction, joins again when the train is
/// another one or the thread of steps is lost, and ends itself when the train has been silent for too long.
///
/// Topics, relative: force (in), traction (out). Parameters, private: ~locomotive (the i-th from the head, from 1),
/// ~train (namespace of the train, default /train), ~train_deadline (wait for a first sign of the train [s], default
/// 60).
class LocoNode {
 public:
  LocoNode();
  ~LocoNode();
  /// Returns when ROS shuts down (0), the train is silent for too long (1) or its configuration cannot be used (2).
  int run();

 private:
  void onForce(const train_msgs::LocoForceConstPtr& msg);
  void onStatus(const train_msgs::TrainStatusConstPtr& msg);
  void keepJoined();
  void tryJoin();
  void takePlace(const JoinAnswer& joined);
  void connect();
  bool trainSilent();
  void sayOnce(const std::string& what);

  ros::NodeHandle node_, private_node_;
  std::string train_;
  JoinRequest request_;
  ImmediateQueue queue_;
  ros::NodeHandle data_node_;  ///< its callbacks run at once, in the receiving thread
  ros::Subscriber force_subscriber_, status_subscriber_;
  ros::Publisher traction_publisher_;

  mutable std::mutex mutex_;  ///< guards all below
  LocoSession session_;
  train_msgs::LocoTraction traction_msg_;
  ros::WallTime last_sign_of_train_;
  double deadline_s_ = 60.0;
  ros::WallTime last_look_;  ///< of run() at the clock
  bool closed_ = false;      ///< no message is worked up any more
  std::string fault_;        ///< why this locomotive cannot be part of the train
  std::atomic<bool> ending_{false}, joiner_done_{false};
  std::string said_;
};

}  // namespace loco
