#include "loco_links.hpp"

#include <string>
#include <utility>

#include "conversions.hpp"

namespace ltd {

LocoLinks::LocoLinks(std::size_t locomotives) {
  node_.setCallbackQueue(&queue_);
  for (std::size_t i = 1; i <= locomotives; ++i)
    publishers_.push_back(node_.advertise<train_msgs::LocoForce>("loco_" + std::to_string(i) + "/force", 10));
}

void LocoLinks::open(Receive receive) {
  receive_ = std::move(receive);
  for (std::size_t i = 1; i <= publishers_.size(); ++i) {
    const boost::function<void(const train_msgs::LocoTractionConstPtr&)> callback =
        [this](const train_msgs::LocoTractionConstPtr& msg) { receive_(*msg); };
    subscribers_.push_back(node_.subscribe<train_msgs::LocoTraction>(
        "loco_" + std::to_string(i) + "/traction", 10, callback, ros::VoidPtr(), ros::TransportHints().tcpNoDelay()));
  }
}

void LocoLinks::send(std::size_t index, const loco::ForceMessage& message) {
  toMsg(message, msg_);
  publishers_[index].publish(msg_);
}

void LocoLinks::close() {
  for (ros::Subscriber& subscriber : subscribers_) subscriber.shutdown();
}

}  // namespace ltd
