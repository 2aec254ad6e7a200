#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ltd_sim/run_observer.hpp"

namespace ltd {

/// Makes the observer that writes a run's bag into a folder; empty in builds without ROS.
using BagFactory = std::function<std::unique_ptr<RunObserver>(const Scenario& scenario, const std::string& folder)>;

/// The program ltd_offline:
///   ltd_offline SCENARIO.yaml --out DIR [--set key=value[,value...]]... [--jobs N] [--no-bag]
/// Runs a scenario in this process, without a ROS master, and leaves the same outputs with the same bits as the graph.
/// Where --set gives several values, each combination is a run in a folder of its own (DIR/001, ...) and DIR/sweep.csv
/// has a row for each; N of them run beside each other. 3D locomotives of one run alone compute on as many processors
/// as there are. Refused input is told on standard error.
/// @return exit status: 0 finished, 1 failed, 2 refused input, 3 stopped
int runOffline(const std::vector<std::string>& arguments, const BagFactory& bag_factory);

}  // namespace ltd
