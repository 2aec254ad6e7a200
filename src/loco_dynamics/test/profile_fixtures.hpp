#pragma once

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "loco_dynamics/contact/hertz.hpp"
#include "loco_dynamics/profile/contact_search.hpp"
#include "loco_dynamics/profile/standard_profiles.hpp"

namespace fixtures {

inline loco::ContactSearch searchOf(const std::string& wheel, const loco::WheelRailDimensions& dimensions = {}) {
  return loco::ContactSearch(
      loco::WheelRailGeometry(loco::makeWheelPoints(wheel), loco::makeRailPoints("UIC60"), dimensions));
}

/// Sum of a wheel's normal forces in T [N] and its contacts.
struct NormalForces {
  double y_N = 0.0, z_N = 0.0;
  std::size_t count = 0;
  std::array<loco::ContactRegion, loco::kMostContacts> regions;
};

inline NormalForces normalForces(const loco::ContactSearch& search, loco::Side side, const loco::WheelsetPose& pose) {
  NormalForces forces;
  forces.count = search.find(side, pose, forces.regions);
  for (std::size_t i = 0; i < forces.count; ++i) {
    const loco::ContactRegion& region = forces.regions[i];
    const double normal_N =
        region.share * loco::HertzContact(region.curvature, {}).computeNormalForce(region.approach_m);
    forces.y_N -= normal_N * std::sin(region.angle_rad);
    forces.z_N += normal_N * std::cos(region.angle_rad);
  }
  return forces;
}

/// Points as the text of a file.
inline std::string csvOf(const loco::ProfilePoints& points) {
  std::string text = "y_mm,z_mm\n";
  for (const loco::ProfilePoint& point : points) {
    std::array<char, 64> line{};
    std::snprintf(line.data(), line.size(), "%.9g,%.9g\n", 1e3 * point.y_m, 1e3 * point.z_m);
    text += line.data();
  }
  return text;
}

}  // namespace fixtures
