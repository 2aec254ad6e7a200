#pragma once

#include <array>

#include "loco_dynamics/body_layout.hpp"
#include "loco_dynamics/suspension.hpp"
#include "rail_core/yaml_reader.hpp"

namespace loco {

/// Where the motors' reaction goes.
enum class MotorReaction {
  kCouple,  ///< a couple on the bogie frame
  kNose     ///< a pair of vertical forces, on the axle and on the frame at the motor's nose
};

/// Bodies and suspension of a locomotive with two bogies of three axles, as its file gives them (config/bodies/*.yaml).
/// The same for the models of 27 and of 54 degrees of freedom. Constant.
struct LocoStructure {
  double wheel_radius_m = 0.0;
  double spin_momentum_inertia_kg_m2 = 0.0;  ///< of a wheelset alone: what makes its gyroscopic moments
  double coupler_x_m = 0.0, coupler_z_m = 0.0;
  std::vector<Body> bodies;
  Suspension suspension;
  MotorReaction motor_reaction = MotorReaction::kCouple;
  std::array<double, BodyLayout::kAxles> motor_nose_x_m{};  ///< from its axle, + forward; not 0 if it is kNose

  double totalMass() const;
  /// How far the car body sinks under the weight of car body and bogie frames [m].
  double computeStaticSag() const;

  /// Reads the map `bodies` of a locomotive and checks it; finishes the reader.
  static LocoStructure read(rail::YamlReader reader);
};

}  // namespace loco
