#include "run_end.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "kilometres.hpp"
#include "rail_core/constants.hpp"
#include "rail_core/message_number.hpp"

namespace ltd {

namespace {

bool stalled(const RunLimits& run, double speed_mps, rail::Nanoseconds t, const TrainForces& forces,
             TrainState& state) {
  const bool pulling = std::any_of(forces.notch.begin(), forces.notch.end(), [](int n) { return n > 0; });
  if (!pulling || std::abs(speed_mps) >= run.stall_speed_mps) {
    state.slow_since = -1;
    return false;
  }
  if (state.slow_since < 0) state.slow_since = t;
  return t - state.slow_since >= run.stall_time;
}

/// At rest for so long, after having moved, that the run ends: for run.end_at_standstill_s or, if the driver is silent,
/// for a second. A stop from which the train is to go on does not count.
bool stands(const Scenario& scenario, double speed_mps, rail::Nanoseconds t, bool silent, TrainState& state) {
  constexpr double kMoving_mps = 0.1, kResting_mps = 0.005;  // chosen: a locomotive's wheels creep on a grade
  const double v = std::abs(speed_mps);
  state.moved = state.moved || v > kMoving_mps;
  if (!state.moved || v > kResting_mps || scenario.driver.goesOn(state.driver)) {
    state.standing_since = -1;
    return false;
  }
  if (state.standing_since < 0) state.standing_since = t;
  const rail::Nanoseconds asked = scenario.run.standstill_time;
  if (asked == 0 && !silent) return false;
  return t - state.standing_since >= (asked > 0 ? asked : rail::kNanosecondsPerSecond);
}

std::string endTime(rail::Nanoseconds end_time) {
  return "reached the end time " + rail::messageNumber(rail::toSeconds(end_time)) + " s";
}

std::string runaway(double location_m, double speed_mps, double limit_mps) {
  char text[160];
  std::snprintf(text, sizeof text,
                "runaway at %s: %.1f km/h where %.1f are allowed, beyond run.runaway_above_limit_kmph",
                kilometres(location_m).c_str(), speed_mps * rail::kKmphPerMps, limit_mps * rail::kKmphPerMps);
  return text;
}

}  // namespace

std::optional<Ending> findEnding(const Scenario& scenario, const TrainDynamics& dynamics, const TrainForces& forces,
                                 const std::string& silence, TrainState& state) {
  using Kind = Outcome::Kind;
  const RunLimits& run = scenario.run;
  const rail::Nanoseconds t = static_cast<rail::Nanoseconds>(state.step) * scenario.macro_step;
  const double at_m = dynamics.leadingLocation(state), speed_mps = dynamics.leadingSpeed(state);
  if (at_m >= run.end_location_m) return Ending{Kind::kFinished, "reached " + kilometres(run.end_location_m)};
  if (const int off = dynamics.vehicleOffTrack(state); off >= 0)
    return Ending{Kind::kFailed, "vehicle " + std::to_string(off + 1) + " left the track at " +
                                     kilometres(state.s_m[static_cast<std::size_t>(off)])};
  if (t >= run.end_time) return Ending{Kind::kFinished, endTime(run.end_time)};
  const double limit_mps = forces.view.speed_limit_mps;
  if (speed_mps > limit_mps + run.runaway_margin_mps) return Ending{Kind::kFailed, runaway(at_m, speed_mps, limit_mps)};
  if (stands(scenario, speed_mps, t, !silence.empty(), state)) {
    const std::string at = "stands at " + kilometres(at_m);
    return silence.empty() ? Ending{Kind::kFinished, at} : Ending{Kind::kFailed, silence + ", and " + at};
  }
  if (stalled(run, speed_mps, t, forces, state))
    return Ending{Kind::kFailed, "stalled at " + kilometres(at_m) +
                                     ": traction on, and slower than stall.speed_below_mps for stall.for_s"};
  return std::nullopt;
}

}  // namespace ltd
