#pragma once

namespace loco {

/// The march along the strips, in strip units: place u = x/(half chord), stress q = p/(mu p_n at the strip's middle),
/// so that the bound 1 - u^2 is the same for all strips.
struct FastsimMarch {
  int cells;
  const double* place;   ///< u of each cell's middle, from the leading edge to the trailing one
  const double* bound;   ///< 1 - u^2
  int lanes;             ///< strips, a multiple of kFastsimLanes
  const double* step_x;  ///< stress along x that a cell's length adds in adhesion, of each strip
  const double* step_y;  ///< along y, at u = 0
  double step_spin;      ///< what spin adds to step_y per unit of u
  double* sum_x;         ///< results: sums of q over the cells of each strip
  double* sum_y;
};

/// Strips are computed this many at a time, whatever the processor: lanes do not meet, so the bits are the same for all
/// widths of its registers.
inline constexpr int kFastsimLanes = 8;
/// And at most this many in one call: its scratch is on the stack.
inline constexpr int kFastsimMostLanes = 64;

void marchStrips(const FastsimMarch& march);

}  // namespace loco
