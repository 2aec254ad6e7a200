#pragma once

#include <string>

#include "rail_core/problems.hpp"

namespace ltd {

/// Adds a problem if there is no file `path`, naming the scenarios in its folder: a mistyped `model:=4d` of a launch
/// is answered with what there is. A scenario is a .yaml file; the names are sorted.
void checkScenarioExists(const std::string& path, rail::Problems& problems);

}  // namespace ltd
