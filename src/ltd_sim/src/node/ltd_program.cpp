#include "ltd_program.hpp"

#include <ros/ros.h>

#include <exception>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "ltd_node.hpp"

namespace ltd {

namespace {

/// A parameter of the type of `fallback`. @throws if it is there with another type: nothing is taken for something
/// else.
template <typename Value>
Value readParameter(const ros::NodeHandle& node, const std::string& name, Value fallback, const std::string& rule) {
  Value value = fallback;
  if (node.hasParam(name) && !node.getParam(name, value)) throw std::runtime_error("ltd: ~" + name + ": " + rule);
  return value;
}

std::string required(const ros::NodeHandle& node, const std::string& name, const std::string& what) {
  const std::string value = readParameter<std::string>(node, name, "", "must be text: " + what);
  if (value.empty()) throw std::runtime_error("ltd: ~" + name + ": is missing: " + what);
  return value;
}

/// Nodes of a launch start in ROS_HOME; paths that a user types count from where he called roslaunch.
void changeDirectory(const std::string& directory) {
  if (!directory.empty()) std::filesystem::current_path(directory);
}

std::vector<rail::Override> readOverrides(const std::string& text) {
  std::vector<rail::Override> overrides;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos || equals == 0)
      throw std::runtime_error("ltd: ~set = " + word + ": must read key=value, several apart by spaces");
    overrides.push_back({word.substr(0, equals), word.substr(equals + 1)});
  }
  return overrides;
}

void checkCount(int launched, const Scenario& scenario) {
  const int wanted = static_cast<int>(scenario.train.locomotives.size());
  if (launched == 0 || launched == wanted) return;
  throw std::runtime_error(scenario.file + ": train.groups: has " + std::to_string(wanted) +
                           " locomotives, the launch starts " + std::to_string(launched) +
                           ": add locomotives:=" + std::to_string(wanted) + " to the roslaunch command");
}

/// A run that never started, or broke off (a full disk, say), leaves its reason where scripts look for it.
int leaveReason(const std::string& out, const std::string& reason, int status) {
  ROS_FATAL("%s", reason.c_str());
  if (!out.empty()) {
    try {
      writeRefusal(out, status == 2 ? Outcome::Kind::kRefused : Outcome::Kind::kFailed, reason);
    } catch (const std::exception& error) {
      ROS_FATAL("%s", error.what());
    }
  }
  return status;
}

}  // namespace

int runProgram(const volatile std::sig_atomic_t& interrupted) {
  const ros::NodeHandle parameters("~");
  LtdNode::Options options;
  Scenario scenario;
  try {
    changeDirectory(readParameter<std::string>(parameters, "directory", "", "must be a path"));
    options.out = required(parameters, "out", "folder of the results");
    options.record = readParameter(parameters, "record", true, "must be true or false");
    options.hold = readParameter(parameters, "hold", false, "must be true or false");
    options.keep = readParameter(parameters, "keep", false, "must be true or false");
    const std::string file = required(parameters, "scenario", "path of the scenario");
    scenario = Scenario::load(file, readOverrides(readParameter<std::string>(parameters, "set", "", "must be text")));
    checkCount(readParameter(parameters, "locomotives", 0, "must be a whole number"), scenario);
  } catch (const std::exception& error) {
    return leaveReason(options.out, error.what(), 2);
  }
  try {
    LtdNode node(scenario, options);
    return node.run(interrupted);
  } catch (const std::exception& error) {
    return leaveReason(options.out, error.what(), 1);
  }
}

}  // namespace ltd
