#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ltd_sim/coupler.hpp"
#include "ltd_sim/dynamic_brake.hpp"
#include "ltd_sim/power_supply.hpp"
#include "ltd_sim/traction_characteristic.hpp"
#include "ltd_sim/vehicle_brake.hpp"
#include "rail_core/vehicle.hpp"

namespace ltd {

/// One locomotive of the train as LTD knows it.
struct LocoUnit {
  std::size_t vehicle = 0;      ///< index in TrainModel::vehicles, from 0
  std::size_t notch_group = 0;  ///< index in TrainModel::notch_groups
  std::size_t type = 0;         ///< index in TrainModel::traction, ::dynamic_brakes and ::supplies
  double adhesion_limit = 0.0;  ///< of its weight [-]; bounds the coupler forces that a step must bear
  std::string model;            ///< 1d, 2d, ...
  std::string key;              ///< dotted path of its map in the resolved scenario
};

/// The train: what does not change during a run. Vehicles count from the head; coupler i joins vehicles i and i + 1.
struct TrainModel {
  std::string name;
  std::vector<rail::Vehicle> vehicles;
  std::vector<double> inertial_mass_kg;  ///< per vehicle, rotary inertia included if the scenario counts it
  std::vector<VehicleBrake> brakes;      ///< per vehicle; used only by a scenario with an air_brake
  std::vector<Coupler> coupler_types;
  std::vector<std::size_t> coupler_type;   ///< per coupler
  std::vector<double> coupler_distance_m;  ///< per coupler: distance of the two CoGs in mid-slack
  std::vector<TractionCharacteristic> traction;
  std::vector<DynamicBrake> dynamic_brakes;  ///< as `traction`; one without notches where none is given
  std::vector<PowerSupply> supplies;         ///< as `traction`; one that does not exist() where none is given
  std::vector<LocoUnit> locomotives;         ///< from the head
  std::vector<std::string> notch_groups;

  double grossMass_t() const;

  /// Of coupler i, from the middle of its slack [m], + draft. @param s_m  per vehicle
  double couplerElongation(std::size_t i, const std::vector<double>& s_m) const {
    return s_m[i] - s_m[i + 1] - coupler_distance_m[i];
  }

  /// YAML `train`: name, coupler(_file), groups, each group either
  ///   {vehicle(_file), kind: locomotive, count, notch_group, coupler(_file) optional} or
  ///   {vehicle(_file), kind: wagon, count, coupler(_file) optional} or {repeat, groups}.
  /// A group's coupler is the one behind each of its vehicles. A vehicle may have a `brake` (VehicleBrake), a
  /// locomotive a `dynamic_brake` (DynamicBrake) and a `supply` (PowerSupply).
  static TrainModel read(rail::YamlReader reader, const std::string& locomotive_model, bool rotary_inertia);
};

/// The longest macro step that the explicit couplers of this train bear, for a largest coupler force.  (T6)
///   H^2 k + 2 H c < 4,   k = max_i 2 (k_i-1 + k_i)/m_i,  c = max_i 2 (c_i-1 + c_i)/m_i
/// k_i: largest stiffness of the loading curve up to the force, c_i = (1 - u) F/(2 vs): largest slope of the smoothed
/// friction. Gershgorin's bound of the chain's largest eigenvalue in the stability limit of semi-implicit Euler; for
/// equal wagons and friction alone it is m vs/((1 - u) F).
struct StepBound {
  double largest_step_s = 0.0;
  std::size_t vehicle = 0;  ///< the vehicle that sets it
};
StepBound computeStepBound(const TrainModel& train, double coupler_force_N);

/// The coupler force for which the step is checked before a run: the sum of the locomotives' largest tractions after
/// adhesion [N]. A run-in may exceed it; the run then says by how much.
double computeDesignCouplerForce(const TrainModel& train);

}  // namespace ltd
