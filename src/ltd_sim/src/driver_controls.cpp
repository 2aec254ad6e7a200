#include "ltd_sim/driver_controls.hpp"

#include <algorithm>
#include <cmath>

namespace ltd {

namespace {

constexpr double kHysteresis = 0.75;  // chosen: > 1/2, or two notches would both be right
constexpr double kRounding = 1e-9;    // of a step: so that a whole number of them stays one
constexpr int kReversal = 5;          // chosen: a notch is taken back after five times the hold at the earliest

/// One notch up, one down or none, by the force wanted.
int wantedMove(int notch, int notches, double wanted_N, double v_mps,
               const std::function<double(int, double)>& force_N) {
  const double here = notch > 0 ? force_N(notch, v_mps) : 0.0;
  if (notch < notches && wanted_N > here + kHysteresis * (force_N(notch + 1, v_mps) - here)) return 1;
  if (notch > 0 && wanted_N <= 0.0) return -1;
  const double below = notch > 1 ? force_N(notch - 1, v_mps) : 0.0;
  if (notch > 0 && wanted_N < here - kHysteresis * (here - below)) return -1;
  return 0;
}

}  // namespace

double DriverControls::reductionFor(double share, const TrainAbility& ability) {
  const double wanted_Pa = share * ability.full_service_reduction_Pa;
  const double steps = std::ceil((wanted_Pa - kFirstReduction_Pa) / kReductionStep_Pa - kRounding);
  const double reduction_Pa = kFirstReduction_Pa + kReductionStep_Pa * std::max(0.0, steps);
  return std::min(reduction_Pa, ability.full_service_reduction_Pa);
}

void DriverControls::apply(const Wanted& wanted, const TrainAbility& ability, const DriverView& view, State& state,
                           DriverCommand& lead) const {
  lead.pipe_pressure_Pa = kChargedPipe_Pa - state.reduction_Pa;
  const bool braking = wanted.dynamic.up || state.reduction_Pa > 0.0;
  moveNotch(braking ? 0.0 : wanted.traction_N, ability, view, state, lead);
  moveBrakeNotch(wanted.dynamic, ability, view, state, lead);
}

/// Least time on a notch; going back takes longer, or two notches would take turns.
rail::Nanoseconds DriverControls::holdTime(int move, int last_move, bool quick) const {
  if (quick) return std::min(kQuickHold, settings.notch_hold);
  return move == -last_move ? kReversal * settings.notch_hold : settings.notch_hold;
}

void DriverControls::moveNotch(double wanted_N, const TrainAbility& ability, const DriverView& view, State& state,
                               DriverCommand& lead) const {
  const int move = wantedMove(lead.notch, ability.notches, wanted_N, view.speed_mps, ability.traction_N);
  if (move == 0 || (move > 0 && lead.brake_notch > 0)) return;
  const rail::Nanoseconds last = std::max(state.notch_changed, move > 0 ? state.brake_notch_changed : 0);
  if (view.t - last < holdTime(move, state.last_notch_move, move < 0 && wanted_N <= 0.0)) return;
  state.last_notch_move = move;
  lead.notch += move;
  state.notch_changed = view.t;
}

void DriverControls::moveBrakeNotch(const Trim& wanted, const TrainAbility& ability, const DriverView& view,
                                    State& state, DriverCommand& lead) const {
  if (ability.brake_notches == 0) return;
  const double force_N = wanted.force_N;
  const int move =
      wantedMove(lead.brake_notch, ability.brake_notches, force_N, view.speed_mps, ability.dynamic_brake_N);
  if (move == 0 || !(move > 0 ? wanted.up : wanted.down) || (move > 0 && lead.notch > 0)) return;
  const int two_up = std::min(lead.brake_notch + 2, ability.brake_notches);
  const bool quick = move < 0 ? force_N <= 0.0 : force_N > ability.dynamic_brake_N(two_up, view.speed_mps);
  const rail::Nanoseconds last = std::max(state.brake_notch_changed, move > 0 ? state.notch_changed : 0);
  if (view.t - last < holdTime(move, state.last_brake_notch_move, quick)) return;
  state.last_brake_notch_move = move;
  lead.brake_notch += move;
  state.brake_notch_changed = view.t;
}

}  // namespace ltd
