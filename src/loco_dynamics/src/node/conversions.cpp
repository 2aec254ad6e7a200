#include "conversions.hpp"

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

void toMsg(const TractionMessage& message, train_msgs::LocoTraction& msg) {
  const LocoTraction& t = message.traction;
  msg.id = toMsg(message.id, t.step);
  msg.kind = kindOf(message.kind);
  msg.reason = t.failure;
  msg.traction = t.traction_N;
  msg.speed = t.speed_mps;
  msg.location = t.location_m;
  msg.work_rim = t.work_rim_J;
  msg.work_slip = t.work_slip_J;
  msg.state = t.state;
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

}  // namespace loco
