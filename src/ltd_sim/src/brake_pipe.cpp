#include "ltd_sim/brake_pipe.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace ltd {

namespace {

using Sample = BrakePipe::State::Sample;

/// What the valve sent out `delay` steps before the newest sample, linear between samples.
double sentBefore(const BrakePipe::State& state, double delay, double Sample::*what) {
  const auto whole = static_cast<std::size_t>(delay);
  const double part = delay - static_cast<double>(whole);
  const std::size_t size = state.history.size();
  assert(whole + 1 < size);  // the step's length has not changed
  const std::size_t at = state.newest >= whole ? state.newest - whole : state.newest + size - whole;
  const double late = state.history[at].*what;
  return late + part * (state.history[at > 0 ? at - 1 : size - 1].*what - late);
}

}  // namespace

BrakePipe::BrakePipe(const Parameters& parameters, const std::vector<double>& place_m,
                     const std::vector<double>& remote_m)
    : p_(parameters) {
  for (const double place : place_m) {
    Place result;
    if (p_.electronic) {
      result = {p_.delay_s, p_.delay_s, std::numeric_limits<double>::infinity()};
    } else {
      double nearest_m = std::abs(place);
      result.service_delay_s = nearest_m / p_.service_wave_mps;
      result.emergency_delay_s = nearest_m / p_.emergency_wave_mps;
      for (const double remote : remote_m) {
        const double distance_m = std::abs(place - remote);
        nearest_m = std::min(nearest_m, distance_m);
        result.service_delay_s = std::min(result.service_delay_s, p_.delay_s + distance_m / p_.service_wave_mps);
        result.emergency_delay_s = std::min(result.emergency_delay_s, p_.delay_s + distance_m / p_.emergency_wave_mps);
      }
      result.charging_Pa_per_s = p_.charging_Pa_per_s / (1.0 + nearest_m / p_.charging_length_m);  // (B2)
    }
    longest_delay_s_ = std::max({longest_delay_s_, result.service_delay_s, result.emergency_delay_s});
    places_.push_back(result);
  }
}

BrakePipe::Parameters BrakePipe::read(rail::YamlReader reader, bool electronic) {
  const auto rate = rail::aboveUpTo(0.0, 50.0);  // bar/s; chosen: emptied in 0.1 s, and pascals are noticed
  Parameters p;
  p.electronic = electronic;
  p.full_service_Pa = kPascalsPerBar * reader.number("full_service_bar", rail::between(2.0, 4.5));  // chosen, about 3.5
  if (electronic) {
    p.delay_s = reader.number("delay_s", rail::between(0.0, 10.0));  // chosen: far above any signal's delay
    reader.finish();
    return p;
  }
  p.service_exhaust_Pa_per_s = kPascalsPerBar * reader.number("service_exhaust_bar_per_s", rate);
  p.emergency_exhaust_Pa_per_s = kPascalsPerBar * reader.number("emergency_exhaust_bar_per_s", rate);
  if (p.emergency_exhaust_Pa_per_s < p.service_exhaust_Pa_per_s)
    reader.refuse("emergency_exhaust_bar_per_s", "must not be less than service_exhaust_bar_per_s");
  p.charging_Pa_per_s = kPascalsPerBar * reader.number("charging_bar_per_s", rate);
  p.charging_length_m = reader.number("charging_length_m", rail::positive());
  const auto wave = rail::between(50.0, 343.0);  // m/s; low end chosen, nothing outruns sound in air at 20 degrees C
  p.service_wave_mps = reader.number("service_wave_mps", wave);
  p.emergency_wave_mps = reader.number("emergency_wave_mps", wave);
  if (p.emergency_wave_mps < p.service_wave_mps)
    reader.refuse("emergency_wave_mps", "must not be less than service_wave_mps");
  p.remote_valves = reader.boolean("remote_valves");
  if (p.remote_valves) p.delay_s = reader.number("remote_delay_s", rail::between(0.0, 60.0));  // chosen, as above
  reader.finish();
  return p;
}

BrakePipe::State BrakePipe::initialState(double pressure_Pa) const {
  State state;
  state.valve_Pa = pressure_Pa;
  state.pipe_Pa.assign(places_.size(), pressure_Pa);
  state.emergency.assign(places_.size(), 0);
  return state;
}

bool BrakePipe::stepValve(const DriverCommand& command, double step_s, State& state) const {
  if (state.history.empty()) {
    // Two samples more than the longest delay: the one of this step, and one to interpolate from.
    state.history.assign(static_cast<std::size_t>(longest_delay_s_ / step_s) + 3, {state.valve_Pa, kChargedPipe_Pa});
    state.steps_since_emergency = state.history.size();
  }
  const double before_Pa = state.valve_Pa;
  const double asked_Pa = command.emergency ? 0.0 : command.pipe_pressure_Pa;
  if (p_.electronic) {
    state.valve_Pa = asked_Pa;
  } else if (asked_Pa < before_Pa) {  // (B1)
    const double rate = command.emergency ? p_.emergency_exhaust_Pa_per_s : p_.service_exhaust_Pa_per_s;
    state.valve_Pa = std::max(asked_Pa, before_Pa - step_s * rate);
  } else {
    state.valve_Pa = std::min(asked_Pa, before_Pa + step_s * p_.charging_Pa_per_s);
  }
  state.newest = state.newest + 1 < state.history.size() ? state.newest + 1 : 0;
  state.history[state.newest] = {state.valve_Pa, command.emergency ? state.valve_Pa : kChargedPipe_Pa};
  state.steps_since_emergency = command.emergency ? 0 : state.steps_since_emergency + 1;
  return state.valve_Pa != before_Pa;
}

bool BrakePipe::step(const DriverCommand& command, double step_s, State& state) const {
  bool changed = stepValve(command, step_s, state);
  const double steps_per_s = 1.0 / step_s;
  const bool any_emergency = state.steps_since_emergency <= state.history.size();
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Place& place = places_[i];
    double arrived_Pa = sentBefore(state, place.service_delay_s * steps_per_s, &Sample::service_Pa);
    char emergency = 0;
    if (any_emergency) {
      const double emergency_Pa = sentBefore(state, place.emergency_delay_s * steps_per_s, &Sample::emergency_Pa);
      emergency = emergency_Pa < kChargedPipe_Pa ? 1 : 0;
      arrived_Pa = std::min(arrived_Pa, emergency_Pa);
    }
    const double before_Pa = state.pipe_Pa[i];
    state.pipe_Pa[i] = std::min(arrived_Pa, before_Pa + step_s * place.charging_Pa_per_s);  // (B2)
    changed = changed || state.pipe_Pa[i] != before_Pa || state.emergency[i] != emergency;
    state.emergency[i] = emergency;
  }
  return changed;
}

}  // namespace ltd
