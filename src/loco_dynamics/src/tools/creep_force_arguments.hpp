#pragma once

#include <optional>
#include <string>
#include <vector>

#include "loco_dynamics/contact/creep_law.hpp"

namespace loco {

/// The command line of creep_force.
struct CreepForceArguments {
  CreepMethod method = CreepMethod::kModfastsim;
  FlexibilityRule flexibility = FlexibilityRule::kBlended;
  int cells = 20;
  int strips = 20;
  std::optional<double> k_A;  ///< for all rows; otherwise columns kA, kS
  std::optional<double> k_S;
  bool help = false;

  /// @return empty, or what is wrong with the command line
  std::string parse(const std::vector<std::string>& arguments);

 private:
  std::string checkTogether() const;
  bool grid_given = false;
  bool flexibility_given = false;
};

/// What --help prints.
extern const char* const kCreepForceHelp;

}  // namespace loco
