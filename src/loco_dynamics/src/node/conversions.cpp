#include "loco_dynamics/node/conversions.hpp"

#include "adhesion_conversions.hpp"

namespace loco {

namespace {

train_msgs::ExchangeId toMsg(const ExchangeId& id, std::uint64_t step) {
  train_msgs::ExchangeId msg;
  msg.run_id = id.run_id;
  msg.epoch = id.epoch;
  msg.incarnation = id.incarnation;
  msg.locomotive = id.locomotive;
  msg.step = step;
  return msg;
}

std::uint8_t kindOf(TractionMessage::Kind kind) {
  switch (kind) {
    case TractionMessage::Kind::kAnswer:
      return train_msgs::LocoTraction::ANSWER;
    case TractionMessage::Kind::kNeedState:
      return train_msgs::LocoTraction::NEED_STATE;
    case TractionMessage::Kind::kFailed:
      return train_msgs::LocoTraction::FAILED;
  }
  return train_msgs::LocoTraction::FAILED;
}

}  // namespace

ForceMessage fromMsg(const train_msgs::LocoForce& msg) {
  ForceMessage message;
  message.id = {msg.id.run_id, msg.id.epoch, msg.id.incarnation, msg.id.locomotive};
  LocoForce& f = message.force;
  f.step = msg.id.step;
  f.step_length = msg.step_length;
  f.traction_reference_N = msg.traction_reference;
  f.notch = msg.notch;
  f.brake_notch = msg.brake_notch;
  f.shoe_force_N = msg.shoe_force;
  f.sanding = msg.sanding != 0;
  f.rim_power_limit_W = msg.rim_power_limit;
  f.coupler_front_N = msg.coupler_front;
  f.coupler_rear_N = msg.coupler_rear;
  f.propulsion_resistance_N = msg.propulsion_resistance;
  f.curving_resistance_N = msg.curving_resistance;
  f.grade_N = msg.grade;
  f.speed_mps = msg.speed;
  f.location_m = msg.location;
  return message;
}

train_msgs::JoinTrain::Request toMsg(const JoinRequest& request) {
  train_msgs::JoinTrain::Request msg;
  msg.protocol_version = request.protocol_version;
  msg.build_id = request.build_id;
  msg.arithmetic_fingerprint = request.arithmetic_fingerprint;
  msg.locomotive = request.locomotive;
  msg.node = request.node;
  return msg;
}

JoinAnswer fromMsg(const train_msgs::JoinTrain::Response& msg) {
  JoinAnswer answer;
  answer.accepted = msg.accepted != 0;
  answer.reason = msg.reason;
  answer.wait = msg.wait != 0;
  answer.id = {msg.run_id, msg.epoch, msg.incarnation, 0};
  answer.step = msg.step;
  answer.state = msg.state;
  answer.location_m = msg.location;
  answer.speed_mps = msg.speed;
  answer.step_length = msg.step_length;
  answer.heartbeat_deadline_s = msg.heartbeat_deadline;
  answer.configuration = msg.configuration;
  answer.locomotive_key = msg.locomotive_key;
  return answer;
}

void toMsg(const ForceMessage& message, train_msgs::LocoForce& msg) {
  const LocoForce& f = message.force;
  msg.header.stamp = toStamp(static_cast<rail::Nanoseconds>(f.step) * f.step_length);
  msg.id = toMsg(message.id, f.step);
  msg.step_length = f.step_length;
  msg.traction_reference = f.traction_reference_N;
  msg.notch = f.notch;
  msg.brake_notch = f.brake_notch;
  msg.shoe_force = f.shoe_force_N;
  msg.sanding = static_cast<std::uint8_t>(f.sanding);
  msg.rim_power_limit = f.rim_power_limit_W;
  msg.coupler_front = f.coupler_front_N;
  msg.coupler_rear = f.coupler_rear_N;
  msg.propulsion_resistance = f.propulsion_resistance_N;
  msg.curving_resistance = f.curving_resistance_N;
  msg.grade = f.grade_N;
  msg.speed = f.speed_mps;
  msg.location = f.location_m;
}

void toMsg(const ExchangeId& id, const LocoTraction& t, train_msgs::LocoTraction& msg) {
  msg.id = toMsg(id, t.step);
  msg.kind = train_msgs::LocoTraction::ANSWER;
  msg.reason.clear();
  msg.traction = t.traction_N;
  msg.speed = t.speed_mps;
  msg.location = t.location_m;
  msg.work_rim = t.work_rim_J;
  msg.work_slip = t.work_slip_J;
  msg.work_shoes = t.work_shoes_J;
  msg.state = t.state;
  toMsg(t.adhesion, msg.axles, msg.contacts);
}

void toMsg(const TractionMessage& message, train_msgs::LocoTraction& msg) {
  toMsg(message.id, message.traction, msg);
  msg.kind = kindOf(message.kind);
  msg.reason = message.traction.failure;
}

TractionMessage fromMsg(const train_msgs::LocoTraction& msg) {
  using Kind = TractionMessage::Kind;
  TractionMessage message;
  message.id = {msg.id.run_id, msg.id.epoch, msg.id.incarnation, msg.id.locomotive};
  message.kind = msg.kind == train_msgs::LocoTraction::ANSWER       ? Kind::kAnswer
                 : msg.kind == train_msgs::LocoTraction::NEED_STATE ? Kind::kNeedState
                                                                    : Kind::kFailed;
  LocoTraction& t = message.traction;
  t.step = msg.id.step;
  t.traction_N = msg.traction;
  t.speed_mps = msg.speed;
  t.location_m = msg.location;
  t.work_rim_J = msg.work_rim;
  t.work_slip_J = msg.work_slip;
  t.work_shoes_J = msg.work_shoes;
  t.state = msg.state;
  t.adhesion = fromMsg(msg.axles, msg.contacts);
  t.failure = message.kind == Kind::kFailed && msg.reason.empty() ? "failed without a reason" : msg.reason;
  return message;
}

JoinRequest fromMsg(const train_msgs::JoinTrain::Request& msg) {
  return {msg.protocol_version, msg.build_id, msg.arithmetic_fingerprint, msg.locomotive, msg.node};
}

void toMsg(const JoinAnswer& answer, train_msgs::JoinTrain::Response& msg) {
  msg.accepted = static_cast<std::uint8_t>(answer.accepted);
  msg.reason = answer.reason;
  msg.wait = static_cast<std::uint8_t>(answer.wait);
  msg.run_id = answer.id.run_id;
  msg.epoch = answer.id.epoch;
  msg.incarnation = answer.id.incarnation;
  msg.step = answer.step;
  msg.state = answer.state;
  msg.location = answer.location_m;
  msg.speed = answer.speed_mps;
  msg.step_length = answer.step_length;
  msg.heartbeat_deadline = answer.heartbeat_deadline_s;
  msg.configuration = answer.configuration;
  msg.locomotive_key = answer.locomotive_key;
}

ros::Time toStamp(rail::Nanoseconds t) {
  ros::Time stamp;
  return stamp.fromNSec(static_cast<std::uint64_t>(t + rail::kNanosecondsPerSecond));
}

}  // namespace loco
