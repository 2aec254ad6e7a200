#pragma once

#include "loco_dynamics/contact/creep_law.hpp"
#include "rail_core/yaml_reader.hpp"

namespace loco {

/// Reads a parameter set of config/adhesion/ and finishes the reader. Keys: name, method (modfastsim, fastsim, closed,
/// polach), friction {mu0, A, B_s_per_m}; for modfastsim and closed reduction {k0, alpha_inf, beta}; for modfastsim and
/// fastsim grid {cells, strips}; for polach polach {k_A, k_S}. All but polach may have flexibility (blended, three).
/// A key of another method is refused: it would do nothing.
CreepLawParameters readCreepLaw(rail::YamlReader reader);

}  // namespace loco
