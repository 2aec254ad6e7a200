#include "ltd_sim/distributor.hpp"

#include <algorithm>

#include "ltd_sim/driver_command.hpp"

namespace ltd {

Distributor Distributor::read(rail::YamlReader reader, double full_reduction_Pa, bool electronic) {
  Parameters p;
  p.full_reduction_Pa = full_reduction_Pa;
  p.direct_release = reader.choice("release", {"graduated", "direct"}) == "direct";
  if (p.direct_release && electronic) reader.refuse("release", "must be graduated if the brake is electronic");
  // Up to 1 bar: chosen, so that pascals are noticed.
  p.first_reduction_Pa = kPascalsPerBar * reader.number("first_reduction_bar", rail::aboveUpTo(0.0, 1.0));
  if (p.first_reduction_Pa >= p.full_reduction_Pa)
    reader.refuse("first_reduction_bar", "must be less than the reduction of full service");
  if (p.direct_release) {
    p.release_rise_Pa = kPascalsPerBar * reader.number("release_rise_bar", rail::aboveUpTo(0.0, 1.0));
    p.reservoir_charging_Pa_per_s =
        kPascalsPerBar * reader.number("reservoir_charging_bar_per_s", rail::aboveUpTo(0.0, 1.0));
  } else {
    p.full_release_reduction_Pa =
        kPascalsPerBar * reader.number("full_release_reduction_bar", rail::aboveUpTo(0.0, 1.0));
    if (p.full_release_reduction_Pa >= p.first_reduction_Pa)
      reader.refuse("full_release_reduction_bar", "must be less than first_reduction_bar");
  }
  reader.finish();
  return Distributor(p);
}

Distributor::State Distributor::initialState(double pipe_Pa) const {
  return {kChargedPipe_Pa - pipe_Pa >= p_.first_reduction_Pa, kChargedPipe_Pa, pipe_Pa};
}

double Distributor::step(double pipe_Pa, bool emergency, double step_s, State& state) const {
  return p_.direct_release ? stepDirect(pipe_Pa, emergency, step_s, state) : stepGraduated(pipe_Pa, emergency, state);
}

double Distributor::stepGraduated(double pipe_Pa, bool emergency, State& state) const {
  const double reduction_Pa = kChargedPipe_Pa - pipe_Pa;
  if (emergency || reduction_Pa >= p_.first_reduction_Pa)
    state.applied = true;
  else if (reduction_Pa <= p_.full_release_reduction_Pa)
    state.applied = false;
  return state.applied ? std::clamp(reduction_Pa / p_.full_reduction_Pa, 0.0, 1.0) : 0.0;  // (B3)
}

/// It falls with the pipe until the cylinder has taken what it takes in full service; then both are equal.
double Distributor::computeAppliedReservoir(const State& state) const {
  return std::max(state.lowest_Pa, state.reservoir_Pa - p_.full_reduction_Pa);
}

double Distributor::stepDirect(double pipe_Pa, bool emergency, double step_s, State& state) const {
  if (state.applied && !emergency && pipe_Pa >= computeAppliedReservoir(state) + p_.release_rise_Pa) {
    state.applied = false;
    state.reservoir_Pa = computeAppliedReservoir(state);
  } else if (!state.applied && (emergency || state.reservoir_Pa - pipe_Pa >= p_.first_reduction_Pa)) {
    state.applied = true;
    state.lowest_Pa = pipe_Pa;
  }
  if (state.applied) {
    state.lowest_Pa = std::min(state.lowest_Pa, pipe_Pa);
    return std::max((state.reservoir_Pa - computeAppliedReservoir(state)) / p_.full_reduction_Pa, 0.0);  // (B4)
  }
  if (pipe_Pa > state.reservoir_Pa)
    state.reservoir_Pa = std::min(pipe_Pa, state.reservoir_Pa + step_s * p_.reservoir_charging_Pa_per_s);
  return 0.0;
}

}  // namespace ltd
