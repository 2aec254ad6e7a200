#pragma once

#include "loco_dynamics/body_layout.hpp"
#include "loco_dynamics/suspension.hpp"
#include "rail_core/yaml_reader.hpp"

namespace loco {

/// Bodies and suspension of a locomotive with two bogies of three axles, as its file gives them (config/bodies/*.yaml).
/// The same for the models of 27 and of 54 degrees of freedom. Constant.
struct LocoStructure {
  double wheel_radius_m = 0.0;
  double coupler_x_m = 0.0, coupler_z_m = 0.0;
  std::vector<Body> bodies;
  Suspension suspension;

  double totalMass() const;

  /// Reads the map `bodies` of a locomotive and checks it; finishes the reader.
  static LocoStructure read(rail::YamlReader reader);
};

}  // namespace loco
