#pragma once

#include <cstdint>
#include <string>

#include "ltd_sim/driver_command.hpp"

namespace ltd {

/// How often and how far a run was above the line's speed limit, whoever drives. Copyable, part of the train's state.
struct LimitWatch {
  /// So much above the limit is not told: what a speedometer shows no more than a driver sees. Chosen.
  static constexpr double kTolerance_kmph = 0.5;

  std::uint64_t times = 0;  ///< that the train went above it
  bool above = false;       ///< now
  double excess_mps = 0.0;  ///< the largest
  double location_m = 0.0;  ///< there: of the leading locomotive
  double speed_mps = 0.0;   ///< there
  double limit_mps = 0.0;   ///< there: the lowest under the train

  /// Looks at one step.
  void look(const DriverView& view);

  /// "speed limit exceeded 2 times, worst at 12.345 km: 31.9 km/h where 25.0 are allowed"; empty if it never was.
  std::string note() const;
};

}  // namespace ltd
