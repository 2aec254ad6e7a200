#pragma once

#include <algorithm>
#include <cassert>

namespace loco {

/// Dry friction of brake shoes: it opposes the motion with all it has, and what would come to rest within the step it
/// brings to rest and holds there.                                                                           (P3)
///   F = -clamp(F_stop, -F_max, F_max)
/// @param stopping_N  F_stop: what must be taken away so that the motion ends with this step [N or N m], + forward
/// @param largest_N  F_max, >= 0
/// @return on the body, + forward
/// Source: Coulomb's friction, solved for the end of the step: a smoothed sign would let a braked train creep.
inline double computeHoldingForce(double stopping_N, double largest_N) {
  assert(largest_N >= 0.0);
  return -std::clamp(stopping_N, -largest_N, largest_N);
}

}  // namespace loco
