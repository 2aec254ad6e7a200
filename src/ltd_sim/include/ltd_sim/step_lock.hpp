#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "loco_dynamics/loco_port.hpp"

namespace ltd {

/// LTD's side of the lock: stop-and-wait with every locomotive over a transport that may lose, double and reorder.
/// It sends F_k and sends it again until the answer is there, takes the first answer to the step under way, and gives
/// joining locomotives the state they need. Knows no transport and no clock: messages go in and out by calls, wall time
/// is an argument. Not thread-safe.
class StepLock {
 public:
  struct Settings {
    loco::ExchangeId id;  ///< run_id and epoch
    std::string build_id;
    std::uint64_t arithmetic_fingerprint = 0;
    std::string configuration;             ///< resolved scenario
    std::vector<std::string> loco_keys;    ///< per locomotive: where it stands in the configuration
    std::vector<std::size_t> state_sizes;  ///< per locomotive: length of its model's state
    rail::Nanoseconds step_length = 0;
    double resend_interval_s = 0.1;
    double join_deadline_s = 60.0;
    double answer_deadline_s = 60.0;
    double heartbeat_deadline_s = 60.0;  ///< told to the locomotives
  };
  /// Counted over all locomotives.
  struct Counters {
    std::uint64_t resent = 0;    ///< forces sent again for want of an answer
    std::uint64_t repeated = 0;  ///< answers that came more than once
    std::uint64_t refused = 0;   ///< messages whose ids, length or numbers did not fit
    std::string last_refused;    ///< why
  };
  /// Sends a message to locomotive `index` (from 0); it may be lost.
  using Send = std::function<void(std::size_t index, const loco::ForceMessage& message)>;
  /// True while the node that holds slot `index` is connected.
  using Connected = std::function<bool(std::size_t index)>;

  StepLock(Settings settings, Send send, Connected connected);
  ~StepLock();

  /// The seam to the co-simulation for locomotive `index`, from 0.
  loco::LocoPort& port(std::size_t index);
  std::size_t size() const;

  /// Where the train's vehicles of the locomotives are at the start of the run, for their first join.
  void setStart(std::size_t index, double location_m, double speed_mps);

  /// Answers a join at once. A slot is given when it is empty, its node has the same name, is no longer connected, or
  /// has kept the run waiting for half of the answer deadline.
  loco::JoinAnswer onJoin(const loco::JoinRequest& request, double now_s);

  /// Takes, counts or refuses a message.
  void onTraction(const loco::TractionMessage& message);

  /// Sends again what was not answered and watches the deadlines. Call at least every resend interval.
  void tick(double now_s);

  bool allJoined() const;
  bool joined(std::size_t index) const;
  std::uint32_t incarnation(std::size_t index) const;
  /// Locomotives that hold the run up and since when, in words: "loco_3 has not joined"; empty if nobody does.
  /// `patience_s`: those who keep it waiting for less are not named.
  std::string waitsFor(double now_s, double patience_s) const;
  /// Empty, or why the run cannot go on (a deadline passed, an answer was not deterministic, a model failed).
  const std::string& fault() const { return fault_; }
  const Counters& counters() const { return counters_; }

 private:
  class Slot;
  std::string refusalOf(const loco::JoinRequest& request, double now_s, bool& wait) const;
  std::string refusalOf(const loco::TractionMessage& message) const;
  void refuse(const std::string& why);
  void fail(const std::string& why);

  Settings settings_;
  Send send_;
  Connected connected_;
  std::vector<std::unique_ptr<Slot>> slots_;
  std::uint32_t last_incarnation_ = 0;
  double started_s_ = -1.0;  ///< wall time of the first tick
  std::string fault_;
  Counters counters_;
};

}  // namespace ltd
