#pragma once

#include <string>
#include <vector>

namespace loco {

// Profile frame, for wheel and rail and for both sides alike: y to the FIELD side of the track, z DOWN. A wheel's y is
// counted from its taping line (where z = 0 and its radius is the nominal one), so its flange lies at y < 0 and the
// radius is r0 + z. A rail's y is counted from the middle of its head or, once canted, from its highest point.

/// One point of a cross-section.
struct ProfilePoint {
  double y_m = 0.0;  ///< towards the field side
  double z_m = 0.0;  ///< down
};

/// Points of a wheel or rail, y rising: from the flange's back or the gauge face to the field side.
using ProfilePoints = std::vector<ProfilePoint>;

}  // namespace loco
