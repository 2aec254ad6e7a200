#pragma once

#include "rail_core/yaml_reader.hpp"

namespace ltd {

/// A battery or flywheel on the electrical link. Constant; what it holds [J] is the caller's state.
///   stored += eta_c in,   in  <= P_c H,   stored <= x_max C                                              (F9)
///   stored -= out/eta_d,  out <= P_d H,   stored >= x_min C                                             (F10)
/// in, out: energy at the link. Not modelled: self-discharge, temperature, ageing, efficiency over power and charge.
///
/// YAML `storage`: capacity_J C, lowest_share x_min, highest_share x_max, initial_share, charge_power_W P_c,
/// discharge_power_W P_d, charge_efficiency eta_c, discharge_efficiency eta_d.
class EnergyStorage {
 public:
  static EnergyStorage read(rail::YamlReader reader);

  double initialEnergy() const { return initial_share_ * capacity_J_; }  ///< [J]
  double lowestEnergy() const { return lowest_share_ * capacity_J_; }    ///< [J]
  double highestEnergy() const { return highest_share_ * capacity_J_; }  ///< [J]

  /// At its lowest charge, to round-off: a billionth of the capacity (chosen; 9 J of the example's 2400 kWh).
  bool isEmpty(double stored_J) const { return stored_J <= lowestEnergy() + 1e-9 * capacity_J_; }

  double computeCharge(double stored_J) const { return stored_J / capacity_J_; }  ///< share of the capacity [-]

  /// The most that a step can give to the link, and take from it [J], >= 0.
  double computeLargestOut(double stored_J, double step_s) const;
  double computeLargestIn(double stored_J, double step_s) const;

  /// Gives to the link what is asked, or the most it can. @return what it gave [J]
  double stepOut(double asked_J, double step_s, double& stored_J) const;
  /// Takes from the link what is offered, or the most it can. @return what it took [J]
  double stepIn(double offered_J, double step_s, double& stored_J) const;

  /// Loss of energies given and taken at the link [J], >= 0.                                             (F11)
  double computeLossOut(double out_J) const { return out_J * (1.0 / discharge_efficiency_ - 1.0); }
  double computeLossIn(double in_J) const { return in_J * (1.0 - charge_efficiency_); }

 private:
  double capacity_J_ = 0.0;
  double lowest_share_ = 0.0, highest_share_ = 0.0, initial_share_ = 0.0;
  double charge_power_W_ = 0.0, discharge_power_W_ = 0.0;
  double charge_efficiency_ = 1.0, discharge_efficiency_ = 1.0;
};

}  // namespace ltd
