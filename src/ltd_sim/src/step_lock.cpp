#include "ltd_sim/step_lock.hpp"

#include <cstdio>
#include <utility>

namespace ltd {

namespace {

std::string nameOf(std::size_t index) { return "loco_" + std::to_string(index + 1); }

std::string seconds(double s) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f s", s);
  return text;
}

}  // namespace

/// One locomotive's place in the train, as the port through which the co-simulation drives it.
class StepLock::Slot : public loco::LocoPort {
 public:
  Slot(StepLock& lock, std::size_t index) : lock_(lock), index_(index) {
    message_.id = lock.settings_.id;
    message_.id.locomotive = static_cast<std::uint32_t>(index + 1);
  }

  void send(const loco::LocoForce& force, const std::vector<double>& state) override {
    if (answered_) {
      committed_step_ = answer_.step;
      committed_digest_ = loco::payloadDigest(answer_);
    }
    message_.force = force;
    state_ = &state;
    location_m_ = force.location_m;
    speed_mps_ = force.speed_mps;
    asked_ = true;
    answered_ = false;
    asked_since_s_ = -1.0;
    send_at_once_ = false;
    if (joined()) lock_.send_(index_, message_);
  }

  const loco::LocoTraction* answer() override { return answered_ ? &answer_ : nullptr; }

  bool joined() const { return message_.id.incarnation > 0 && !must_join_again_; }
  bool waiting() const { return asked_ && !answered_; }
  /// Wall time that the step under way has waited, counted from the first tick after it was sent.
  double waited_s(double now_s) const { return asked_since_s_ < 0.0 ? 0.0 : now_s - asked_since_s_; }

  StepLock& lock_;
  std::size_t index_;
  loco::ForceMessage message_;                  ///< ids and the force of the step under way
  const std::vector<double>* state_ = nullptr;  ///< s_k, the co-simulation's
  loco::LocoTraction answer_;                   ///< to the step under way, if answered_
  bool asked_ = false, answered_ = false;
  bool must_join_again_ = false;
  bool send_at_once_ = false;
  std::uint64_t committed_step_ = ~std::uint64_t{0}, committed_digest_ = 0;
  std::string node_;
  std::string refused_;  ///< why somebody may not have this place, for as long as nobody has it
  double location_m_ = 0.0, speed_mps_ = 0.0;
  double asked_since_s_ = -1.0, sent_s_ = -1.0;
};

StepLock::StepLock(Settings settings, Send send, Connected connected)
    : settings_(std::move(settings)), send_(std::move(send)), connected_(std::move(connected)) {
  for (std::size_t i = 0; i < settings_.loco_keys.size(); ++i) slots_.push_back(std::make_unique<Slot>(*this, i));
}

StepLock::~StepLock() = default;

loco::LocoPort& StepLock::port(std::size_t index) { return *slots_[index]; }
std::size_t StepLock::size() const { return slots_.size(); }
bool StepLock::joined(std::size_t index) const { return slots_[index]->joined(); }
std::uint32_t StepLock::incarnation(std::size_t index) const { return slots_[index]->message_.id.incarnation; }

void StepLock::setStart(std::size_t index, double location_m, double speed_mps) {
  slots_[index]->location_m_ = location_m;
  slots_[index]->speed_mps_ = speed_mps;
}

bool StepLock::allJoined() const {
  for (const auto& slot : slots_) {
    if (!slot->joined()) return false;
  }
  return true;
}

std::string StepLock::refusalOf(const loco::JoinRequest& request, double now_s, bool& wait) const {
  if (request.protocol_version != loco::kProtocolVersion)
    return "protocol version " + std::to_string(request.protocol_version) + ", the train has " +
           std::to_string(loco::kProtocolVersion) + ": build both from the same source";
  if (request.build_id != settings_.build_id)
    return "build " + request.build_id + ", the train has " + settings_.build_id + ": build both from the same source";
  if (request.arithmetic_fingerprint != settings_.arithmetic_fingerprint)
    return "its processor and libm compute other last digits than the train's: use machines of one processor family";
  if (request.locomotive < 1 || request.locomotive > slots_.size())
    return "there is no loco_" + std::to_string(request.locomotive) + " in this train, it has " +
           std::to_string(slots_.size()) + " locomotives";
  const Slot& slot = *slots_[request.locomotive - 1];
  const bool gave_up = slot.waiting() && slot.waited_s(now_s) > 0.5 * settings_.answer_deadline_s;
  if (!slot.joined() || slot.node_ == request.node || gave_up || !connected_(request.locomotive - 1)) return {};
  wait = true;
  return nameOf(request.locomotive - 1) + " is taken by " + slot.node_;
}

