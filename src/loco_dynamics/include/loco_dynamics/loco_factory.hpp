#pragma once

#include <memory>
#include <string>

#include "loco_dynamics/locomotive.hpp"
#include "rail_core/document.hpp"
#include "rail_core/yaml_reader.hpp"

namespace loco {

/// The models that a scenario may name in `locomotive_model`.
const std::vector<std::string>& knownModels();

/// Asks a locomotive's map for adhesion_limit: largest traction over weight [-]; leaves finish() to the caller.
double readAdhesionLimit(rail::YamlReader& reader);

/// Makes the locomotive whose map stands at the dotted path `key` of a resolved scenario, e.g. train.groups.0.vehicle,
/// with the model and options that the scenario's root gives. The whole scenario has been checked by its reader; what
/// is needed here is checked again and goes to `problems`, then the result is null.
std::unique_ptr<Locomotive> makeLocomotive(const rail::Document& scenario, const std::string& key,
                                           rail::Problems& problems);

}  // namespace loco
