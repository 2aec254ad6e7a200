#pragma once

#include <vector>

#include "loco_dynamics/contact/hertz.hpp"

namespace loco {

/// Undeformed bodies that overlap: any shape across, a parabola along the rolling direction.
struct ContactSection {
  double step_m = 0.0;            ///< between places across
  std::vector<double> overlap_m;  ///< at these places; its level does not count, the load decides on the approach
  double along_1pm = 0.0;         ///< relative curvature along the rolling direction
};

/// Normal pressure between two like elastic half-spaces pressed together by a load [Pa]: the largest along each place
/// across, which is that at x = 0. Without friction. For reports: it costs milliseconds and allocates.
/// By cells of constant pressure (Love 1929) and conjugate gradients: Polonsky, Keer, Wear 231 (1999) 206-219.
std::vector<double> computeElasticPressure(const ContactSection& section, double normal_N,
                                           const Elasticity& elasticity);

}  // namespace loco
