#include "ltd_sim/brake_response.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ltd_sim/air_brake.hpp"
#include "ltd_sim/train_model.hpp"

namespace ltd {

namespace {

constexpr rail::Nanoseconds kStep = rail::kNanosecondsPerSecond / 10;  // chosen: short against any filling
constexpr int kMostSteps = 6000;                                       // chosen: 10 min, longer than any release
constexpr double kSurely_Pa = 1e-3;                                    // of rounding: so much more surely applies
constexpr double kFree = 0.05;                                         // chosen: a brake that no longer drags

/// The train's brake, tried out while it stands: released and charged at first, all reservoirs full.
class Trial {
 public:
  Trial(const TrainModel& train, const AirBrake& brake) : brake_(brake), state_(brake.stateAtRest(kChargedPipe_Pa)) {
    const AirBrake::State full = brake.stateAtRest(brake.fullServicePressure());
    for (std::size_t i = 0; i < train.vehicles.size(); ++i) full_N_.push_back(brake.shoeForce(i, 0.0, full));
    for (const double force_N : full_N_) sum_N_ += force_N;
  }

  struct Ramp {
    double delay_s = 0.0, per_s = 1.0;
    double free_s = 0.0;  ///< all are free again
  };

  /// Sets the pipe to this pressure and follows the train's mean share until it rests.
  Ramp change(double pipe_Pa) {
    std::vector<double> shares{share()};
    DriverCommand command;
    command.pipe_pressure_Pa = pipe_Pa;
    int last_dragging = 0;
    for (int k = 1, resting = 0; k < kMostSteps && resting < kRest; ++k) {
      brake_.step(command, kStep, state_);
      shares.push_back(share());
      resting = shares.back() == shares[shares.size() - 2] ? resting + 1 : 0;
      if (anyDrags()) last_dragging = k;
    }
    return rampOf(shares, rail::toSeconds(last_dragging * kStep));
  }

 private:
  static constexpr int kRest = 300;  // chosen: 30 s, so that the wave has been everywhere

  /// Mean share of full service that presses.
  double share() const {
    double sum_N = 0.0;
    for (std::size_t i = 0; i < full_N_.size(); ++i) sum_N += brake_.shoeForce(i, 0.0, state_);
    return sum_N_ > 0.0 ? sum_N / sum_N_ : 0.0;
  }
  bool anyDrags() const {
    for (std::size_t i = 0; i < full_N_.size(); ++i)
      if (full_N_[i] > 0.0 && brake_.shoeForce(i, 0.0, state_) > kFree * full_N_[i]) return true;
    return false;
  }

  /// Same area, same slope in the middle.
  static Ramp rampOf(const std::vector<double>& shares, double free_s) {
    const double from = shares.front(), to = shares.back(), step_s = rail::toSeconds(kStep);
    Ramp ramp;
    ramp.free_s = free_s;
    double area_s = 0.0, first_s = -1.0, last_s = 0.0;
    if (from == to) return ramp;
    for (std::size_t k = 1; k < shares.size(); ++k) {
      const double done = (shares[k] - from) / (to - from), t = step_s * static_cast<double>(k);
      area_s += step_s * (1.0 - done);
      if (done >= 0.1 && first_s < 0.0) first_s = t;
      if (done < 0.9) last_s = t;
    }
    ramp.per_s = 0.8 * std::abs(to - from) / std::max(last_s - first_s, step_s);
    ramp.delay_s = std::max(0.0, area_s - 0.5 * std::abs(to - from) / ramp.per_s);
    return ramp;
  }

  const AirBrake& brake_;
  AirBrake::State state_;
  std::vector<double> full_N_;  ///< per vehicle, with full cylinders
  double sum_N_ = 0.0;
};

}  // namespace

BrakeResponse computeBrakeResponse(const TrainModel& train, const AirBrake& air_brake) {
  BrakeResponse response;
  if (!air_brake.present()) return response;
  // A trial each: after a release the reservoirs would still be low, and the brake another one.
  Trial full(train, air_brake), little(train, air_brake);
  const Trial::Ramp applied = full.change(air_brake.fullServicePressure());
  const Trial::Ramp released = full.change(kChargedPipe_Pa);
  little.change(kChargedPipe_Pa - air_brake.firstReduction() - kSurely_Pa);
  const Trial::Ramp first = little.change(kChargedPipe_Pa);
  response.delay_s = applied.delay_s;
  response.fill_per_s = applied.per_s;
  response.release_delay_s = released.delay_s;
  response.release_per_s = released.per_s;
  response.free_from_first_s = first.free_s;
  response.free_from_full_s = released.free_s;
  return response;
}

}  // namespace ltd
