#pragma once

#include <optional>
#include <string>

#include "ltd_sim/outcome.hpp"
#include "ltd_sim/scenario.hpp"
#include "ltd_sim/train_dynamics.hpp"

namespace ltd {

/// How a run ends, and why.
struct Ending {
  Outcome::Kind kind = Outcome::Kind::kFailed;
  std::string reason;
};

/// Whether the run ends with the step just committed: at its end, off the track, too fast, at rest, stalled; call it
/// once a step. Notes in the state since when the train stands or crawls.
/// @param silence  since when the driver has been silent, in words; empty: he has not
std::optional<Ending> findEnding(const Scenario& scenario, const TrainDynamics& dynamics, const TrainForces& forces,
                                 const std::string& silence, TrainState& state);

}  // namespace ltd
