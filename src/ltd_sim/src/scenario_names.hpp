#pragma once

#include <string>

#include "rail_core/problems.hpp"

namespace ltd {

/// Adds a problem if there is no file `path`, naming the scenarios in its folder or, if it has none, in
/// config/scenarios: a mistyped name or `model:=4d` of a launch is answered with what there is, the likeliest first.
void checkScenarioExists(const std::string& path, rail::Problems& problems);

}  // namespace ltd
