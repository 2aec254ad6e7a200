#include "loco_dynamics/contact/contact_signs.hpp"

#include <cmath>

namespace loco {

Creepage fromContactSigns(const ContactCreepage& creepage, double speed_mps) {
  const double magnitude = std::sqrt(creepage.creep_x * creepage.creep_x + creepage.creep_y * creepage.creep_y);
  return {creepage.creep_x, -creepage.creep_y, -creepage.spin_rad_per_m, speed_mps * magnitude};
}

ContactForce toContactSigns(const CreepForce& force) { return {force.x_N, -force.y_N}; }

}  // namespace loco
