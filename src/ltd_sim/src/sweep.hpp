#pragma once

#include <vector>

#include "ltd_sim/offline.hpp"
#include "ltd_sim/scenario.hpp"
#include "offline_arguments.hpp"

namespace ltd {

/// Runs all combinations of a sweep, `arguments.jobs` beside each other, each into a folder of its own, and writes
/// sweep.csv: a row each in their order, as soon as all before it have ended.
/// @return exit status of the first run that did not finish, or 0
int runSweep(const OfflineArguments& arguments, const std::vector<std::vector<rail::Override>>& combinations,
             const std::vector<Scenario>& scenarios, const BagFactory& bag_factory);

}  // namespace ltd
