#pragma once

#include "ltd_sim/driver_command.hpp"
#include "ltd_sim/train_ability.hpp"

namespace ltd {

/// The hand at the controls: from a wanted force to notches and to the brake pipe, a step at a time.        (V7)
///   notch up if F > F_n + h (F_n+1 - F_n), down if F < F_n - h (F_n - F_n-1),   h = 3/4
/// and not before the last notch was held for its time. Dynamic brake first; air for what it cannot give, 0.5 bar
/// first, more in steps of 0.2 bar up to full service.
class DriverControls {
 public:
  struct Settings {
    rail::Nanoseconds notch_hold = 0;  ///< least time on a notch; down to idle or away from it faster
    rail::Nanoseconds air_hold = 0;    ///< least time between changes of the pipe's pressure
    bool graduated_release = false;    ///< brakes that release in steps; direct ones release altogether
    double release_above_mps = 0.0;    ///< direct-release brakes stay on below, until the train stands
  };
  struct State {
    rail::Nanoseconds notch_changed = 0;
    rail::Nanoseconds brake_notch_changed = 0;
    rail::Nanoseconds air_changed = 0;
    int last_notch_move = 0, last_brake_notch_move = 0;
    double reduction_Pa = 0.0;  ///< of the pipe, from charged
  };

  /// The least that he takes from the pipe. UIC 540: it moves every distributor for certain.
  static constexpr double kFirstReduction_Pa = 0.5e5;

  /// What the driver wants of the train now.
  struct Wanted {
    double traction_N = 0.0;  ///< at the rail, <= 0: none
    double brake_N = 0.0;     ///< of all brakes together, >= 0
    double slack_mps = 0.0;   ///< so much slower than he would brake for
  };

  void apply(const Wanted& wanted, const TrainAbility& ability, const DriverView& view, State& state,
             DriverCommand& lead) const;

  /// Holds a standing train: idle, no dynamic brake, the pipe reduced.
  void hold(const TrainAbility& ability, const DriverView& view, State& state, DriverCommand& lead) const;

  Settings settings;

 private:
  rail::Nanoseconds holdTime(int move, int last_move, bool quick) const;
  void moveNotch(double wanted_N, const TrainAbility& ability, const DriverView& view, State& state,
                 DriverCommand& lead) const;
  void moveBrakeNotch(double wanted_N, const TrainAbility& ability, const DriverView& view, State& state,
                      DriverCommand& lead) const;
  void moveAir(const Wanted& wanted, const TrainAbility& ability, const DriverView& view, State& state) const;
  double chooseReduction(double wanted_Pa, const Wanted& wanted, const DriverView& view, const State& state) const;
};

}  // namespace ltd
