#pragma once

#include "ltd_sim/scenario.hpp"

namespace ltd {

// What the maps of a scenario must be to each other, once each of them is known.

/// The couplers' friction and stiffness bound the macro step; see computeStepBound.
void checkStep(rail::YamlReader& root, const Scenario& scenario);
/// What each locomotive's own model refuses: the micro step above all, which its stiffest motion bounds.
void checkLocomotives(const Scenario& scenario, rail::Problems& problems);

}  // namespace ltd
