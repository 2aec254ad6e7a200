#pragma once

#include <string>
#include <vector>

#include "loco_dynamics/profile/wheel_rail_geometry.hpp"

namespace loco {

/// The command line of wheel_rail_contact.
struct WheelRailContactArguments {
  std::string wheel = "S1002";  ///< or a file
  std::string rail = "UIC60";
  WheelRailDimensions dimensions;
  double load_N = 0.0;
  double yaw_mrad = 0.0;  ///< + nose right
  double friction = 0.3;
  std::vector<double> lateral_mm;  ///< + right
  std::string sections_file;       ///< where to write the cross-sections; empty: nowhere
  std::string wheel_copy;          ///< where to write the wheel's points
  std::string rail_copy;
  bool contacts = true;  ///< false: points are to be written, nothing else
  bool help = false;

  /// @return empty, or what is wrong with the command line
  std::string parse(const std::vector<std::string>& arguments);

 private:
  std::string take(const std::string& option, const std::string& value);
};

/// What --help prints.
extern const char* const kWheelRailContactHelp;

}  // namespace loco
