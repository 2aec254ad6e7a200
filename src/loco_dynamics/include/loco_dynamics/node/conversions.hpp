#pragma once

#include <ros/time.h>
#include <train_msgs/Adhesion.h>
#include <train_msgs/JoinTrain.h>
#include <train_msgs/LocoForce.h>
#include <train_msgs/LocoTraction.h>

#include <vector>

#include "loco_dynamics/exchange.hpp"

namespace loco {

/// Stamp of simulation time t: a run starts at 1 s, because rosbag refuses the stamp 0.
ros::Time toStamp(rail::Nanoseconds t);

// Between messages and the structs of exchange.hpp, field by field: units and signs are the same on both sides.

void toMsg(const ForceMessage& message, train_msgs::LocoForce& msg);
ForceMessage fromMsg(const train_msgs::LocoForce& msg);

void toMsg(const TractionMessage& message, train_msgs::LocoTraction& msg);
/// Of a committed answer.
void toMsg(const ExchangeId& id, const LocoTraction& traction, train_msgs::LocoTraction& msg);
TractionMessage fromMsg(const train_msgs::LocoTraction& msg);

/// Of a committed answer at simulation time t.
void toMsg(rail::Nanoseconds t, const LocoTraction& traction, train_msgs::Adhesion& msg);

train_msgs::JoinTrain::Request toMsg(const JoinRequest& request);
JoinRequest fromMsg(const train_msgs::JoinTrain::Request& msg);
void toMsg(const JoinAnswer& answer, train_msgs::JoinTrain::Response& msg);
JoinAnswer fromMsg(const train_msgs::JoinTrain::Response& msg);

}  // namespace loco
