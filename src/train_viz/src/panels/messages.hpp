#pragma once

#include <train_msgs/Adhesion.h>
#include <train_msgs/TrainEnergy.h>
#include <train_msgs/TrainState.h>

#include "../plots/run_data.hpp"

namespace viz {

TrainSample fromMsg(const train_msgs::TrainState& msg);
EnergySample fromMsg(const train_msgs::TrainEnergy& msg);
AdhesionSample fromMsg(const train_msgs::Adhesion& msg);

}  // namespace viz
