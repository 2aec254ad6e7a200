#pragma once

#include <vector>

#include "loco_dynamics/loco_factory.hpp"
#include "ltd_sim/scenario.hpp"

namespace ltd {

// What the maps of a scenario must be to each other, once each of them is known.

/// Rail sections must lie on the track.
void checkRailSections(rail::YamlReader& root, const std::vector<loco::RailConditions::Section>& sections,
                       const rail::Track& track);
/// The train must stand on the track at the start, and the end must be on it.
void checkPlaces(rail::YamlReader& root, const Scenario& scenario);
/// The couplers' friction and stiffness bound the macro step; see computeStepBound.
void checkStep(rail::YamlReader& root, const Scenario& scenario);
/// What each locomotive's own model refuses: the micro step above all, which its stiffest motion bounds.
void checkLocomotives(const Scenario& scenario, rail::Problems& problems);

}  // namespace ltd
