#pragma once

#include "ltd_sim/efficiency_map.hpp"
#include "rail_core/yaml_reader.hpp"

namespace ltd {

/// A diesel engine that always runs, at the efficiency of its mean power over a macro step. Constant.
///   fuel = max(P / eta(P / P_rated), P_idle) H                                                           (F7)
/// P: power at the shaft. Not modelled: speed, ramp, temperature, stop and start.
///
/// YAML `engine`: rated_power_W, idle_fuel_W, fuel_J_per_l (lower heating value), efficiency ([share, efficiency]).
class DieselEngine {
 public:
  static DieselEngine read(rail::YamlReader reader);

  /// Energy of the fuel [J] burnt in a macro step. @param shaft_work_J  what the shaft gives, >= 0, may exceed the
  /// rated power: then at the efficiency of the rated power. @param step_s  macro step, > 0
  double computeFuel(double shaft_work_J, double step_s) const;

  double ratedPower() const { return rated_power_W_; }         ///< at the shaft [W]
  double fuelEnergyPerLitre() const { return fuel_J_per_l_; }  ///< [J/l]

 private:
  double rated_power_W_ = 0.0, idle_fuel_W_ = 0.0, fuel_J_per_l_ = 0.0;
  EfficiencyMap efficiency_;
};

}  // namespace ltd
