#pragma once

#include <ros/ros.h>
#include <train_msgs/LocoForce.h>
#include <train_msgs/LocoTraction.h>

#include <functional>
#include <vector>

#include "loco_dynamics/exchange.hpp"
#include "loco_dynamics/node/immediate_queue.hpp"

namespace ltd {

/// The topics to and from the locomotives: /loco_i/force out, /loco_i/traction in. Answers are handed on at once, in
/// the thread that receives them.
class LocoLinks {
 public:
  using Receive = std::function<void(const train_msgs::LocoTraction&)>;
  explicit LocoLinks(std::size_t locomotives);
  ~LocoLinks() { close(); }

  /// From now on answers are handed to `receive`, in another thread, until close().
  void open(Receive receive);
  void close();

  void send(std::size_t index, const loco::ForceMessage& message);
  /// True while a node publishes this locomotive's answers.
  bool connected(std::size_t index) const {
    return index < subscribers_.size() && subscribers_[index].getNumPublishers() > 0;
  }

 private:
  loco::ImmediateQueue queue_;
  ros::NodeHandle node_;
  Receive receive_;
  std::vector<ros::Publisher> publishers_;
  std::vector<ros::Subscriber> subscribers_;
  train_msgs::LocoForce msg_;
};

}  // namespace ltd
