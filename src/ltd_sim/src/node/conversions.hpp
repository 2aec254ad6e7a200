#pragma once

#include <ros/time.h>
#include <train_msgs/JoinTrain.h>
#include <train_msgs/LocoForce.h>
#include <train_msgs/LocoTraction.h>
#include <train_msgs/RunConfiguration.h>
#include <train_msgs/TrainEnergy.h>
#include <train_msgs/TrainState.h>

#include "loco_dynamics/exchange.hpp"
#include "ltd_sim/scenario.hpp"
#include "ltd_sim/train_dynamics.hpp"

namespace ltd {

/// Meaning of a bag's topics and fields; counts up when one changes.
inline constexpr std::uint32_t kBagFormatVersion = 1;

/// Stamp of simulation time t: a run starts at 1 s, because rosbag refuses the stamp 0.
ros::Time toStamp(rail::Nanoseconds t);

/// Between messages and the program's structs, field by field: units and signs are the same on both sides.
void toMsg(const loco::ForceMessage& message, train_msgs::LocoForce& msg);
void toMsg(const loco::ExchangeId& id, const loco::LocoTraction& traction, train_msgs::LocoTraction& msg);
loco::TractionMessage fromMsg(const train_msgs::LocoTraction& msg);
loco::JoinRequest fromMsg(const train_msgs::JoinTrain::Request& msg);
void toMsg(const loco::JoinAnswer& answer, train_msgs::JoinTrain::Response& msg);
void toMsg(const Scenario& scenario, const TrainState& state, const TrainForces& forces, train_msgs::TrainState& msg);
void toMsg(const Scenario& scenario, const TrainState& state, train_msgs::TrainEnergy& msg);
train_msgs::RunConfiguration toMsg(const Scenario& scenario, std::uint64_t run_id);

}  // namespace ltd
