#include "ltd_sim/train_dynamics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ltd_sim/resistance.hpp"

namespace ltd {

namespace {

/// Of the couplers on a vehicle, + forward.
double frontForce(const TrainForces& forces, std::size_t vehicle) {
  return vehicle > 0 ? forces.coupler[vehicle - 1].force_N : 0.0;
}
double rearForce(const TrainForces& forces, std::size_t vehicle) {
  return vehicle < forces.coupler.size() ? -forces.coupler[vehicle].force_N : 0.0;
}

}  // namespace

TrainDynamics::TrainDynamics(const TrainModel& train, const rail::Track& track, const Driver& driver,
                             const AirBrake& air_brake, rail::Nanoseconds step)
    : train_(train),
      track_(track),
      driver_(driver),
      air_brake_(air_brake),
      step_ns_(step),
      H_(rail::toSeconds(step)),
      booking_(train, track, step),
      track_hint_(train.vehicles.size(), 0),
      is_locomotive_(train.vehicles.size(), false),
      traction_(train.vehicles.size(), 0.0),
      v_next_(train.vehicles.size(), 0.0) {
  for (const LocoUnit& unit : train.locomotives) is_locomotive_[unit.vehicle] = true;
}

TrainState TrainDynamics::initialState(double location_m, double speed_mps) const {
  const std::size_t n = train_.vehicles.size();
  const std::size_t locos = train_.locomotives.size();
  TrainState state;
  state.s_m.assign(n, 0.0);
  state.v_mps.assign(n, speed_mps);
  const std::size_t lead = train_.locomotives.front().vehicle;
  state.s_m[lead] = location_m;
  for (std::size_t i = lead; i > 0; --i) state.s_m[i - 1] = state.s_m[i] + train_.coupler_distance_m[i - 1];
  for (std::size_t i = lead; i + 1 < n; ++i) state.s_m[i + 1] = state.s_m[i] - train_.coupler_distance_m[i];
  state.reference_N.assign(locos, 0.0);
  state.traction_N.assign(locos, 0.0);
  state.loco_energy.assign(locos, {});
  state.loco_state.assign(locos, {});
  for (const LocoUnit& unit : train_.locomotives) state.supply.push_back(train_.supplies[unit.type].initialState());
  state.store_empty_at.assign(locos, -1);
  state.air = air_brake_.initialState();
  return state;
}

void TrainDynamics::computeForces(TrainState& state, TrainForces& forces) {
  computeOuterForces(state, forces);
  decide(state, forces);
}

void TrainDynamics::computeOuterForces(const TrainState& state, TrainForces& forces) {
  computeCouplerForces(state, forces);
  computeTrackForces(state, forces);
  computeStepUse(forces);
  fillView(state, forces);
}

void TrainDynamics::computeCouplerForces(const TrainState& state, TrainForces& forces) const {
  forces.coupler.resize(train_.coupler_type.size());
  for (std::size_t i = 0; i < forces.coupler.size(); ++i) {
    const Coupler& coupler = train_.coupler_types[train_.coupler_type[i]];
    forces.coupler[i] =
        coupler.computeForce(train_.couplerElongation(i, state.s_m), state.v_mps[i] - state.v_mps[i + 1]);
  }
}

void TrainDynamics::fillView(const TrainState& state, TrainForces& forces) const {
  DriverView& view = forces.view;
  view.t = static_cast<rail::Nanoseconds>(state.step) * step_ns_;
  view.location_m = leadingLocation(state);
  view.speed_mps = leadingSpeed(state);
  view.grade_N = view.resistance_N = view.air_brake_N = view.traction_N = view.loco_shoes_N = 0.0;
  for (std::size_t i = 0; i < train_.vehicles.size(); ++i) {
    view.grade_N += forces.grade_N[i];
    view.resistance_N += forces.propulsion_N[i] + forces.curving_N[i];
    view.air_brake_N += forces.air_brake_N[i];
    if (is_locomotive_[i] && state.v_mps[i] != 0.0)
      view.loco_shoes_N -= std::copysign(forces.shoe_N[i], state.v_mps[i]);
  }
  for (const double traction_N : state.traction_N) view.traction_N += traction_N;
  view.pipe_pressure_Pa =
      air_brake_.present() ? air_brake_.pipePressure(train_.locomotives.front().vehicle, state.air) : kChargedPipe_Pa;
}

void TrainDynamics::decide(TrainState& state, TrainForces& forces) const {
  const std::size_t locos = train_.locomotives.size();
  forces.notch.resize(locos);
  forces.brake_notch.resize(locos);
  forces.reference_N.resize(locos);
  forces.rim_power_limit_W.resize(locos);
  driver_.command(forces.view, state.driver);
  for (std::size_t i = 0; i < locos; ++i) {
    const LocoUnit& unit = train_.locomotives[i];
    const TractionCharacteristic& traction = train_.traction[unit.type];
    const DriverCommand command = driver_.groupCommand(unit.notch_group, forces.view.t, state.driver);
    const double v = state.v_mps[unit.vehicle];
    forces.notch[i] = command.emergency ? 0 : command.notch;
    forces.brake_notch[i] = command.brake_notch;
    double target_N = traction.computeForce(forces.notch[i], v);
    if (forces.brake_notch[i] > 0) target_N = -train_.dynamic_brakes[unit.type].computeForce(forces.brake_notch[i], v);
    const double available_W = train_.supplies[unit.type].availableRimPower(state.supply[i], H_);
    forces.reference_N[i] = std::min(respond(unit, state.reference_N[i], target_N),
                                     computeServedForce(unit.vehicle, available_W, state, forces));
    forces.rim_power_limit_W[i] = std::min(traction.computeRimPowerLimit(forces.notch[i]), available_W);
  }
}

/// The largest force of a locomotive that a power serves over the coming step, by which its speed changes:     (F16)
///   F (v + H/2 (F + O)/m) = P,   O: all that acts on it but traction and its own shoes, which only make it slower
/// 0 of no power, also for a locomotive that rolls back. Power electronics obey at once, so (T4) does not hold it up.
double TrainDynamics::computeServedForce(std::size_t vehicle, double power_W, const TrainState& state,
                                         const TrainForces& forces) const {
  if (power_W <= 0.0) return 0.0;
  if (std::isinf(power_W)) return power_W;
  const double others_N = frontForce(forces, vehicle) + rearForce(forces, vehicle) + forces.propulsion_N[vehicle] +
                          forces.curving_N[vehicle] + forces.grade_N[vehicle];
  const double k = 0.5 * H_ / train_.inertial_mass_kg[vehicle];
  const double v_without = state.v_mps[vehicle] + k * others_N;
  return 2.0 * power_W / (v_without + std::sqrt(v_without * v_without + 4.0 * k * power_W));
}

/// Motor response (T4) over both signs: from traction to braking, or back, through 0.
double TrainDynamics::respond(const LocoUnit& unit, double last_N, double target_N) const {
  if (last_N > 0.0 || (last_N == 0.0 && target_N >= 0.0))
    return std::max(0.0, train_.traction[unit.type].computeResponse(last_N, std::max(target_N, 0.0), H_));
  return -train_.dynamic_brakes[unit.type].computeResponse(-last_N, std::max(-target_N, 0.0), H_);
}

void TrainDynamics::computeTrackForces(const TrainState& state, TrainForces& forces) {
  const std::size_t n = train_.vehicles.size();
  forces.grade_N.resize(n);
  forces.propulsion_N.resize(n);
  forces.curving_N.resize(n);
  forces.air_brake_N.resize(n);
  forces.shoe_N.resize(n);
  forces.view.speed_limit_mps = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < train_.locomotives.size(); ++j)
    traction_[train_.locomotives[j].vehicle] = state.traction_N[j];  // this step's is not known yet
  for (std::size_t i = 0; i < n; ++i) {
    const rail::Vehicle& vehicle = train_.vehicles[i];
    const rail::TrackPoint here = track_.at(state.s_m[i], track_hint_[i]);
    const double F_c1 = frontForce(forces, i);
    const double F_c2 = rearForce(forces, i);
    const double F_G = computeGradeForce(vehicle, here.grade);
    const double R_pr = computePropulsionResistance(vehicle, state.v_mps[i]);
    const double R_cr = computeCurvingResistance(vehicle, here.curvature_1pm);
    forces.shoe_N[i] = air_brake_.present() ? air_brake_.shoeForce(i, state.v_mps[i], state.air) : 0.0;
    const double R_ab = is_locomotive_[i] ? 0.0 : forces.shoe_N[i];
    const double R = R_pr + R_cr + R_ab;
    const double F_res =
        computeHeldResistance(F_c1 + F_c2 + F_G + traction_[i], R, train_.inertial_mass_kg[i], state.v_mps[i], H_);
    forces.grade_N[i] = F_G;
    forces.curving_N[i] = R > 0.0 ? F_res * (R_cr / R) : 0.0;
    forces.air_brake_N[i] = R > 0.0 ? F_res * (R_ab / R) : 0.0;
    forces.propulsion_N[i] = F_res - forces.curving_N[i] - forces.air_brake_N[i];
    forces.view.speed_limit_mps = std::min(forces.view.speed_limit_mps, here.speed_limit_mps);
  }
}

