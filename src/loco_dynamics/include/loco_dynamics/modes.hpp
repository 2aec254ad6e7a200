#pragma once

#include <string>
#include <vector>

#include "loco_dynamics/linear_model.hpp"

namespace loco {

/// One oscillation of a linear model.
struct Mode {
  std::string name;           ///< "wheelset 2, vertical": the motion with the most kinetic energy
  double frequency_Hz = 0.0;  ///< |lambda|/(2 pi)
  double damping = 0.0;       ///< -Re lambda/|lambda|
  Eigen::VectorXcd shape;     ///< over the model's coordinates, largest 1 [m, rad]
};

/// All modes that oscillate, from low to high frequency: pairs of complex eigenvalues lambda of (L1).         (L2)
/// What creeps back without swinging, and what moves freely, is left out.
std::vector<Mode> computeModes(const LinearModel& model);

/// Name of the coordinate with the most kinetic energy in a shape; of equal ones the first.
std::string nameOfShape(const LinearModel& model, const Eigen::VectorXcd& shape);

}  // namespace loco
