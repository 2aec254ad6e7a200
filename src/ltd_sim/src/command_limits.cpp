#include "ltd_sim/command_limits.hpp"

#include "driver_sources.hpp"
#include "rail_core/message_number.hpp"

namespace ltd {

namespace {

std::string fault(const std::string& what, const std::string& value, const std::string& rule) {
  return what + " = " + value + ": must be " + rule;
}

/// Fields have the names that they have in the message DriverCommand.
std::string refuseNotches(const DriverCommand& c, const DriverSchedule::Largest& largest) {
  const std::string brake_notch = std::to_string(c.brake_notch);
  if (c.notch < 0 || c.notch > largest.notch)
    return fault("notch", std::to_string(c.notch), "0 to " + std::to_string(largest.notch));
  if (c.brake_notch < 0 || c.brake_notch > largest.brake_notch)
    return fault("brake_notch", brake_notch, "0 to " + std::to_string(largest.brake_notch));
  if (c.notch > 0 && c.brake_notch > 0)
    return fault("brake_notch", brake_notch, "0 beside a notch: never both at once");
  return {};
}

std::string refuseAir(const DriverCommand& c, bool air_brake) {
  const std::string pipe = rail::messageNumber(c.pipe_pressure_Pa);
  const std::string independent = rail::messageNumber(c.independent_brake);
  const std::string charged = rail::messageNumber(kChargedPipe_Pa) + " Pa";
  if (!(c.pipe_pressure_Pa >= 0.0 && c.pipe_pressure_Pa <= kChargedPipe_Pa))
    return fault("pipe_pressure", pipe, "0 to " + charged);
  if (!(c.independent_brake >= 0.0 && c.independent_brake <= 1.0))
    return fault("independent_brake", independent, "0 to 1");
  if (air_brake) return {};
  if (c.pipe_pressure_Pa < kChargedPipe_Pa) return fault("pipe_pressure", pipe, charged + ", " + kNoAirBrake);
  if (c.independent_brake > 0.0) return fault("independent_brake", independent, std::string("0, ") + kNoAirBrake);
  if (c.emergency) return fault("emergency", "true", std::string("false, ") + kNoAirBrake);
  return {};
}

}  // namespace

std::string refuseCommand(const DriverCommand& command, const DriverSchedule::Largest& largest) {
  std::string found = refuseNotches(command, largest);
  if (found.empty()) found = refuseAir(command, largest.air_brake);
  if (found.empty() && command.sanding && !largest.sand)
    found = fault("sanding", "true", "false: the scenario has no sanded_adhesion");
  return found;
}

}  // namespace ltd
