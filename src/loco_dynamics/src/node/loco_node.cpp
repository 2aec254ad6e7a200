#include "loco_node.hpp"

#include <train_msgs/JoinTrain.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "loco_dynamics/loco_factory.hpp"
#include "loco_dynamics/node/conversions.hpp"
#include "rail_core/build_id.hpp"
#include "rail_core/digest.hpp"

namespace loco {

namespace {

constexpr double kLookInterval_s = 0.05;     // of the joining thread, wall time
constexpr double kRetryInterval_s = 1.0;     // after a refusal that may end
constexpr double kHopelessInterval_s = 5.0;  // after one that will not in this run; the next run may take it

}  // namespace

LocoNode::LocoNode() : private_node_("~"), last_sign_of_train_(ros::WallTime::now()), last_look_(ros::WallTime::now()) {
  int locomotive = 0;
  if (!private_node_.getParam("locomotive", locomotive) || locomotive < 1)
    throw std::runtime_error(
        ros::this_node::getName() +
        ": parameter ~locomotive is missing: must be the locomotive's number from the head, from 1");
  train_ = private_node_.param<std::string>("train", "/train");
  if (private_node_.hasParam("train_deadline") &&
      (!private_node_.getParam("train_deadline", deadline_s_) || deadline_s_ <= 0.0))
    throw std::runtime_error(ros::this_node::getName() +
                             ": parameter ~train_deadline: must be a number of seconds > 0");
  request_.locomotive = static_cast<std::uint32_t>(locomotive);
  request_.build_id = rail::buildId();
  request_.arithmetic_fingerprint = rail::arithmeticFingerprint();
  request_.node = ros::this_node::getName();
  data_node_.setCallbackQueue(&queue_);
  status_subscriber_ = data_node_.subscribe(train_ + "/status", 10, &LocoNode::onStatus, this);
}

LocoNode::~LocoNode() {
  {
    const std::lock_guard<std::mutex> guard(mutex_);
    closed_ = true;  // the receiving thread may be about to call
  }
  force_subscriber_.shutdown();
  status_subscriber_.shutdown();
}

int LocoNode::run() {
  std::thread joiner([this] { keepJoined(); });
  int status = 0;
  while (ros::ok() && status == 0) {
    {
      const std::lock_guard<std::mutex> guard(mutex_);
      if (!fault_.empty()) {
        ROS_FATAL("loco_%u: %s", request_.locomotive, fault_.c_str());
        status = 2;
      } else if (trainSilent()) {
        ROS_ERROR("loco_%u: no sign of the train for %.0f s, ending", request_.locomotive, deadline_s_);
        status = 1;
      }
    }
    ros::WallDuration(kLookInterval_s).sleep();
  }
  ending_ = true;
  for (int i = 0; i < 20 && !joiner_done_; ++i) ros::WallDuration(kLookInterval_s).sleep();
  if (!joiner_done_)
    std::_Exit(status);  // it hangs in a call to a train that does not answer: nothing can end that call
  joiner.join();
  return status;
}

void LocoNode::keepJoined() {
  while (ros::ok() && !ending_) {
    bool needs_join = false;
    {
      const std::lock_guard<std::mutex> guard(mutex_);
      needs_join = session_.needsJoin();
    }
    try {
      if (needs_join) tryJoin();
    } catch (const std::exception& error) {
      const std::lock_guard<std::mutex> guard(mutex_);
      fault_ = error.what();
      break;
    }
    ros::WallDuration(kLookInterval_s).sleep();
  }
  joiner_done_ = true;
}

bool LocoNode::trainSilent() {
  const ros::WallTime now = ros::WallTime::now();
  const ros::WallDuration since_last_look = now - last_look_;
  last_look_ = now;
  // Who was suspended has heard nothing, but that says nothing about the train: its messages wait in the socket.
  if (since_last_look.toSec() > 1.0) last_sign_of_train_ = std::max(last_sign_of_train_, now - ros::WallDuration(1.0));
  return (now - last_sign_of_train_).toSec() > deadline_s_;
}

void LocoNode::tryJoin() {
  const std::string service = train_ + "/join";
  if (!ros::service::exists(service, false)) return;
  train_msgs::JoinTrain call;
  call.request = toMsg(request_);
  if (!ros::service::call(service, call)) return;
  JoinAnswer joined = fromMsg(call.response);
  joined.id.locomotive = request_.locomotive;
  if (joined.accepted) {
    takePlace(joined);
  } else {
    sayOnce("not in the train: " + joined.reason);
    const ros::WallTime again =
        ros::WallTime::now() + ros::WallDuration(joined.wait ? kRetryInterval_s : kHopelessInterval_s);
    while (ros::WallTime::now() < again && !ending_) ros::WallDuration(kLookInterval_s).sleep();
  }
}

void LocoNode::takePlace(const JoinAnswer& joined) {
  rail::Problems problems;
  const rail::Document scenario = rail::Document::parse(joined.configuration, train_ + "/join", problems);
  std::unique_ptr<Locomotive> locomotive;
  if (problems.empty()) locomotive = makeLocomotive(scenario, joined.locomotive_key, problems);
  problems.throwIfAny();
  if (!joined.state.empty() && joined.state.size() != locomotive->stateSize())
    throw std::runtime_error("the state of the train's locomotive has another length than this model's");
  {
    const std::lock_guard<std::mutex> guard(mutex_);
    session_.start(std::move(locomotive), joined);
    deadline_s_ = joined.heartbeat_deadline_s;
    last_sign_of_train_ = ros::WallTime::now();
  }
  connect();
  sayOnce("joined as incarnation " + std::to_string(joined.id.incarnation) + ", next step " +
          std::to_string(joined.step));
}

void LocoNode::connect() {
  if (traction_publisher_) return;
  traction_publisher_ = data_node_.advertise<train_msgs::LocoTraction>("traction", 10);
  force_subscriber_ = data_node_.subscribe("force", 10, &LocoNode::onForce, this, ros::TransportHints().tcpNoDelay());
}

void LocoNode::onForce(const train_msgs::LocoForceConstPtr& msg) {
  const std::lock_guard<std::mutex> guard(mutex_);
  if (closed_) return;
  last_sign_of_train_ = ros::WallTime::now();
  const TractionMessage* answer = session_.onForce(fromMsg(*msg));
  if (answer == nullptr) return;
  toMsg(*answer, traction_msg_);
  traction_msg_.header.stamp = msg->header.stamp + ros::Duration().fromNSec(msg->step_length);
  traction_publisher_.publish(traction_msg_);
}

void LocoNode::onStatus(const train_msgs::TrainStatusConstPtr& msg) {
  const std::lock_guard<std::mutex> guard(mutex_);
  if (closed_) return;
  last_sign_of_train_ = ros::WallTime::now();
  const ExchangeId& id = session_.id();
  if (session_.needsJoin()) return;
  const bool other_train = msg->run_id != id.run_id || msg->epoch != id.epoch;
  const std::size_t index = request_.locomotive - 1;
  const bool displaced = index < msg->incarnation.size() && msg->incarnation[index] > id.incarnation;
  if (other_train || displaced) session_.leave();
}

void LocoNode::sayOnce(const std::string& what) {
  if (what == said_) return;
  said_ = what;
  ROS_INFO("loco_%u: %s", request_.locomotive, what.c_str());
}

}  // namespace loco
