#include "loco_links.hpp"

#include <string>
#include <utility>

#include "conversions.hpp"

namespace ltd {

LocoLinks::LocoLinks(std::size_t locomotives, Receive receive) : receive_(std::move(receive)) {
  node_.setCallbackQueue(&queue_);
  for (std::size_t i = 1; i <= locomotives; ++i) {
    const std::string loco = "loco_" + std::to_string(i);
    publishers_.push_back(node_.advertise<train_msgs::LocoForce>(loco + "/force", 10));
    const boost::function<void(const train_msgs::LocoTractionConstPtr&)> callback =
        [this](const train_msgs::LocoTractionConstPtr& msg) { receive_(*msg); };
    subscribers_.push_back(node_.subscribe<train_msgs::LocoTraction>(loco + "/traction", 10, callback, ros::VoidPtr(),
                                                                     ros::TransportHints().tcpNoDelay()));
  }
}

void LocoLinks::send(std::size_t index, const loco::ForceMessage& message) {
  toMsg(message, msg_);
  publishers_[index].publish(msg_);
}

void LocoLinks::shutdown() {
  for (ros::Subscriber& subscriber : subscribers_) subscriber.shutdown();
}

}  // namespace ltd
