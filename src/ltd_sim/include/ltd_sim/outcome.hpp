#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ltd {

/// How a run ended.
struct Outcome {
  enum class Kind { kRunning, kFinished, kStopped, kFailed, kRefused };
  Kind kind = Kind::kRunning;
  std::string reason;                 ///< in words
  std::vector<std::string> notes;     ///< what happened on the way: Cosimulation::notes()
  std::uint64_t exchange_digest = 0;  ///< of every payload exchanged over the whole run: same number, same bits

  bool ended() const { return kind != Kind::kRunning; }
  /// Exit status of a program: finished 0, failed 1, input refused 2, stopped 3.
  int exitStatus() const;
};

std::string toString(Outcome::Kind kind);

}  // namespace ltd
