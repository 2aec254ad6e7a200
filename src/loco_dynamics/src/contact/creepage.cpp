#include "loco_dynamics/contact/creepage.hpp"

#include <algorithm>
#include <cmath>

namespace loco {

Creepage computeCreepage(const SlipVelocity& slip, double speed_mps) {
  const double speed = std::max(std::abs(speed_mps), kCreepageSpeedFloor_mps);
  return {slip.x_mps / speed, slip.y_mps / speed, slip.spin_radps / speed,
          std::sqrt(slip.x_mps * slip.x_mps + slip.y_mps * slip.y_mps)};  // (C4)
}

}  // namespace loco