void TrainDynamics::computeStepUse(TrainForces& forces) const {
  forces.step_use = 0.0;
  const std::size_t n = train_.vehicles.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double c1 = i > 0 ? forces.coupler[i - 1].friction_N_s_per_m : 0.0;
    const double c2 = i + 1 < n ? forces.coupler[i].friction_N_s_per_m : 0.0;
    const double use = H_ * (c1 + c2) / train_.inertial_mass_kg[i];  // (T6), the friction's part
    if (use > forces.step_use) {
      forces.step_use = use;
      forces.step_use_vehicle = i;
    }
  }
}

void TrainDynamics::fillLocoForce(std::size_t i, const TrainState& state, const TrainForces& forces,
                                  loco::LocoForce& out) const {
  const std::size_t vehicle = train_.locomotives[i].vehicle;
  out.step = state.step;
  out.step_length = step_ns_;
  out.traction_reference_N = forces.reference_N[i];
  out.notch = forces.notch[i];
  out.brake_notch = forces.brake_notch[i];
  out.shoe_force_N = forces.shoe_N[vehicle];
  out.sanding = driver_.lead(state.driver).sanding;
  out.rim_power_limit_W = forces.rim_power_limit_W[i];
  out.coupler_front_N = frontForce(forces, vehicle);
  out.coupler_rear_N = rearForce(forces, vehicle);
  out.propulsion_resistance_N = forces.propulsion_N[vehicle];
  out.curving_resistance_N = forces.curving_N[vehicle];
  out.grade_N = forces.grade_N[vehicle];
  out.speed_mps = state.v_mps[vehicle];
  out.location_m = state.s_m[vehicle];
}

