#pragma once

#include <train_msgs/DriverCommand.h>
#include <train_msgs/DriverView.h>
#include <train_msgs/RunConfiguration.h>
#include <train_msgs/TrainEnergy.h>
#include <train_msgs/TrainState.h>

#include "loco_dynamics/node/conversions.hpp"
#include "ltd_sim/scenario.hpp"
#include "ltd_sim/train_dynamics.hpp"

namespace ltd {

using loco::fromMsg;
using loco::toMsg;
using loco::toStamp;

/// Meaning of a bag's topics and fields; counts up when one changes.
inline constexpr std::uint32_t kBagFormatVersion = 4;

/// Telemetry of the train and its description, field by field. The messages of the lock:
/// loco_dynamics/node/conversions.hpp.
void toMsg(const Scenario& scenario, const TrainState& state, const TrainForces& forces, train_msgs::TrainState& msg);
/// What acts before the driver has been asked: no notch, no brake notch.
TrainForces forcesAtStart(const Scenario& scenario, const TrainState& state);
void toMsg(const Scenario& scenario, const TrainState& state, train_msgs::TrainEnergy& msg);
train_msgs::RunConfiguration toMsg(const Scenario& scenario, std::uint64_t run_id);

/// What a driver in another program is asked.
void toMsg(std::uint64_t run_id, std::uint64_t step, const DriverView& view, train_msgs::DriverView& msg);
/// What he answers.
DriverCommand fromMsg(const train_msgs::DriverCommand& msg);

}  // namespace ltd
