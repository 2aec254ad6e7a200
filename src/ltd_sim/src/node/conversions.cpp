#include "conversions.hpp"

#include <iterator>
#include <utility>

#include "ltd_sim/supply_figures.hpp"
#include "rail_core/build_id.hpp"

namespace ltd {

namespace {

rail::Nanoseconds timeOf(const Scenario& scenario, const TrainState& state) {
  return static_cast<rail::Nanoseconds>(state.step) * scenario.macro_step;
}

using EnergyMsg = train_msgs::TrainEnergy;
using List = std::vector<double> EnergyMsg::*;

constexpr std::pair<List, double LocoEnergy::*> kLocoLists[] = {
    {&EnergyMsg::loco_energy_rail, &LocoEnergy::rail},
    {&EnergyMsg::loco_energy_rim, &LocoEnergy::rim},
    {&EnergyMsg::loco_energy_slip, &LocoEnergy::slip},
    {&EnergyMsg::loco_brake_rail, &LocoEnergy::brake_rail},
    {&EnergyMsg::loco_recovered_rim, &LocoEnergy::recovered_rim},
    {&EnergyMsg::loco_shoes, &LocoEnergy::shoes},
};

/// As kSupplyFigures has them.
constexpr std::pair<List, double PowerSupply::State::*> kSupplyLists[] = {
    {&EnergyMsg::loco_fuel, &PowerSupply::State::fuel_J},
    {&EnergyMsg::loco_idle_fuel, &PowerSupply::State::idle_fuel_J},
    {&EnergyMsg::loco_engine_loss, &PowerSupply::State::engine_loss_J},
    {&EnergyMsg::loco_overload, &PowerSupply::State::overload_J},
    {&EnergyMsg::loco_generator, &PowerSupply::State::generator_J},
    {&EnergyMsg::loco_generator_loss, &PowerSupply::State::generator_loss_J},
    {&EnergyMsg::loco_line_drawn, &PowerSupply::State::line_drawn_J},
    {&EnergyMsg::loco_line_returned, &PowerSupply::State::line_returned_J},
    {&EnergyMsg::loco_line_loss, &PowerSupply::State::line_loss_J},
    {&EnergyMsg::loco_storage_in, &PowerSupply::State::storage_in_J},
    {&EnergyMsg::loco_storage_out, &PowerSupply::State::storage_out_J},
    {&EnergyMsg::loco_storage_loss, &PowerSupply::State::storage_loss_J},
    {&EnergyMsg::loco_stored, &PowerSupply::State::stored_J},
    {&EnergyMsg::loco_stored_start, &PowerSupply::State::stored_start_J},
    {&EnergyMsg::loco_motored_loss, &PowerSupply::State::motored_loss_J},
    {&EnergyMsg::loco_recovered_loss, &PowerSupply::State::recovered_loss_J},
    {&EnergyMsg::loco_auxiliaries, &PowerSupply::State::auxiliaries_J},
    {&EnergyMsg::loco_auxiliaries_unfed, &PowerSupply::State::auxiliaries_unfed_J},
    {&EnergyMsg::loco_to_resistors, &PowerSupply::State::to_resistors_J},
    {&EnergyMsg::loco_unserved, &PowerSupply::State::unserved_J},
};
constexpr bool areSupplyFigures() {
  if (std::size(kSupplyLists) != kSupplyFigures.size()) return false;
  for (std::size_t i = 0; i < kSupplyFigures.size(); ++i)
    if (kSupplyLists[i].second != kSupplyFigures[i].energy_J) return false;
  return true;
}
static_assert(areSupplyFigures(), "the same energies in the same order");

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
  msg.brake_notch.assign(forces.brake_notch.begin(), forces.brake_notch.end());
  msg.traction = state.traction_N;
  msg.vehicle_location = state.s_m;
  msg.vehicle_speed = state.v_mps;
  msg.coupler_force.resize(forces.coupler.size());
  for (std::size_t i = 0; i < forces.coupler.size(); ++i) msg.coupler_force[i] = forces.coupler[i].force_N;
  msg.speed_limit = forces.view.speed_limit_mps;
  msg.sanding = static_cast<std::uint8_t>(scenario.driver.lead(state.driver).sanding);
  if (!scenario.air_brake.present()) return;
  const std::size_t n = scenario.train.vehicles.size();
  msg.pipe_pressure.resize(n);
  msg.cylinder_pressure.resize(n);
  msg.shoe_force = forces.shoe_N;
  msg.shoe_force.resize(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    msg.pipe_pressure[i] = scenario.air_brake.pipePressure(i, state.air);
    msg.cylinder_pressure[i] = scenario.air_brake.cylinderPressure(i, state.air);
  }
}

void toMsg(const Scenario& scenario, const TrainState& state, train_msgs::TrainEnergy& msg) {
  const rail::EnergyAccount& a = state.account;
  msg.header.stamp = toStamp(timeOf(scenario, state));
  for (const auto& [list, energy] : kLocoLists) {
    (msg.*list).resize(state.loco_energy.size());
    for (std::size_t i = 0; i < state.loco_energy.size(); ++i) (msg.*list)[i] = state.loco_energy[i].*energy;
  }
  for (const auto& [list, energy_J] : kSupplyLists) {
    (msg.*list).resize(state.supply.size());
    for (std::size_t i = 0; i < state.supply.size(); ++i) (msg.*list)[i] = state.supply[i].*energy_J;
  }
  msg.loco_litres.resize(state.supply.size());
  msg.loco_supply_residual.resize(state.supply.size());
  for (std::size_t i = 0; i < state.supply.size(); ++i) {
    const PowerSupply& supply = scenario.train.supplies[scenario.train.locomotives[i].type];
    msg.loco_litres[i] = supply.computeLitres(state.supply[i]);
    msg.loco_supply_residual[i] = state.supply[i].residual();
  }
  msg.traction_rail = a.traction_rail;
  msg.traction_rim = a.traction_rim;
  msg.slip_loss = a.slip_loss;
  msg.brake_rail = a.brake_rail;
  msg.recovered_rim = a.recovered_rim;
  msg.shoes = a.shoes;
  msg.air_brake = a.air_brake;
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

void toMsg(std::uint64_t run_id, std::uint64_t step, const DriverView& view, train_msgs::DriverView& msg) {
  msg.header.stamp = toStamp(view.t);
  msg.run_id = run_id;
  msg.step = step;
  msg.time = rail::toSeconds(view.t);
  msg.location = view.location_m;
  msg.speed = view.speed_mps;
  msg.grade_force = view.grade_N;
  msg.resistance = view.resistance_N;
  msg.traction = view.traction_N;
  msg.air_brake = view.air_brake_N;
  msg.speed_limit = view.speed_limit_mps;
  msg.pipe_pressure = view.pipe_pressure_Pa;
}

DriverCommand fromMsg(const train_msgs::DriverCommand& msg) {
  DriverCommand command;
  command.notch = msg.notch;
  command.brake_notch = msg.brake_notch;
  command.pipe_pressure_Pa = msg.pipe_pressure;
  command.independent_brake = msg.independent_brake;
  command.emergency = msg.emergency != 0;
  command.sanding = msg.sanding != 0;
  return command;
}

TrainForces forcesAtStart(const Scenario& scenario, const TrainState& state) {
  TrainDynamics dynamics(scenario.train, scenario.track, scenario.driver, scenario.air_brake, scenario.macro_step);
  TrainForces forces;
  dynamics.computeOuterForces(state, forces);
  forces.notch.assign(scenario.train.locomotives.size(), 0);
  forces.brake_notch = forces.notch;
  return forces;
}

}  // namespace ltd
