#pragma once

#include <string>

#include "ltd_sim/driver_schedule.hpp"

namespace ltd {

/// The one place that says what may be commanded while a run goes on.
/// @return "" if the command can be obeyed, otherwise `what = value: rule`
std::string refuseCommand(const DriverCommand& command, const DriverSchedule::Largest& largest);

}  // namespace ltd
