#pragma once

#include <array>

#include "loco_dynamics/contact/hertz.hpp"
#include "loco_dynamics/profile/contact_search.hpp"

namespace loco {

/// What a wheelset that stands on its track is asked for.
struct StandingCase {
  double y_m = 0.0;       ///< of the axle centre, + left
  double yaw_rad = 0.0;   ///< + nose left
  double load_N = 0.0;    ///< a wheel: the vertical force of its contacts, > 0
  double friction = 0.3;  ///< of the rolling wheelset; 0: none
};

/// One loaded contact.
struct LoadedPatch {
  ContactRegion region;
  double normal_N = 0.0;                    ///< with the region's share
  HertzContact::Ellipse ellipse{0.0, 0.0};  ///< of the whole region
  double creep_x_N = 0.0,
         creep_y_N = 0.0;  ///< on the wheel, in the contact's frame P (x forward, y left), with the share
};

struct LoadedWheel {
  std::array<LoadedPatch, kMostContacts> patch;
  std::size_t count = 0;
};

/// The pose in which both wheels carry the load, and their contacts.
struct StandingWheelset {
  bool stands = false;  ///< false: no pose was found, as when a wheel falls off its rail
  WheelsetPose pose;
  std::array<LoadedWheel, 2> wheel;  ///< by Side
};

/// Finds height and roll of a wheelset that rolls freely and steadily along straight track, held at y and yaw:
///   sum over a wheel's contacts of (N cos(angle) + F_y sin(angle)) = load,   both wheels                       (G7)
///   sum over all contacts of r F_x = 0
/// with Hertz's normal forces and FASTSIM's creep forces (Coulomb) of the creepages
///   xi_x = 1 - r/r_mean,  xi_y = -yaw/cos(angle),  phi = -sin(angle)/r                                         (G8)
/// r_mean = V/omega follows from the second line. A flange's spin presses the wheel upwards, which takes some of the
/// load off its normal force. Not modelled: other forces on the wheelset, what it does to the pose.
class WheelsetStand {
 public:
  WheelsetStand(const WheelRailGeometry& geometry, const Elasticity& elasticity);
  StandingWheelset compute(const StandingCase& given) const;

 private:
  LoadedWheel loadWheel(Side side, const WheelsetPose& pose, const StandingCase& given, double mean_radius_m) const;
  double computeVertical(Side side, const WheelsetPose& pose, const StandingCase& given, double mean_radius_m) const;
  double findMeanRadius(const WheelsetPose& pose, const StandingCase& given) const;

  ContactSearch search_;
  Elasticity elasticity_;
};

}  // namespace loco
