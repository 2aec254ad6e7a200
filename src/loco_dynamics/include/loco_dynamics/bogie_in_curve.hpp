#pragma once

#include <memory>

#include "loco_dynamics/loco_structure.hpp"
#include "loco_dynamics/profile/wheel_rail_geometry.hpp"
#include "rail_core/track.hpp"
#include "rail_core/yaml_reader.hpp"

namespace loco {

/// A wheelset's play between its rails [m]: the gauge less the distance over its flanges, 10 mm below the taping line.
double computeFlangePlay_m(const WheelRailGeometry& geometry);

/// The tightest curve into which a bogie fits that gives nothing sideways: its outer wheelsets touch the outer rail,
/// the middle of its wheelbase lies w^2/(8 R) further inside and may use the whole play.
///   R = w^2/(8 play)
double computeSmallestRadius_m(double wheelbase_m, double flange_play_m);

/// The scenario's `track`, if these bogies fit into all its curves; else null, and the curves are refused.
std::shared_ptr<const rail::Track> readTrackForBogies(rail::YamlReader& root, const LocoStructure& structure,
                                                      double flange_play_m);

}  // namespace loco
