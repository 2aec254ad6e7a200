#include "lock_state.hpp"

#include <cmath>
#include <cstdio>

namespace viz {

namespace {

std::string format(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

/// 75 s as 1 min 15 s.
std::string duration(double seconds) {
  const long whole = std::lround(seconds);
  if (whole < 60) return std::to_string(whole) + " s";
  if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

std::string timeLeftOf(const TrainStatus& status) {
  if (ended(status.phase)) return "ended";
  return status.time_left_s < 0.0 ? "not known" : duration(status.time_left_s);
}

std::string joinedOf(const std::vector<bool>& joined) {
  std::string missing;
  std::size_t there = 0;
  for (std::size_t i = 0; i < joined.size(); ++i) {
    if (joined[i]) {
      ++there;
    } else {
      missing += (missing.empty() ? ", not " : ", ") + std::to_string(i + 1);
    }
  }
  return std::to_string(there) + " of " + std::to_string(joined.size()) + missing;
}

}  // namespace

std::string wordFor(TrainStatus::Phase phase) {
  switch (phase) {
    case TrainStatus::Phase::kJoining:
      return "waits for locomotives";
    case TrainStatus::Phase::kHeld:
      return "held";
    case TrainStatus::Phase::kRunning:
      return "runs";
    case TrainStatus::Phase::kFinished:
      return "finished";
    case TrainStatus::Phase::kStopped:
      return "stopped";
    case TrainStatus::Phase::kFailed:
      return "failed";
  }
  return "in a phase that this panel does not know";
}

bool ended(TrainStatus::Phase phase) {
  using Phase = TrainStatus::Phase;
  return phase != Phase::kJoining && phase != Phase::kHeld && phase != Phase::kRunning;
}

std::string phaseWords(const std::optional<TrainStatus>& status, double silence_s) {
  if (!status) return "nothing heard of it";
  const bool missing = silence_s > kSilence_s && !ended(status->phase);
  return wordFor(status->phase) + (missing ? format(" (silent for %.0f s)", silence_s) : "");
}

StatusWords describe(const TrainStatus& status) {
  return {format("%.3f s", status.time_s), format("%.4f km", 1e-3 * status.place_m),
          format("%.1f times real time", status.real_time_factor), timeLeftOf(status), joinedOf(status.joined)};
}

AllowedCommands allowedCommands(const std::optional<TrainStatus>& status, double silence_s, bool busy) {
  AllowedCommands allowed;
  if (!status || busy || silence_s > kSilence_s) return allowed;
  if (ended(status->phase)) return allowed;
  allowed.hold = status->phase != TrainStatus::Phase::kHeld;
  allowed.run = allowed.pace = allowed.stop = true;
  return allowed;
}

}  // namespace viz
