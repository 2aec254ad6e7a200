#pragma once

#include <optional>

#include "loco_dynamics/profile/profile_curve.hpp"

namespace loco {

/// Depth below the rail's top at which the gauge is measured (EN 13848-1).
inline constexpr double kGaugeDepth_m = 14e-3;

/// The rail leaned 1:inclination to the track's centre (0: upright), its y and z counted from its highest point then.
ProfilePoints inclineRail(const ProfilePoints& points, double inclination);

/// How far the gauge face reaches from the rail's highest point to the track's centre [m], > 0: the farthest place no
/// deeper than kGaugeDepth_m. Nothing if the profile ends above that depth.
std::optional<double> findGaugeFace(const ProfilePoints& inclined_rail);

/// The same for a wheel: how far its flange reaches from the taping line to the track's centre at this depth below it.
std::optional<double> findFlangeFace(const ProfilePoints& wheel, double depth_m);

/// Index of the lowest or highest point.
std::size_t findDeepest(const ProfilePoints& points);
std::size_t findHighest(const ProfilePoints& points);

}  // namespace loco
