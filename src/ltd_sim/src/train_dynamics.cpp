#include "ltd_sim/train_dynamics.hpp"

#include <cmath>

#include "ltd_sim/resistance.hpp"

namespace ltd {

TrainDynamics::TrainDynamics(const TrainModel& train, const rail::Track& track, const Driver& driver,
                             rail::Nanoseconds step)
    : train_(train),
      track_(track),
      driver_(driver),
      step_ns_(step),
      H_(rail::toSeconds(step)),
      track_hint_(train.vehicles.size(), 0),
      traction_(train.vehicles.size(), 0.0),
      v_old_(train.vehicles.size(), 0.0) {}

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
  return state;
}

void TrainDynamics::computeForces(TrainState& state, TrainForces& forces) {
  computeCouplerForces(state, forces);
  computeTractionReferences(state, forces);
  computeTrackForces(state, forces);
  computeStepUse(forces);
}

void TrainDynamics::computeCouplerForces(const TrainState& state, TrainForces& forces) const {
  forces.coupler.resize(train_.coupler_type.size());
  for (std::size_t i = 0; i < forces.coupler.size(); ++i) {
    const Coupler& coupler = train_.coupler_types[train_.coupler_type[i]];
    forces.coupler[i] = coupler.computeForce(couplerElongation(i, state), state.v_mps[i] - state.v_mps[i + 1]);
  }
}

void TrainDynamics::computeTractionReferences(TrainState& state, TrainForces& forces) const {
  const std::size_t locos = train_.locomotives.size();
  forces.notch.resize(locos);
  forces.reference_N.resize(locos);
  forces.rim_power_limit_W.resize(locos);
  const rail::Nanoseconds t = static_cast<rail::Nanoseconds>(state.step) * step_ns_;
  DriverView view;  // the forces that a timetable's driver wants join with the brakes
  view.t = t;
  view.location_m = leadingLocation(state);
  view.speed_mps = leadingSpeed(state);
  driver_.command(view, state.driver);
  for (std::size_t i = 0; i < locos; ++i) {
    const LocoUnit& unit = train_.locomotives[i];
    const TractionCharacteristic& traction = train_.traction[unit.type];
    const int notch = driver_.groupCommand(unit.notch_group, t, state.driver).notch;
    const double target_N = traction.computeForce(notch, state.v_mps[unit.vehicle]);
    forces.notch[i] = notch;
    forces.reference_N[i] = traction.computeResponse(state.reference_N[i], target_N, H_);
    forces.rim_power_limit_W[i] = traction.computeRimPowerLimit(notch);
  }
}

