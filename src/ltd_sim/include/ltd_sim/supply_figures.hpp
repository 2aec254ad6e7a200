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
inline constexpr std::array<SupplyFigure, 20> kSupplyFigures = {{
    {"fuel", &PowerSupply::State::fuel_J, &PowerSupply::hasEngine},
    {"idle_fuel", &PowerSupply::State::idle_fuel_J, &PowerSupply::hasEngine},
    {"engine_loss", &PowerSupply::State::engine_loss_J, &PowerSupply::hasEngine},
    {"overload", &PowerSupply::State::overload_J, &PowerSupply::hasEngine},
    {"generator", &PowerSupply::State::generator_J, &PowerSupply::hasEngine},
    {"generator_loss", &PowerSupply::State::generator_loss_J, &PowerSupply::hasEngine},
    {"line_drawn", &PowerSupply::State::line_drawn_J, &PowerSupply::hasLine},
    {"line_returned", &PowerSupply::State::line_returned_J, &PowerSupply::hasLine},
    {"line_loss", &PowerSupply::State::line_loss_J, &PowerSupply::hasLine},
    {"storage_in", &PowerSupply::State::storage_in_J, &PowerSupply::hasStorage},
    {"storage_out", &PowerSupply::State::storage_out_J, &PowerSupply::hasStorage},
    {"storage_loss", &PowerSupply::State::storage_loss_J, &PowerSupply::hasStorage},
    {"stored", &PowerSupply::State::stored_J, &PowerSupply::hasStorage},
    {"stored_start", &PowerSupply::State::stored_start_J, &PowerSupply::hasStorage},
    {"motored_loss", &PowerSupply::State::motored_loss_J, &PowerSupply::exists},
    {"recovered_loss", &PowerSupply::State::recovered_loss_J, &PowerSupply::exists},
    {"auxiliaries", &PowerSupply::State::auxiliaries_J, &PowerSupply::exists},
    {"auxiliaries_unfed", &PowerSupply::State::auxiliaries_unfed_J, &PowerSupply::exists},
    {"to_resistors", &PowerSupply::State::to_resistors_J, &PowerSupply::exists},
    {"unserved", &PowerSupply::State::unserved_J, &PowerSupply::exists},
}};

}  // namespace ltd
