#pragma once

#include <optional>
#include <string>
#include <vector>

namespace viz {

/// What the lock panel needs of /train/status.
struct TrainStatus {
  enum class Phase { kJoining, kHeld, kRunning, kFinished, kStopped, kFailed };
  Phase phase = Phase::kJoining;
  std::string reason;
  std::vector<std::string> notes;
  double time_s = 0.0;  ///< of simulation, since the run's start
  double place_m = 0.0;
  double real_time_factor = 0.0;
  double time_left_s = -1.0;  ///< of wall time; < 0: nobody can tell
  std::vector<bool> joined;   ///< per locomotive
};

std::string wordFor(TrainStatus::Phase phase);
bool ended(TrainStatus::Phase phase);

/// What to do where no status comes: of a bag, for instance, which has none.
inline constexpr char kNoTrain[] = "No train to hold. A bag is held by rosbag's space bar.";
/// The phase, and for how long a train that has not ended has been silent.
/// @param silence_s  wall time since the last status
std::string phaseWords(const std::optional<TrainStatus>& status, double silence_s);

/// The figures as people read them.
struct StatusWords {
  std::string time, place, real_time_factor, time_left, joined;
};
StatusWords describe(const TrainStatus& status);

/// Which commands make sense.
struct AllowedCommands {
  bool hold = false;
  bool run = false;  ///< run, step, run until
  bool pace = false, stop = false;
};
/// The train gives a sign once a second; chosen: three are missed before it counts as gone.
constexpr double kSilence_s = 3.5;
/// @param status     the last one; nothing: none has come
/// @param silence_s  wall time since then
/// @param busy       a command waits for its answer
AllowedCommands allowedCommands(const std::optional<TrainStatus>& status, double silence_s, bool busy);

}  // namespace viz
