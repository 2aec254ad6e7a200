#pragma once

#include <cstddef>
#include <optional>

#include "loco_dynamics/profile/profile_points.hpp"

namespace loco {

/// Angle by which a chord between two points may leave the directions of its neighbours.
/// Chosen: the overlap of a loaded wheel falls from 0.09 mm to 0 within 5 mm, by 18 mrad in the mean; a surface that
/// goes astray by more makes peaks of its own in it. Rounding to 0.001 mm makes up to 10 mrad of points 0.2 mm apart.
inline constexpr double kMostAstray_rad = 0.02;

/// Where a profile turns and at once turns back, by more than its curvature on both sides lets expect.
struct StrayChord {
  std::size_t point;  ///< where the chord ends, or the point that stands out
  double angle_rad;
};

/// The worst such place, if it is worse than kMostAstray_rad. With kappa the turn at a point over the mean length of
/// its two chords and h a chord's length, a step is a pair of points i, i+1, a spike is a point i, with
///   min(kappa_i - max(kappa_i-1, kappa_i+2), min(kappa_i-1, kappa_i+2) - kappa_i+1) h                    step
///   min(kappa_i-1, kappa_i+1) - max(kappa_i-2, kappa_i+2), min(kappa_i-2, kappa_i+2) - kappa_i, the lesser, times h
///   spike
/// or the same with all signs turned. Arcs, their joints and inflections have neither, however sharp: kappa passes from
/// one to the next without going beyond both. Chords over 2, 4, 8 points are looked at too, where they are shorter
/// than 1 mm: steps that are spread over some points.
std::optional<StrayChord> findStrayChord(const ProfilePoints& points, std::size_t from);

}  // namespace loco
