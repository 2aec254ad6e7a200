#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "loco_dynamics/profile/contact_region.hpp"
#include "loco_dynamics/profile/reach_table.hpp"
#include "loco_dynamics/profile/wheel_rail_geometry.hpp"

namespace loco {

/// Finds where the wheels of a wheelset overlap their rails (virtual interpenetration). A right wheel is searched as
/// the mirror image of a left one, so that mirrored poses give the same bits. docs/wheel_rail_geometry.md has the
/// theory. Source: Kik, Piotrowski, Proc. 2nd Mini Conf. Contact Mechanics, Budapest 1996 (overlap cut at 0.45 delta).
class ContactSearch {
 public:
  explicit ContactSearch(const WheelRailGeometry& geometry);

  /// Regions in order from the flange to the field side; forces summed over them are continuous in the pose.
  /// @return number of regions found, 0 if the wheel does not touch. Allocates nothing, throws nothing.
  std::size_t find(Side side, const WheelsetPose& pose, std::array<ContactRegion, kMostContacts>& regions) const;

  const WheelRailGeometry& geometry() const { return geometry_; }

 private:
  static constexpr std::size_t kBlock = 8;
  /// Places of the wheel (nodes) at which the search looks first, with what does not depend on the pose.
  struct Block {
    std::array<double, kBlock> s_m, wheel_z_m, wheel_slope, wheel_slope_1pm;
  };
  WheelRailGeometry geometry_;
  std::vector<Block> blocks_;  ///< even along the wheel's surface, from the flange's tip to the field side
  ReachTable reach_;           ///< of each block
};

}  // namespace loco
