#pragma once

#include "ltd_sim/scenario.hpp"
#include "scenario_places.hpp"

namespace ltd {

/// Reads and says whether nothing was wrong: only what is known may be compared with something else, or a fault would
/// accuse what is sound beside it.
template <typename Read>
bool isSound(const rail::Problems& problems, Read read) {
  const std::size_t before = problems.count();
  read();
  return problems.count() == before;
}

RunLimits readRun(rail::YamlReader reader);
void readSteps(rail::YamlReader reader, Scenario& scenario);
LockLimits readLock(rail::YamlReader reader);
OutputOptions readOutput(rail::YamlReader reader, const Bounds& bounds, rail::Nanoseconds macro_step, bool step_known);

}  // namespace ltd
