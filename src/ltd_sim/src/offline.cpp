#include "ltd_sim/offline.hpp"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>

#include "loco_dynamics/local_port.hpp"
#include "loco_dynamics/loco_factory.hpp"
#include "ltd_sim/cosimulation.hpp"
#include "ltd_sim/csv_file.hpp"
#include "ltd_sim/progress.hpp"
#include "ltd_sim/run_outputs.hpp"
#include "offline_arguments.hpp"
#include "rail_core/constants.hpp"
#include "rail_core/message_number.hpp"

namespace ltd {

namespace {

constexpr const char* kUsage =
    "usage: ltd_offline SCENARIO.yaml --out DIR [--set key=value[,value...]]... [--no-bag]\n"
    "  Runs a scenario without a ROS master. Several values of --set make a run each and a row each in DIR/sweep.csv.\n"
    "  exit status: 0 finished, 1 failed, 2 refused input, 3 stopped\n";

volatile std::sig_atomic_t interrupted = 0;
void onInterrupt(int) { interrupted = 1; }

/// Locomotives in this process.
struct LocalFleet {
  std::vector<std::unique_ptr<loco::LocalPort>> owned;
  std::vector<loco::LocoPort*> ports;

  explicit LocalFleet(const Scenario& scenario) {
    rail::Problems problems;
    for (const LocoUnit& unit : scenario.train.locomotives) {
      auto locomotive = loco::makeLocomotive(scenario.document, unit.key, problems);
      problems.throwIfAny();
      owned.push_back(std::make_unique<loco::LocalPort>(std::move(locomotive)));
      ports.push_back(owned.back().get());
    }
  }
};

/// One run; what it leaves is in `folder`.
struct RunResult {
  Outcome outcome;
  TrainState state;
};

RunResult runOnce(const Scenario& scenario, const std::string& folder, const BagFactory& bag_factory) {
  if (scenario.driver.external())
    throw rail::ConfigError({scenario.file + ": driver.kind = external: nobody can answer offline: run it in the graph "
                                             "(roslaunch), or give another kind"});
  LocalFleet fleet(scenario);
  RunOutputs outputs(scenario, folder);
  std::unique_ptr<RunObserver> bag = bag_factory ? bag_factory(scenario, folder) : nullptr;
  const bool terminal = isatty(STDERR_FILENO) != 0;
  ProgressMeter progress(scenario, terminal ? 0.5 : 5.0, [terminal](const Progress& p) {
    std::fprintf(stderr, terminal ? "\r%s \033[K" : "%s\n", toString(p).c_str());
  });
  std::vector<RunObserver*> observers = {&progress};
  if (bag) observers.push_back(bag.get());
  observers.push_back(&outputs);  // outcome.yaml comes last: when it is there, everything is

  Cosimulation cosimulation(scenario, fleet.ports, observers);
  cosimulation.start();
  while (!cosimulation.outcome().ended()) {
    if (interrupted != 0) {
      cosimulation.end(Outcome::Kind::kStopped, "interrupted");
      break;
    }
    cosimulation.begin();
    cosimulation.tryCommit();
  }
  if (terminal) std::fprintf(stderr, "\r\033[K");
  return {cosimulation.outcome(), cosimulation.state()};
}

void tell(const Scenario& scenario, const RunResult& run, const std::string& folder) {
  const rail::EnergyAccount& a = run.state.account;
  const double lead_v = run.state.v_mps[scenario.train.locomotives.front().vehicle];
  std::printf("%s: %s: %s\n", scenario.name.c_str(), toString(run.outcome.kind).c_str(), run.outcome.reason.c_str());
  std::printf("  time %.3f s, speed %s km/h, traction at the rail %s kWh, residual of the account %s\n",
              static_cast<double>(run.state.step) * rail::toSeconds(scenario.macro_step),
              rail::fixedNumber(lead_v * rail::kKmphPerMps, 3).c_str(),
              rail::fixedNumber(a.traction_rail / rail::kJoulesPerKilowattHour, 3).c_str(),
              rail::messageNumber(a.residualRelative()).c_str());
  for (const std::string& note : run.outcome.notes) std::printf("  note: %s\n", note.c_str());
  std::printf("  results in %s\n", folder.c_str());
}

std::vector<std::string> sweepColumns(const OfflineArguments& arguments) {
  std::vector<std::string> columns = {"run"};
  for (const auto& set : arguments.sets) columns.push_back(set.first);
  for (const char* column : {"outcome", "final_time_s", "final_location_km", "final_speed_mps", "energy_rail_train_J",
                             "energy_rim_train_J", "slip_loss_J", "coupler_loss_J", "energy_residual_relative"})
    columns.push_back(column);
  return columns;
}

std::vector<std::string> sweepRow(const std::string& name, const std::vector<rail::Override>& overrides,
                                  const Scenario& scenario, const RunResult& run) {
  std::vector<std::string> cells = {name};
  for (const rail::Override& o : overrides)
    cells.push_back(o.value.find(',') == std::string::npos ? o.value : '"' + o.value + '"');
  const std::size_t lead = scenario.train.locomotives.front().vehicle;
  const rail::EnergyAccount& a = run.state.account;
  cells.push_back(toString(run.outcome.kind));
  for (const double x : {static_cast<double>(run.state.step) * rail::toSeconds(scenario.macro_step),
                         run.state.s_m[lead] / rail::kMetresPerKilometre, run.state.v_mps[lead], a.traction_rail,
                         a.traction_rim, a.slip_loss, a.coupler_loss, a.residualRelative()})
    cells.push_back(allDigits(x));
  return cells;
}

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
    const RunResult run = runOnce(scenarios.front(), arguments.out, bag_factory);
    tell(scenarios.front(), run, arguments.out);
    return run.outcome.exitStatus();
  }
  makeDirectories(arguments.out);
  CsvFile sweep(arguments.out + "/sweep.csv", sweepColumns(arguments));
  int status = 0;
  for (std::size_t i = 0; i < scenarios.size() && interrupted == 0; ++i) {
    char name[24];
    std::snprintf(name, sizeof name, "%03zu", i + 1);
    const std::string folder = arguments.out + "/" + name;
    const RunResult run = runOnce(scenarios[i], folder, bag_factory);
    tell(scenarios[i], run, folder);
    sweep.row(sweepRow(name, combinations[i], scenarios[i], run));
    sweep.flush();
    if (status == 0) status = run.outcome.exitStatus();
  }
  std::printf("a row for each run in %s/sweep.csv\n", arguments.out.c_str());
  return status;
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
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "ltd_offline: " << error.what() << '\n';
    return 1;
  }
}

}  // namespace ltd
