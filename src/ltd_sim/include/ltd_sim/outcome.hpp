#pragma once

#include <cstdint>
#include <string>

namespace ltd {

/// How a run ended.
struct Outcome {
  enum class Kind { kRunning, kFinished, kStopped, kFailed };
  Kind kind = Kind::kRunning;
  std::string reason;                 ///< in words
  std::uint64_t exchange_digest = 0;  ///< of every payload exchanged over the whole run: same number, same bits

  bool ended() const { return kind != Kind::kRunning; }
  /// Exit status of a program: finished 0, failed 1, stopped 3 (2 is for refused input).
  int exitStatus() const { return kind == Kind::kFinished ? 0 : kind == Kind::kStopped ? 3 : 1; }
};

std::string toString(Outcome::Kind kind);

}  // namespace ltd
