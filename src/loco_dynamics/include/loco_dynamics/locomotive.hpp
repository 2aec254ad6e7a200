#pragma once

#include <string>
#include <vector>

#include "loco_dynamics/exchange.hpp"

namespace loco {

/// Where a body stands, in the track frame T at its own chainage (x forward, y left, z up, origin between the rail
/// tops).
struct BodyPose {
  std::string name;         ///< in words that make a tf frame: car_body, bogie_frame_1, wheelset_1 ...
  double location_m = 0.0;  ///< chainage of its CoG
  double y_m = 0.0, z_m = 0.0;
  double roll_rad = 0.0, pitch_rad = 0.0, yaw_rad = 0.0;  ///< small but a wheelset's pitch, which is its spin angle
};

/// Where a locomotive starts, or why it cannot.
struct LocoStart {
  std::vector<double> state;
  std::string failure;  ///< empty, or why nothing stands there: then there is no state
};

/// The answer of a locomotive that cannot start.
inline LocoTraction failedAnswer(const LocoForce& force, const std::string& failure) {
  LocoTraction answer;
  answer.step = force.step;
  answer.failure = failure;
  return answer;
}

/// One locomotive's dynamics between two exchanges with the train: the interface that the 1D, 2D and 3D models
/// implement. A locomotive is a pure function (s_k, F_k) -> (s_k+1, answer): the object holds constants and scratch
/// memory only, so whoever holds s_k can repeat the step anywhere, with the same bits.
class Locomotive {
 public:
  virtual ~Locomotive() = default;

  /// Length of the state vector.
  virtual std::size_t stateSize() const = 0;

  /// State in equilibrium, running freely at `speed_mps` at chainage `location_m`.
  virtual LocoStart equilibriumState(double location_m, double speed_mps) const = 0;

  /// Advances by one macro step.
  /// @param state   s_k, of stateSize()
  /// @param force   F_k
  /// @param answer  everything is overwritten; answer.state becomes s_k+1, answer.failure says why the model cannot go
  ///                on (then the rest does not hold). Does not throw; allocates only if answer.state is too small.
  virtual void step(const std::vector<double>& state, const LocoForce& force, LocoTraction& answer) = 0;

  /// Where its bodies stand in this state, for people to look at.
  virtual std::vector<BodyPose> computePoses(const std::vector<double>& state) const = 0;
};

}  // namespace loco
