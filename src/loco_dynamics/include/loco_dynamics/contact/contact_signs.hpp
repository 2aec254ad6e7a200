#pragma once

#include "loco_dynamics/contact/contact_patch.hpp"

namespace loco {

// The one place where CONTACT's signs meet ours. CONTACT's tables name the velocity of body 1 relative to body 2 and
// the force on body 1, in axes with x in rolling direction, y to the right and z down. Body 1 is our wheel; the axes
// differ from frame P by half a turn about x, so whatever points along y or z changes its sign, twice over:
//   w_x = creep_x - spin y and w_y = creep_y + spin x read the same in both, and creep_x > 0 gives F_x < 0 in both.

/// Creepage and spin as CONTACT has them.
struct ContactCreepage {
  double creep_x = 0.0;         ///< [-]
  double creep_y = 0.0;         ///< [-], + right
  double spin_rad_per_m = 0.0;  ///< [1/m], + about the axis that points down
};

/// Force on body 1 as CONTACT has it.
struct ContactForce {
  double x_N = 0.0;
  double y_N = 0.0;  ///< + right
};

/// @param speed_mps  V [m/s], >= 0, which makes the true slip speed of the creepage; no floor
Creepage fromContactSigns(const ContactCreepage& creepage, double speed_mps);

ContactForce toContactSigns(const CreepForce& force);

}  // namespace loco
