#pragma once

#include <csignal>

namespace ltd {

/// The program ltd_node: reads its private parameters, loads the scenario, runs it as LtdNode.
///   ~scenario     path of the scenario
///   ~out          folder of the results
///   ~directory    where relative paths count from (default: the working directory)
///   ~record       write a bag (default true)
///   ~hold         start held (default false)
///   ~locomotives  how many locomotives the launch starts; 0 (default) if nobody counted
///   ~set          overrides "key=value key=value" (default none)
/// Refused input is told on the console and left in out/outcome.yaml.
/// @return exit status: 0 finished, 1 failed, 2 refused input, 3 stopped
int runProgram(const volatile std::sig_atomic_t& interrupted);

}  // namespace ltd
