#include "conversions.hpp"

#include "rail_core/build_id.hpp"

namespace ltd {

namespace {

train_msgs::ExchangeId toMsg(const loco::ExchangeId& id, std::uint64_t step) {
  train_msgs::ExchangeId msg;
  msg.run_id = id.run_id;
  msg.epoch = id.epoch;
  msg.incarnation = id.incarnation;
  msg.locomotive = id.locomotive;
  msg.step = step;
  return msg;
}

rail::Nanoseconds timeOf(const Scenario& scenario, const TrainState& state) {
  return static_cast<rail::Nanoseconds>(state.step) * scenario.macro_step;
}

}  // namespace

ros::Time toStamp(rail::Nanoseconds t) {
  ros::Time stamp;
  return stamp.fromNSec(static_cast<std::uint64_t>(t + rail::kNanosecondsPerSecond));
}

void toMsg(const loco::ForceMessage& message, train_msgs::LocoForce& msg) {
  const loco::LocoForce& f = message.force;
  msg.header.stamp = toStamp(static_cast<rail::Nanoseconds>(f.step) * f.step_length);
  msg.id = toMsg(message.id, f.step);
  msg.step_length = f.step_length;
  msg.traction_reference = f.traction_reference_N;
  msg.notch = f.notch;
  msg.rim_power_limit = f.rim_power_limit_W;
  msg.coupler_front = f.coupler_front_N;
  msg.coupler_rear = f.coupler_rear_N;
  msg.propulsion_resistance = f.propulsion_resistance_N;
  msg.curving_resistance = f.curving_resistance_N;
  msg.grade = f.grade_N;
  msg.speed = f.speed_mps;
  msg.location = f.location_m;
}

void toMsg(const loco::ExchangeId& id, const loco::LocoTraction& t, train_msgs::LocoTraction& msg) {
  msg.id = toMsg(id, t.step);
  msg.kind = train_msgs::LocoTraction::ANSWER;
  msg.reason.clear();
  msg.traction = t.traction_N;
  msg.speed = t.speed_mps;
  msg.location = t.location_m;
  msg.work_rim = t.work_rim_J;
  msg.work_slip = t.work_slip_J;
  msg.state = t.state;
}

loco::TractionMessage fromMsg(const train_msgs::LocoTraction& msg) {
  using Kind = loco::TractionMessage::Kind;
  loco::TractionMessage message;
  message.id = {msg.id.run_id, msg.id.epoch, msg.id.incarnation, msg.id.locomotive};
  message.kind = msg.kind == train_msgs::LocoTraction::ANSWER       ? Kind::kAnswer
                 : msg.kind == train_msgs::LocoTraction::NEED_STATE ? Kind::kNeedState
                                                                    : Kind::kFailed;
  loco::LocoTraction& t = message.traction;
  t.step = msg.id.step;
  t.traction_N = msg.traction;
  t.speed_mps = msg.speed;
  t.location_m = msg.location;
  t.work_rim_J = msg.work_rim;
  t.work_slip_J = msg.work_slip;
  t.state = msg.state;
  t.failure = message.kind == Kind::kFailed && msg.reason.empty() ? "failed without a reason" : msg.reason;
  return message;
}

loco::JoinRequest fromMsg(const train_msgs::JoinTrain::Request& msg) {
  return {msg.protocol_version, msg.build_id, msg.arithmetic_fingerprint, msg.locomotive, msg.node};
}

void toMsg(const loco::JoinAnswer& answer, train_msgs::JoinTrain::Response& msg) {
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

void toMsg(const Scenario& scenario, const TrainState& state, const TrainForces& forces, train_msgs::TrainState& msg) {
  const std::size_t lead = scenario.train.locomotives.front().vehicle;
  const rail::Nanoseconds t = timeOf(scenario, state);
  msg.header.stamp = toStamp(t);
  msg.step = state.step;
  msg.time = rail::toSeconds(t);
  msg.location = state.s_m[lead];
  msg.speed = state.v_mps[lead];
  msg.notch.assign(forces.notch.begin(), forces.notch.end());
  msg.traction = state.traction_N;
  msg.vehicle_location = state.s_m;
  msg.vehicle_speed = state.v_mps;
  msg.coupler_force.resize(forces.coupler.size());
  for (std::size_t i = 0; i < forces.coupler.size(); ++i) msg.coupler_force[i] = forces.coupler[i].force_N;
}

void toMsg(const Scenario& scenario, const TrainState& state, train_msgs::TrainEnergy& msg) {
  const rail::EnergyAccount& a = state.account;
  msg.header.stamp = toStamp(timeOf(scenario, state));
  msg.loco_energy_rail.clear();
  msg.loco_energy_rim.clear();
  msg.loco_energy_slip.clear();
  for (const LocoEnergy& energy : state.loco_energy) {
    msg.loco_energy_rail.push_back(energy.rail);
    msg.loco_energy_rim.push_back(energy.rim);
    msg.loco_energy_slip.push_back(energy.slip);
  }
  msg.traction_rail = a.traction_rail;
  msg.traction_rim = a.traction_rim;
  msg.slip_loss = a.slip_loss;
  msg.propulsion_resistance = a.propulsion_resistance;
  msg.curving_resistance = a.curving_resistance;
  msg.grade = a.grade;
  msg.coupler_loss = a.coupler_loss;
  msg.coupler_stored = a.coupler_stored - a.coupler_stored_start;
  msg.kinetic = a.kinetic - a.kinetic_start;
  msg.potential = a.potential - a.potential_start;
  msg.residual = a.residual();
  msg.residual_relative = a.residualRelative();
}

train_msgs::RunConfiguration toMsg(const Scenario& scenario, std::uint64_t run_id) {
  train_msgs::RunConfiguration msg;
  msg.format_version = kBagFormatVersion;
  msg.build_id = rail::buildId();
  msg.run_id = run_id;
  msg.scenario = scenario.name;
  msg.scenario_file = scenario.file;
  msg.resolved = scenario.document.text();
  return msg;
}

}  // namespace ltd