std::string TrainDynamics::computeSpeeds(const TrainState& state, const TrainForces& forces,
                                         const std::vector<const loco::LocoTraction*>& answers) {
  for (std::size_t j = 0; j < answers.size(); ++j) traction_[train_.locomotives[j].vehicle] = answers[j]->traction_N;
  for (std::size_t i = 0; i < v_next_.size(); ++i) {
    const double F_c1 = frontForce(forces, i);
    const double F_c2 = rearForce(forces, i);
    const double F = F_c1 + F_c2 + traction_[i] + forces.air_brake_N[i] + forces.propulsion_N[i] + forces.curving_N[i] +
                     forces.grade_N[i];                                 // Eq. (1)
    v_next_[i] = state.v_mps[i] + H_ * F / train_.inertial_mass_kg[i];  // (T5)
    if (!std::isfinite(v_next_[i])) return "vehicle " + std::to_string(i + 1) + ": its speed is not a number";
  }
  return {};
}

void TrainDynamics::advance(TrainState& state, const TrainForces& forces,
                            const std::vector<const loco::LocoTraction*>& answers) {
  for (std::size_t j = 0; j < answers.size(); ++j) {
    state.traction_N[j] = answers[j]->traction_N;
    state.reference_N[j] = forces.reference_N[j];
    state.loco_state[j] = answers[j]->state;
  }
  std::swap(state.v_mps, v_next_);
  const std::vector<double>& v_old = v_next_;
  for (std::size_t i = 0; i < v_old.size(); ++i) state.s_m[i] += H_ * state.v_mps[i];  // (T5)
  booking_.bookStep(v_old, forces, answers, state);
  if (air_brake_.present()) air_brake_.step(driver_.lead(state.driver), step_ns_, state.air);
  ++state.step;
}

int TrainDynamics::vehicleOffTrack(const TrainState& state) const {
  if (state.s_m.front() > track_.end_m()) return 0;
  if (state.s_m.back() < track_.start_m()) return static_cast<int>(state.s_m.size()) - 1;
  return -1;
}

}  // namespace ltd
