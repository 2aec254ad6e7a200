#include "ltd_sim/driver_controls.hpp"

#include <algorithm>
#include <cmath>

namespace ltd {

namespace {

constexpr double kHysteresis = 0.75;          // chosen: > 1/2, or two notches would both be right
constexpr double kLeastReduction_Pa = 0.1e5;  // chosen: what a graduated release still holds
constexpr double kReductionStep_Pa = 0.2e5;   // chosen: five steps from the first to UIC 540's full service
constexpr double kTooMuch = 0.7;              // chosen: air beyond what is wanted by more than a step of the pipe
constexpr double kReleaseBand_mps = 3.0;      // chosen: 11 km/h, or direct brakes would be applied and released in turn
constexpr double kApplyBand_mps = 0.25;       // chosen: air is not applied while the train is slower by more
constexpr double kStanding_mps = 0.05;        // chosen: below any speed that one steers
constexpr int kReversal = 5;                  // chosen: a notch is taken back after five times the hold at the earliest
constexpr rail::Nanoseconds kQuickHold = 1000000000;  // chosen: a notch a second to idle and to a far brake notch

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

void DriverControls::apply(const Wanted& wanted, const TrainAbility& ability, const DriverView& view, State& state,
                           DriverCommand& lead) const {
  moveAir(wanted, ability, view, state);
  lead.pipe_pressure_Pa = kChargedPipe_Pa - state.reduction_Pa;
  const bool braking = wanted.brake_N > 0.0 || state.reduction_Pa > 0.0;
  moveNotch(braking ? 0.0 : wanted.traction_N, ability, view, state, lead);
  moveBrakeNotch(wanted.brake_N - std::fabs(view.air_brake_N), ability, view, state, lead);
}

void DriverControls::hold(const TrainAbility& ability, const DriverView& view, State& state,
                          DriverCommand& lead) const {
  if (state.reduction_Pa < kFirstReduction_Pa) {
    state.reduction_Pa = kFirstReduction_Pa;
    state.air_changed = view.t;
  }
  lead.pipe_pressure_Pa = kChargedPipe_Pa - state.reduction_Pa;
  moveNotch(0.0, ability, view, state, lead);
  moveBrakeNotch(0.0, ability, view, state, lead);
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

void DriverControls::moveBrakeNotch(double wanted_N, const TrainAbility& ability, const DriverView& view, State& state,
                                    DriverCommand& lead) const {
  if (ability.brake_notches == 0) return;
  const int move =
      wantedMove(lead.brake_notch, ability.brake_notches, wanted_N, view.speed_mps, ability.dynamic_brake_N);
  if (move == 0 || (move > 0 && lead.notch > 0)) return;
  const int two_up = std::min(lead.brake_notch + 2, ability.brake_notches);
  const bool quick = move < 0 ? wanted_N <= 0.0 : wanted_N > ability.dynamic_brake_N(two_up, view.speed_mps);
  const rail::Nanoseconds last = std::max(state.brake_notch_changed, move > 0 ? state.notch_changed : 0);
  if (view.t - last < holdTime(move, state.last_brake_notch_move, quick)) return;
  state.last_brake_notch_move = move;
  lead.brake_notch += move;
  state.brake_notch_changed = view.t;
}

void DriverControls::moveAir(const Wanted& wanted, const TrainAbility& ability, const DriverView& view,
                             State& state) const {
  const double v = view.speed_mps;
  const double dynamic_N = ability.brake_notches > 0 ? ability.dynamic_brake_N(ability.brake_notches, v) : 0.0;
  const double full_N = ability.full_service_N ? ability.full_service_N(v) : 0.0;
  if (full_N <= 0.0 || view.t - state.air_changed < settings.air_hold) return;
  const double wanted_Pa = ability.full_service_reduction_Pa * (wanted.brake_N - dynamic_N) / full_N;
  const double reduction_Pa =
      std::min(chooseReduction(wanted_Pa, wanted, view, state), ability.full_service_reduction_Pa);
  if (reduction_Pa == state.reduction_Pa) return;
  state.reduction_Pa = reduction_Pa;
  state.air_changed = view.t;
}

/// The reduction to ask for, which may be beyond full service. @param wanted_Pa  what the dynamic brake leaves to the
/// air
double DriverControls::chooseReduction(double wanted_Pa, const Wanted& wanted, const DriverView& view,
                                       const State& state) const {
  const double now_Pa = state.reduction_Pa;
  const double steps = std::round((wanted_Pa - kFirstReduction_Pa) / kReductionStep_Pa);
  const double nearest_Pa = kFirstReduction_Pa + kReductionStep_Pa * steps;
  if (now_Pa == 0.0 && wanted.slack_mps > kApplyBand_mps) return 0.0;
  if (wanted_Pa > now_Pa + kHysteresis * kReductionStep_Pa) return std::max({nearest_Pa, now_Pa, kFirstReduction_Pa});
  if (now_Pa == 0.0) return 0.0;
  if (view.speed_mps < kStanding_mps) return wanted.brake_N > 0.0 ? now_Pa : 0.0;
  const bool too_much = wanted.brake_N <= kTooMuch * std::fabs(view.air_brake_N);
  const bool rolls = view.grade_N + view.resistance_N > 0.0;  // it would be fast again at once
  if (too_much && wanted.slack_mps >= (rolls ? kReleaseBand_mps : kApplyBand_mps))
    return settings.graduated_release || view.speed_mps >= settings.release_above_mps ? 0.0 : now_Pa;
  if (!settings.graduated_release || wanted_Pa > now_Pa - kHysteresis * kReductionStep_Pa) return now_Pa;
  if (view.t - state.air_changed < kReversal * settings.air_hold) return now_Pa;
  return std::clamp(nearest_Pa, std::min(now_Pa, kLeastReduction_Pa), now_Pa);
}

}  // namespace ltd
