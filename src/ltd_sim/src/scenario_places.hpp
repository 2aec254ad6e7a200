#pragma once

#include <vector>

#include "loco_dynamics/contact/rail_conditions.hpp"
#include "ltd_sim/scenario.hpp"
#include "rail_core/yaml_reader.hpp"

namespace ltd {

/// Where places may lie, if that is known.
struct Bounds {
  bool known = false;
  double from_m = 0.0, to_m = 0.0;
};

/// Places in km of which each is ahead of the one before; beyond the end of the run they are allowed, so that a run may
/// be shortened without touching them.
/// @return in m
std::vector<double> readLocations(rail::YamlReader& reader, const std::string& key, const Bounds& bounds);

/// The end must be ahead of the start. @param bounds  of the track; a start beyond it is told by checkPlaces
void checkEndIsAhead(rail::YamlReader& root, const RunLimits& run, const Bounds& track);

/// The train must stand on the track at the start, and no vehicle of it be beyond at the end.
void checkPlaces(rail::YamlReader& root, const Scenario& scenario);

void checkRailSections(rail::YamlReader& root, const std::vector<loco::RailConditions::Section>& sections,
                       const rail::Track& track);

}  // namespace ltd
