#pragma once

#include "ltd_sim/driver_command.hpp"
#include "ltd_sim/train_ability.hpp"

namespace ltd {

/// The hand at the controls: from a wanted force to notches, a step at a time, and to the brake pipe.        (V7)
///   notch up if F > F_n + h (F_n+1 - F_n), down if F < F_n - h (F_n - F_n-1),   h = 3/4
/// and not before the last notch was held for its time.
class DriverControls {
 public:
  struct Settings {
    rail::Nanoseconds notch_hold = 0;  ///< least time on a notch; down to idle or away from it faster
    rail::Nanoseconds air_hold = 0;    ///< least time between changes of the pipe's pressure
  };
  struct State {
    rail::Nanoseconds notch_changed = 0;
    rail::Nanoseconds brake_notch_changed = 0;
    rail::Nanoseconds air_changed = 0;
    int last_notch_move = 0, last_brake_notch_move = 0, last_air_move = 0;
    double reduction_Pa = 0.0;  ///< of the pipe, from charged
  };

  /// The least that he takes from the pipe. UIC 540: it moves every distributor for certain.
  static constexpr double kFirstReduction_Pa = 0.5e5;
  /// A step of the pipe. Chosen: as fine as a self-lapping driver's valve is set.
  static constexpr double kReductionStep_Pa = 0.1e5;
  /// Least time on a notch on the way to idle or to a far brake notch. Chosen: a notch a second.
  static constexpr rail::Nanoseconds kQuickHold = 1000000000;

  /// The reduction that gives at least this share of full service: 0.5 bar, and steps of 0.1 bar up to full service.
  static double reductionFor(double share, const TrainAbility& ability);

  /// A force to trim to, and which way it may be done.
  struct Trim {
    double force_N = 0.0;
    bool up = false, down = false;
  };
  /// What the driver wants of the locomotives now.
  struct Wanted {
    double traction_N = 0.0;  ///< at the rail, <= 0: none
    Trim dynamic;             ///< dynamic brake, >= 0
  };

  void apply(const Wanted& wanted, const TrainAbility& ability, const DriverView& view, State& state,
             DriverCommand& lead) const;

  Settings settings;

 private:
  rail::Nanoseconds holdTime(int move, int last_move, bool quick) const;
  void moveNotch(double wanted_N, const TrainAbility& ability, const DriverView& view, State& state,
                 DriverCommand& lead) const;
  void moveBrakeNotch(const Trim& wanted, const TrainAbility& ability, const DriverView& view, State& state,
                      DriverCommand& lead) const;
};

}  // namespace ltd
