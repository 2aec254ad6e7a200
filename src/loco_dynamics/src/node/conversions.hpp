#pragma once

#include <train_msgs/JoinTrain.h>
#include <train_msgs/LocoForce.h>
#include <train_msgs/LocoTraction.h>

#include "loco_dynamics/exchange.hpp"

namespace loco {

/// Between messages and the structs of exchange.hpp, field by field: units and signs are the same on both sides.
ForceMessage fromMsg(const train_msgs::LocoForce& msg);
void toMsg(const TractionMessage& message, train_msgs::LocoTraction& msg);
train_msgs::JoinTrain::Request toMsg(const JoinRequest& request);
JoinAnswer fromMsg(const train_msgs::JoinTrain::Response& msg);

}  // namespace loco