void TrainDynamics::computeTrackForces(const TrainState& state, TrainForces& forces) {
  const std::size_t n = train_.vehicles.size();
  forces.grade_N.resize(n);
  forces.propulsion_N.resize(n);
  forces.curving_N.resize(n);
  for (std::size_t j = 0; j < train_.locomotives.size(); ++j)
    traction_[train_.locomotives[j].vehicle] = state.traction_N[j];  // this step's is not known yet
  for (std::size_t i = 0; i < n; ++i) {
    const rail::Vehicle& vehicle = train_.vehicles[i];
    const rail::TrackPoint here = track_.at(state.s_m[i], track_hint_[i]);
    const double F_c1 = i > 0 ? forces.coupler[i - 1].force_N : 0.0;
    const double F_c2 = i + 1 < n ? -forces.coupler[i].force_N : 0.0;
    const double F_G = computeGradeForce(vehicle, here.grade);
    const double R_pr = computePropulsionResistance(vehicle, state.v_mps[i]);
    const double R_cr = computeCurvingResistance(vehicle, here.curvature_1pm);
    const double R = R_pr + R_cr;
    const double F_res =
        computeHeldResistance(F_c1 + F_c2 + F_G + traction_[i], R, train_.inertial_mass_kg[i], state.v_mps[i], H_);
    forces.grade_N[i] = F_G;
    forces.curving_N[i] = R > 0.0 ? F_res * (R_cr / R) : 0.0;
    forces.propulsion_N[i] = F_res - forces.curving_N[i];
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
  out.rim_power_limit_W = forces.rim_power_limit_W[i];
  out.coupler_front_N = vehicle > 0 ? forces.coupler[vehicle - 1].force_N : 0.0;
  out.coupler_rear_N = vehicle + 1 < train_.vehicles.size() ? -forces.coupler[vehicle].force_N : 0.0;
  out.propulsion_resistance_N = forces.propulsion_N[vehicle];
  out.curving_resistance_N = forces.curving_N[vehicle];
  out.grade_N = forces.grade_N[vehicle];
  out.speed_mps = state.v_mps[vehicle];
  out.location_m = state.s_m[vehicle];
}

std::string TrainDynamics::step(TrainState& state, const TrainForces& forces,
                                const std::vector<const loco::LocoTraction*>& answers) {
  const std::size_t n = train_.vehicles.size();
  for (std::size_t j = 0; j < answers.size(); ++j) {
    traction_[train_.locomotives[j].vehicle] = answers[j]->traction_N;
    state.traction_N[j] = answers[j]->traction_N;
    state.reference_N[j] = forces.reference_N[j];
    state.loco_state[j] = answers[j]->state;
  }
  v_old_ = state.v_mps;
  for (std::size_t i = 0; i < n; ++i) {
    const double F_c1 = i > 0 ? forces.coupler[i - 1].force_N : 0.0;
    const double F_c2 = i + 1 < n ? -forces.coupler[i].force_N : 0.0;
    const double F = F_c1 + F_c2 + traction_[i] + /* F_db + F_ab: whole trips */ forces.propulsion_N[i] +
                     forces.curving_N[i] + forces.grade_N[i];          // Eq. (1)
    state.v_mps[i] = v_old_[i] + H_ * F / train_.inertial_mass_kg[i];  // (T5)
    state.s_m[i] += H_ * state.v_mps[i];
    bookVehicle(i, v_old_[i], state.v_mps[i], forces, state.account);
    if (!std::isfinite(state.v_mps[i])) return "vehicle " + std::to_string(i + 1) + ": its speed is not a number";
  }
  bookCouplers(state, forces, state.account);
  for (std::size_t j = 0; j < answers.size(); ++j) {
    const std::size_t vehicle = train_.locomotives[j].vehicle;
    const double S = H_ * 0.5 * (v_old_[vehicle] + state.v_mps[vehicle]);
    const double work_rail = answers[j]->traction_N * S;  // Eq. (4)
    state.loco_energy[j].rail += work_rail;
    state.loco_energy[j].rim += answers[j]->work_rim_J;
    state.loco_energy[j].slip += answers[j]->work_slip_J;
    state.account.traction_rail += work_rail;
    state.account.traction_rim += answers[j]->work_rim_J;
    state.account.slip_loss += answers[j]->work_slip_J;
  }
  ++state.step;
  return {};
}

void TrainDynamics::bookVehicle(std::size_t i, double v_old, double v_new, const TrainForces& forces,
                                rail::EnergyAccount& account) const {
  const double S = H_ * 0.5 * (v_old + v_new);  // work of a force: with the mean speed                            (T7)
  account.propulsion_resistance -= forces.propulsion_N[i] * S;
  account.curving_resistance -= forces.curving_N[i] * S;
  account.grade -= forces.grade_N[i] * S;
}

void TrainDynamics::bookCouplers(const TrainState& state, const TrainForces& forces,
                                 rail::EnergyAccount& account) const {
  for (std::size_t i = 0; i < forces.coupler.size(); ++i) {
    const double elongation_speed = 0.5 * (v_old_[i] - v_old_[i + 1] + state.v_mps[i] - state.v_mps[i + 1]);
    account.coupler_loss += (forces.coupler[i].force_N - forces.coupler[i].mean_N) * elongation_speed * H_;
  }
}

void TrainDynamics::updateStoredEnergies(TrainState& state) {
  double kinetic = 0.0, potential = 0.0, stored = 0.0;
  for (std::size_t i = 0; i < train_.vehicles.size(); ++i) {
    const double v = state.v_mps[i];
    kinetic += 0.5 * train_.inertial_mass_kg[i] * v * v;
    const double height_m = track_.at(state.s_m[i] - 0.5 * H_ * v, track_hint_[i]).height_m;  // (T9)
    potential -= computeGradeForce(train_.vehicles[i], 1.0) * height_m;
  }
  for (std::size_t i = 0; i < train_.coupler_type.size(); ++i) {
    const double elongation_m = couplerElongation(i, state) - 0.5 * H_ * (state.v_mps[i] - state.v_mps[i + 1]);  // (T9)
    stored += train_.coupler_types[train_.coupler_type[i]].computeStoredEnergy(elongation_m);
  }
  state.account.kinetic = kinetic;
  state.account.potential = potential;
  state.account.coupler_stored = stored;
  if (state.step == 0) {
    state.account.kinetic_start = kinetic;
    state.account.potential_start = potential;
    state.account.coupler_stored_start = stored;
  }
}

int TrainDynamics::vehicleOffTrack(const TrainState& state) const {
  if (state.s_m.front() > track_.end_m()) return 0;
  if (state.s_m.back() < track_.start_m()) return static_cast<int>(state.s_m.size()) - 1;
  return -1;
}

}  // namespace ltd
