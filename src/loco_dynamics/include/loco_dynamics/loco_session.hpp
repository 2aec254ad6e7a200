#pragma once

#include <memory>
#include <string>
#include <vector>

#include "loco_dynamics/exchange.hpp"
#include "loco_dynamics/locomotive.hpp"

namespace loco {

/// A locomotive's side of the lock (rule 3): decides what to do with each LocoForce that arrives, in whatever order,
/// however often. Knows no transport and no clock.
///
///   step is the next one          compute it, keep the answer, answer
///   step is the one just done     the kept answer again
///   other run, epoch, incarnation drop and count
///   anything else                 NEED_STATE, and join again
class LocoSession {
 public:
  /// What came of a message.
  struct Counters {
    std::uint64_t computed = 0;
    std::uint64_t repeated = 0;
    std::uint64_t dropped = 0;
    std::uint64_t state_lost = 0;
  };

  /// Takes up the place that an accepted join gave.
  void start(std::unique_ptr<Locomotive> locomotive, const JoinAnswer& joined);

  /// The message to send back, or nullptr if none; valid until the next call.
  const TractionMessage* onForce(const ForceMessage& message);

  /// True before the first start() and after NEED_STATE: somebody must call join.
  bool needsJoin() const { return needs_join_; }
  /// Must be called when LTD was found to be another one (new epoch or run): join again.
  void leave() { needs_join_ = true; }

  const ExchangeId& id() const { return id_; }
  const Counters& counters() const { return counters_; }

 private:
  const TractionMessage* compute(const LocoForce& force);

  std::unique_ptr<Locomotive> locomotive_;
  ExchangeId id_;
  bool needs_join_ = true;
  bool answered_ = false;  ///< message_ holds the answer to next_step_ - 1
  std::uint64_t next_step_ = 0;
  std::vector<double> state_;  ///< at the start of next_step_
  std::string start_failure_;  ///< why there is none, or empty: then every step fails with it
  LocoForce last_force_;
  TractionMessage message_;
  TractionMessage need_state_;
  Counters counters_;
};

}  // namespace loco
