#pragma once

#include <csignal>
#include <string>

#include "ltd_sim/offline.hpp"
#include "ltd_sim/outcome.hpp"
#include "ltd_sim/train_dynamics.hpp"

namespace ltd {

/// Set by Ctrl-C and SIGTERM: runs under way stop.
extern volatile std::sig_atomic_t interrupted;

/// What a run ended with.
struct RunResult {
  Outcome outcome;
  TrainState state;
};

/// How a run is done beside others.
struct RunManner {
  int threads = 1;        ///< for its locomotives
  std::string label;      ///< stands before its progress: "003 of 12: "
  bool rewrites = false;  ///< progress stays in one line of the terminal
};

/// Runs a scenario; what it leaves is in `folder`. Progress goes to standard error.
/// @throws rail::ConfigError for what only the graph can run; std::runtime_error if files cannot be written
RunResult runOnce(const Scenario& scenario, const std::string& folder, const BagFactory& bag_factory,
                  const RunManner& manner);

/// Tells on standard output how it ended.
void tell(const Scenario& scenario, const RunResult& run, const std::string& folder);

/// True if progress can be rewritten in place.
bool onTerminal();

}  // namespace ltd
