#pragma once

#include <ros/callback_queue_interface.h>
#include <ros/ros.h>
#include <train_msgs/LocoForce.h>
#include <train_msgs/LocoTraction.h>

#include <functional>
#include <vector>

#include "loco_dynamics/exchange.hpp"

namespace ltd {

/// The topics to and from the locomotives: /loco_i/force out, /loco_i/traction in. Answers are handed on at once, in
/// the thread that receives them: that saves the change of thread of a usual callback queue, about 15 us of a round
/// trip.
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
  class ImmediateQueue : public ros::CallbackQueueInterface {
   public:
    void addCallback(const ros::CallbackInterfacePtr& callback, uint64_t /*owner_id*/) override {
      if (callback->ready()) callback->call();
    }
    void removeByID(uint64_t /*owner_id*/) override {}
  };

  ImmediateQueue queue_;
  ros::NodeHandle node_;
  Receive receive_;
  std::vector<ros::Publisher> publishers_;
  std::vector<ros::Subscriber> subscribers_;
  train_msgs::LocoForce msg_;
};

}  // namespace ltd