loco::JoinAnswer StepLock::onJoin(const loco::JoinRequest& request, double now_s) {
  loco::JoinAnswer answer;
  answer.reason = refusalOf(request, now_s, answer.wait);
  if (!answer.reason.empty()) {
    if (request.locomotive >= 1 && request.locomotive <= slots_.size() && !answer.wait)
      slots_[request.locomotive - 1]->refused_ = " (" + request.node + " was refused: " + answer.reason + ")";
    return answer;
  }
  Slot& slot = *slots_[request.locomotive - 1];
  slot.refused_.clear();
  slot.node_ = request.node;
  slot.must_join_again_ = false;
  slot.message_.id.incarnation = ++last_incarnation_;
  slot.send_at_once_ = true;  // the step under way, with the next tick

  answer.accepted = true;
  answer.id = slot.message_.id;
  answer.location_m = slot.location_m_;
  answer.speed_mps = slot.speed_mps_;
  answer.step_length = settings_.step_length;
  answer.heartbeat_deadline_s = settings_.heartbeat_deadline_s;
  answer.configuration = settings_.configuration;
  answer.locomotive_key = settings_.loco_keys[request.locomotive - 1];
  if (slot.answered_) {  // its predecessor has done the step under way: the newcomer starts with the next one
    answer.step = slot.message_.force.step + 1;
    answer.state = slot.answer_.state;
  } else if (slot.asked_) {
    answer.step = slot.message_.force.step;
    answer.state = *slot.state_;
  }
  return answer;
}

std::string StepLock::refusalOf(const loco::TractionMessage& message) const {
  if (message.id.locomotive < 1 || message.id.locomotive > slots_.size()) return "no such locomotive";
  const Slot& slot = *slots_[message.id.locomotive - 1];
  if (message.id.run_id != settings_.id.run_id) return "another run";
  if (message.id.epoch != settings_.id.epoch) return "another epoch";
  if (message.id.incarnation != slot.message_.id.incarnation) return "another incarnation";
  if (!slot.asked_ || message.traction.step > slot.message_.force.step) return "a step that was not asked for";
  if (message.kind != loco::TractionMessage::Kind::kAnswer) return {};
  if (!loco::allFinite(message.traction)) return "not a number";
  if (message.traction.state.size() != settings_.state_sizes[slot.index_]) return "a state of another length";
  return {};
}

void StepLock::onTraction(const loco::TractionMessage& message) {
  const std::string why = refusalOf(message);
  if (!why.empty()) {
    refuse("loco_" + std::to_string(message.id.locomotive) + ": " + why);
    return;
  }
  Slot& slot = *slots_[message.id.locomotive - 1];
  if (message.kind == loco::TractionMessage::Kind::kNeedState) {
    slot.must_join_again_ = true;
    return;
  }
  const bool under_way = message.traction.step == slot.message_.force.step;
  if (under_way && !slot.answered_) {
    slot.answer_ = message.traction;
    slot.answered_ = true;
    return;
  }
  ++counters_.repeated;  // an echo, which must say the same; of older steps than the last nothing is kept
  const std::uint64_t digest = loco::payloadDigest(message.traction);
  const bool same = under_way ? digest == loco::payloadDigest(slot.answer_)
                              : message.traction.step != slot.committed_step_ || digest == slot.committed_digest_;
  if (!same)
    fail(nameOf(slot.index_) + " is not deterministic: two different answers to step " +
         std::to_string(message.traction.step));
}

void StepLock::tick(double now_s) {
  if (started_s_ < 0.0) started_s_ = now_s;
  for (const auto& slot : slots_) {
    if (!slot->waiting()) {
      if (!slot->joined() && !slot->asked_ && now_s - started_s_ > settings_.join_deadline_s)
        fail(nameOf(slot->index_) + " has not joined within " + seconds(settings_.join_deadline_s) + slot->refused_);
      continue;
    }
    if (slot->asked_since_s_ < 0.0) slot->asked_since_s_ = slot->sent_s_ = now_s;
    if (slot->waited_s(now_s) > settings_.answer_deadline_s)
      fail(nameOf(slot->index_) + (slot->joined() ? " has not answered" : " has not joined again for") + " step " +
           std::to_string(slot->message_.force.step) + " within " + seconds(settings_.answer_deadline_s));
    if (slot->joined() && (slot->send_at_once_ || now_s - slot->sent_s_ >= settings_.resend_interval_s)) {
      slot->sent_s_ = now_s;
      slot->send_at_once_ = false;
      ++counters_.resent;
      send_(slot->index_, slot->message_);
    }
  }
}

std::string StepLock::waitsFor(double now_s, double patience_s) const {
  std::string names;
  for (const auto& slot : slots_) {
    std::string what;
    if (slot->waiting() && slot->waited_s(now_s) >= patience_s) {
      what = (slot->joined() ? " has not answered step " : " has left in step ") +
             std::to_string(slot->message_.force.step) + " for " + seconds(slot->waited_s(now_s));
    } else if (!slot->joined() && !slot->asked_ && started_s_ >= 0.0 && now_s - started_s_ >= patience_s) {
      what = " has not joined" + slot->refused_;
    }
    if (!what.empty()) names += (names.empty() ? "" : ", ") + nameOf(slot->index_) + what;
  }
  return names;
}

void StepLock::refuse(const std::string& why) {
  ++counters_.refused;
  counters_.last_refused = why;
}

void StepLock::fail(const std::string& why) {
  if (fault_.empty()) fault_ = why;
}

}  // namespace ltd
