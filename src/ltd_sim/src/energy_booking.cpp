#include "ltd_sim/energy_booking.hpp"

#include "ltd_sim/resistance.hpp"

namespace ltd {

EnergyBooking::EnergyBooking(const TrainModel& train, const rail::Track& track, rail::Nanoseconds step)
    : train_(train), track_(track), step_ns_(step), H_(rail::toSeconds(step)), track_hint_(train.vehicles.size(), 0) {}

void EnergyBooking::bookStep(const std::vector<double>& v_old, const TrainForces& forces,
                             const std::vector<const loco::LocoTraction*>& answers, TrainState& state) const {
  for (std::size_t i = 0; i < v_old.size(); ++i) bookVehicle(i, v_old[i], state.v_mps[i], forces, state.account);
  bookCouplers(v_old, forces, state);
  for (std::size_t j = 0; j < answers.size(); ++j)
    bookLoco(j, v_old[train_.locomotives[j].vehicle], *answers[j], forces, state);
}

void EnergyBooking::bookVehicle(std::size_t i, double v_old, double v_new, const TrainForces& forces,
                                rail::EnergyAccount& account) const {
  const double S = H_ * 0.5 * (v_old + v_new);  // (T7)
  account.propulsion_resistance -= forces.propulsion_N[i] * S;
  account.curving_resistance -= forces.curving_N[i] * S;
  account.air_brake -= forces.air_brake_N[i] * S;
  account.grade -= forces.grade_N[i] * S;
}

void EnergyBooking::bookCouplers(const std::vector<double>& v_old, const TrainForces& forces, TrainState& state) const {
  for (std::size_t i = 0; i < forces.coupler.size(); ++i) {
    const double elongation_speed = 0.5 * (v_old[i] - v_old[i + 1] + state.v_mps[i] - state.v_mps[i + 1]);
    state.account.coupler_loss += (forces.coupler[i].force_N - forces.coupler[i].mean_N) * elongation_speed * H_;
  }
}

void EnergyBooking::bookLoco(std::size_t j, double v_old, const loco::LocoTraction& answer, const TrainForces& forces,
                             TrainState& state) const {
  const LocoUnit& unit = train_.locomotives[j];
  const double S = H_ * 0.5 * (v_old + state.v_mps[unit.vehicle]);
  const bool coasts = forces.reference_N[j] == 0.0 && forces.shoe_N[unit.vehicle] == 0.0;
  const LocoEnergy step = computeStepEnergy(answer, S, coasts);
  state.loco_energy[j] += step;
  rail::EnergyAccount& account = state.account;
  account.traction_rail += step.rail;
  account.brake_rail += step.brake_rail;
  account.traction_rim += step.rim;
  account.recovered_rim += step.recovered_rim;
  account.slip_loss += step.slip;
  account.shoes += step.shoes;
  train_.supplies[unit.type].step(RimWork(answer.work_rim_J), H_, state.supply[j]);
  if (state.supply[j].empty && state.store_empty_at[j] < 0)
    state.store_empty_at[j] = static_cast<rail::Nanoseconds>(state.step) * step_ns_;
}

void EnergyBooking::updateStoredEnergies(TrainState& state) {
  double kinetic = 0.0, potential = 0.0, stored = 0.0;
  for (std::size_t i = 0; i < train_.vehicles.size(); ++i) {
    const double v = state.v_mps[i];
    kinetic += 0.5 * train_.inertial_mass_kg[i] * v * v;
    const double height_m = track_.at(state.s_m[i] - 0.5 * H_ * v, track_hint_[i]).height_m;  // (T9)
    potential -= computeGradeForce(train_.vehicles[i], 1.0) * height_m;
  }
  for (std::size_t i = 0; i < train_.coupler_type.size(); ++i) {
    const double elongation_m =
        train_.couplerElongation(i, state.s_m) - 0.5 * H_ * (state.v_mps[i] - state.v_mps[i + 1]);  // (T9)
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

}  // namespace ltd
