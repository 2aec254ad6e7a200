#include "loco_dynamics/loco_session.hpp"

#include <utility>

namespace loco {

void LocoSession::start(std::unique_ptr<Locomotive> locomotive, const JoinAnswer& joined) {
  locomotive_ = std::move(locomotive);
  id_ = joined.id;
  next_step_ = joined.step;
  LocoStart start{joined.state, {}};
  if (joined.state.empty()) start = locomotive_->equilibriumState(joined.location_m, joined.speed_mps);
  state_ = std::move(start.state);
  start_failure_ = std::move(start.failure);
  answered_ = false;
  needs_join_ = false;
  message_.id = id_;
  need_state_.id = id_;
  need_state_.kind = TractionMessage::Kind::kNeedState;
}

const TractionMessage* LocoSession::onForce(const ForceMessage& message) {
  const bool mine = !needs_join_ && message.id.run_id == id_.run_id && message.id.epoch == id_.epoch &&
                    message.id.incarnation == id_.incarnation && message.id.locomotive == id_.locomotive;
  if (!mine || !allFinite(message.force)) {
    ++counters_.dropped;
    return nullptr;
  }
  if (message.force.step == next_step_) return compute(message.force);
  if (answered_ && message.force.step + 1 == next_step_) {
    if (samePayload(message.force, last_force_)) {
      ++counters_.repeated;
      return &message_;
    }
    // The same step with other forces: what this locomotive did is not what LTD asks now.
  }
  ++counters_.state_lost;
  needs_join_ = true;
  need_state_.traction.step = message.force.step;
  return &need_state_;
}

const TractionMessage* LocoSession::compute(const LocoForce& force) {
  if (start_failure_.empty()) {
    locomotive_->step(state_, force, message_.traction);
  } else {
    message_.traction = failedAnswer(force, start_failure_);
  }
  message_.kind = message_.traction.failure.empty() ? TractionMessage::Kind::kAnswer : TractionMessage::Kind::kFailed;
  state_ = message_.traction.state;
  last_force_ = force;
  next_step_ = force.step + 1;
  answered_ = true;
  ++counters_.computed;
  return &message_;
}

}  // namespace loco
