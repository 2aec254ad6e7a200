#pragma once

#include <cstdint>
#include <string>

#include "ltd_sim/driver_command.hpp"

namespace ltd {

/// The seam to a driver in another program: asked for a command at some steps, never waited for in here.
class DriverPort {
 public:
  virtual ~DriverPort() = default;
  /// Asks for the command that holds from step `step` on.
  virtual void ask(std::uint64_t step, const DriverView& view) = 0;
  /// The answer to the question asked last; nullptr as long as there is none.
  virtual const DriverCommand* answer() = 0;
  /// The answer cannot be obeyed and counts as none.
  virtual void refuse(const std::string& why) = 0;
  /// Wall time that the answer asked for may take [s]; the first one's may differ.
  virtual double deadline_s() const = 0;
  /// True if this deadline has passed.
  virtual bool silent() = 0;
};

}  // namespace ltd
