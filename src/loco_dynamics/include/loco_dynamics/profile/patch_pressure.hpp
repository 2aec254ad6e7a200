#pragma once

#include <cstddef>

#include "loco_dynamics/profile/standing_wheelset.hpp"

namespace loco {

/// Largest pressure of the contact in which a patch lies [Pa]: of half-spaces with the shape of the profiles where they
/// overlap, not of the patch's ellipse. Patches whose overlaps are less than 4 mm apart are one contact here, with the
/// sum of their loads. For reports: it takes milliseconds. Not modelled: that flange roots are no half-spaces, shear by
/// yaw.
double computePatchPressure(const WheelRailGeometry& geometry, const StandingWheelset& standing, Side side,
                            std::size_t patch, const Elasticity& elasticity);

}  // namespace loco
