#include "ltd_sim/offline.hpp"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>

#include "ltd_sim/local_fleet.hpp"
#include "ltd_sim/run_outputs.hpp"
#include "offline_arguments.hpp"
#include "offline_run.hpp"
#include "sweep.hpp"

namespace ltd {

namespace {

constexpr const char* kUsage =
    "usage: ltd_offline SCENARIO.yaml --out DIR [--set key=value[,value...]]... [--jobs N] [--no-bag]\n"
    "  Runs a scenario without a ROS master. Several values of --set make a run each and a row each in DIR/sweep.csv,\n"
    "  N of them beside each other (1).\n"
    "  exit status: 0 finished, 1 failed, 2 refused input, 3 stopped\n";

void onInterrupt(int) { interrupted = 1; }

/// All are checked before the first one runs. @throws rail::ConfigError with the problems of all of them.
std::vector<Scenario> loadAll(const std::string& file, const std::vector<std::vector<rail::Override>>& combinations) {
  std::vector<Scenario> scenarios;
  std::vector<std::string> lines;
  for (const std::vector<rail::Override>& overrides : combinations) {
    try {
      scenarios.push_back(Scenario::load(file, overrides));
    } catch (const rail::ConfigError& error) {
      for (const std::string& line : error.lines())
        if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
    }
  }
  if (!lines.empty()) throw rail::ConfigError(lines);
  return scenarios;
}

int runAll(const OfflineArguments& arguments, const BagFactory& bag_factory) {
  const std::vector<std::vector<rail::Override>> combinations = arguments.combinations();
  std::printf("%s", arguments.announcement().c_str());
  std::cerr << arguments.commaHints();
  const std::vector<Scenario> scenarios = loadAll(arguments.scenario, combinations);
  if (scenarios.size() == 1) {
    const RunResult run =
        runOnce(scenarios.front(), arguments.out, bag_factory, {threadsThatPay(scenarios.front()), "", onTerminal()});
    tell(scenarios.front(), run, arguments.out);
    return run.outcome.exitStatus();
  }
  return runSweep(arguments, combinations, scenarios, bag_factory);
}

/// What an earlier run left in the folder must not be taken for this one's. A folder that is not there stays so.
void tellRefusal(const std::string& folder, const std::string& reason) {
  if (std::filesystem::exists(folder)) writeRefusal(folder, Outcome::Kind::kRefused, reason);
}

}  // namespace

int runOffline(const std::vector<std::string>& command_line, const BagFactory& bag_factory) {
  OfflineArguments arguments;
  const std::string fault = arguments.parse(command_line);
  if (arguments.help) {
    std::printf("%s", kUsage);
    return 0;
  }
  if (!fault.empty()) {
    std::cerr << "ltd_offline: " << fault << '\n' << kUsage;
    return 2;
  }
  std::signal(SIGINT, onInterrupt);
  std::signal(SIGTERM, onInterrupt);
  try {
    if (arguments.bag && !bag_factory) std::cerr << "ltd_offline: this build has no ROS, so no bag is written\n";
    return runAll(arguments, arguments.bag ? bag_factory : BagFactory());
  } catch (const rail::ConfigError& error) {
    std::cerr << error.what() << '\n';
    tellRefusal(arguments.out, error.what());
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "ltd_offline: " << error.what() << '\n';
    return 1;
  }
}

}  // namespace ltd
