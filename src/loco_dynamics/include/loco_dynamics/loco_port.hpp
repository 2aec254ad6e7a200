#pragma once

#include "loco_dynamics/exchange.hpp"

namespace loco {

/// The seam between train and locomotive: one locomotive, wherever it computes. The co-simulation drives N of these
/// and cannot tell whether one is an object in the same process or a node on another machine.
class LocoPort {
 public:
  virtual ~LocoPort() = default;

  /// Asks for the step force.step from the state s_k at its start (empty: equilibrium at the force's location and
  /// speed). Both stay valid and unchanged until the step is committed, i.e. until the next call.
  virtual void send(const LocoForce& force, const std::vector<double>& state) = 0;

  /// The answer to the last send(), or nullptr if it is not there yet; valid until the next send().
  virtual const LocoTraction* answer() = 0;
};

}  // namespace loco
