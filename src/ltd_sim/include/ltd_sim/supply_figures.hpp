#pragma once

#include <array>

#include "ltd_sim/power_supply.hpp"

namespace ltd {

/// One energy of PowerSupply::State as the results name it: `energy_NAME` in summary.csv, `loco_NAME` in TrainEnergy.
struct SupplyFigure {
  const char* name;
  double PowerSupply::State::*energy_J;
  bool (PowerSupply::*concerns)() const;  ///< the supplies that have it; summary.csv leaves it out for others
};

/// All of them, but the motored and the recovered rim work, which are those of LocoEnergy.
extern const std::array<SupplyFigure, 20> kSupplyFigures;

}  // namespace ltd
