#include "conversions.hpp"

#include "rail_core/build_id.hpp"

namespace ltd {

namespace {

rail::Nanoseconds timeOf(const Scenario& scenario, const TrainState& state) {
  return static_cast<rail::Nanoseconds>(state.step) * scenario.macro_step;
}

}  // namespace

void toMsg(const Scenario& scenario, const TrainState& state, const TrainForces& forces, train_msgs::TrainState& msg) {
  const std::size_t lead = scenario.train.locomotives.front().vehicle;
  const rail::Nanoseconds t = timeOf(scenario, state);
  msg.header.stamp = toStamp(t);
  msg.step = state.step;
  msg.time = rail::toSeconds(t);
  msg.location = state.s_m[lead];
  msg.speed = state.v_mps[lead];
  msg.notch.assign(forces.notch.begin(), forces.notch.end());
  msg.traction = state.traction_N;
  msg.vehicle_location = state.s_m;
  msg.vehicle_speed = state.v_mps;
  msg.coupler_force.resize(forces.coupler.size());
  for (std::size_t i = 0; i < forces.coupler.size(); ++i) msg.coupler_force[i] = forces.coupler[i].force_N;
}

void toMsg(const Scenario& scenario, const TrainState& state, train_msgs::TrainEnergy& msg) {
  const rail::EnergyAccount& a = state.account;
  msg.header.stamp = toStamp(timeOf(scenario, state));
  msg.loco_energy_rail.clear();
  msg.loco_energy_rim.clear();
  msg.loco_energy_slip.clear();
  for (const LocoEnergy& energy : state.loco_energy) {
    msg.loco_energy_rail.push_back(energy.rail);
    msg.loco_energy_rim.push_back(energy.rim);
    msg.loco_energy_slip.push_back(energy.slip);
  }
  msg.traction_rail = a.traction_rail;
  msg.traction_rim = a.traction_rim;
  msg.slip_loss = a.slip_loss;
  msg.propulsion_resistance = a.propulsion_resistance;
  msg.curving_resistance = a.curving_resistance;
  msg.grade = a.grade;
  msg.coupler_loss = a.coupler_loss;
  msg.coupler_stored = a.coupler_stored - a.coupler_stored_start;
  msg.kinetic = a.kinetic - a.kinetic_start;
  msg.potential = a.potential - a.potential_start;
  msg.residual = a.residual();
  msg.residual_relative = a.residualRelative();
}

train_msgs::RunConfiguration toMsg(const Scenario& scenario, std::uint64_t run_id) {
  train_msgs::RunConfiguration msg;
  msg.format_version = kBagFormatVersion;
  msg.build_id = rail::buildId();
  msg.run_id = run_id;
  msg.scenario = scenario.name;
  msg.scenario_file = scenario.file;
  msg.resolved = scenario.document.text();
  return msg;
}

}  // namespace ltd
