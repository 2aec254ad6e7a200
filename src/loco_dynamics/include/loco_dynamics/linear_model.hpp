#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "loco_dynamics/loco_structure.hpp"

namespace loco {

/// One free motion of a locomotive: a degree of freedom of a body.
struct Coordinate {
  std::size_t body = 0;
  Dof dof = kX;
};

/// The same degrees of freedom for every body, body by body. Leave out of the list what is held to the track.
std::vector<Coordinate> allCoordinates(const std::vector<Dof>& dofs);

/// "wheelset 2, vertical".
std::string toWords(const Coordinate& coordinate, const std::vector<Body>& bodies);

/// A wheel on its rail, linear and without friction: spring and damper from the rail to the wheelset, vertical.
struct WheelSpring {
  double stiffness_N_per_m = 0.0;
  double damping_N_s_per_m = 0.0;
  double y_m = 0.75;  ///< of the contact, left and right
};

/// Which tangent a law with corners has in a linear model.
enum class Branch {
  kAtRest,   ///< the one of the static equilibrium, where pins have their clearance
  kStiffest  ///< the steepest that the law has
};

struct LinearOptions {
  Branch branch = Branch::kAtRest;
  bool series_springs = true;  ///< false: the yaw dampers sit in rigid ends
};

/// A locomotive's small motions q about its static equilibrium:                                            (L1)
///   M q'' + C q' + K q + G^T k_s (G q - x) = 0,    c_s x' = k_s (G q - x)
/// x: displacements of the yaw dampers, k_s their springs in series, c_s their slopes. M is diagonal.
/// Not in it: creep forces, gravity's stiffness.
struct LinearModel {
  std::vector<Coordinate> coordinates;
  std::vector<std::string> names;          ///< of the coordinates, in words
  Eigen::VectorXd inertia;                 ///< M's diagonal [kg, kg m^2]
  Eigen::MatrixXd stiffness;               ///< K
  Eigen::MatrixXd damping;                 ///< C
  Eigen::MatrixXd damper_stretch;          ///< G, a row for each yaw damper with a spring in series
  Eigen::VectorXd damper_spring_N_per_m;   ///< k_s
  Eigen::VectorXd damper_slope_N_s_per_m;  ///< c_s

  Eigen::Index size() const { return inertia.size(); }
  Eigen::Index dampers() const { return damper_stretch.rows(); }
};

LinearModel linearise(const LocoStructure& structure, const std::vector<Coordinate>& coordinates,
                      const WheelSpring& wheel, const LinearOptions& options);

}  // namespace loco
