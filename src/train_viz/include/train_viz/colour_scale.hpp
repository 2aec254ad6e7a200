#pragma once

#include "train_viz/shapes.hpp"

namespace viz {

inline constexpr double kFullCouplerForce_N = 1.0e6;  ///< chosen: about what couplers of the paper's train reach

/// Colour of a coupler: grey without force, to red in draft and to blue in buff, full from kFullCouplerForce_N on.
/// @param force_N  + draft, - buff
Colour couplerColour(double force_N);

/// Colour of a contact: green unused, yellow at half, red when all that the rail offers is used, or more.
/// @param use  adhesion used over friction offered [-], >= 0
Colour adhesionColour(double use);

}  // namespace viz
