#pragma once

#include "loco_dynamics/contact/contact_patch.hpp"

namespace loco {

/// Below this speed creepage is slip over the floor, so that it stays finite at standstill. Chosen.
inline constexpr double kCreepageSpeedFloor_mps = 0.5;

/// Velocity of the wheel over the rail at their contact, in the contact's frame P (z outward rail normal).
struct SlipVelocity {
  double x_mps = 0.0;       ///< v - omega r for a wheel that rolls on a straight track
  double y_mps = 0.0;       ///< in the contact plane
  double spin_radps = 0.0;  ///< about z: of omega what points along the normal, and the absolute yaw rate
};

/// Creepages of a contact.                                                                               (C4)
///   xi = slip velocity/max(|V|, 0.5 m/s),   w = |slip velocity|, which has no floor
/// @param speed_mps  V, speed of the contact along the track; its sign does not matter
Creepage computeCreepage(const SlipVelocity& slip, double speed_mps);

}  // namespace loco
