#include "ltd_sim/supply_figures.hpp"

namespace ltd {

using State = PowerSupply::State;

const std::array<SupplyFigure, 20> kSupplyFigures = {{
    {"fuel", &State::fuel_J, &PowerSupply::hasEngine},
    {"idle_fuel", &State::idle_fuel_J, &PowerSupply::hasEngine},
    {"engine_loss", &State::engine_loss_J, &PowerSupply::hasEngine},
    {"overload", &State::overload_J, &PowerSupply::exists},
    {"generator", &State::generator_J, &PowerSupply::hasEngine},
    {"generator_loss", &State::generator_loss_J, &PowerSupply::hasEngine},
    {"line_drawn", &State::line_drawn_J, &PowerSupply::hasLine},
    {"line_returned", &State::line_returned_J, &PowerSupply::hasLine},
    {"line_loss", &State::line_loss_J, &PowerSupply::hasLine},
    {"storage_in", &State::storage_in_J, &PowerSupply::hasStorage},
    {"storage_out", &State::storage_out_J, &PowerSupply::hasStorage},
    {"storage_loss", &State::storage_loss_J, &PowerSupply::hasStorage},
    {"stored", &State::stored_J, &PowerSupply::hasStorage},
    {"stored_start", &State::stored_start_J, &PowerSupply::hasStorage},
    {"motored_loss", &State::motored_loss_J, &PowerSupply::exists},
    {"recovered_loss", &State::recovered_loss_J, &PowerSupply::exists},
    {"auxiliaries", &State::auxiliaries_J, &PowerSupply::exists},
    {"auxiliaries_unfed", &State::auxiliaries_unfed_J, &PowerSupply::exists},
    {"to_resistors", &State::to_resistors_J, &PowerSupply::exists},
    {"unserved", &State::unserved_J, &PowerSupply::exists},
}};

}  // namespace ltd
