#pragma once

#include <vector>

#include "train_viz/shapes.hpp"

namespace viz {

/// One contact of the chosen locomotive; forces act on the wheel, as in train_msgs/ContactAdhesion.
struct Contact {
  double axle_m = 0.0;          ///< the axle, ahead of the locomotive's CoG
  double x_m = 0.0;             ///< ahead of the axle
  double y_m = 0.0, z_m = 0.0;  ///< left of the track's centre, above the rail tops
  double angle_rad = 0.0;       ///< of the contact plane about the track's x axis
  double a_m = 0.0, b_m = 0.0;  ///< semi-axes along and across; 0: no patch is drawn
  double normal_N = 0.0;        ///< >= 0
  double longitudinal_N = 0.0;  ///< + forward
  double lateral_N = 0.0;       ///< + left, in the contact plane
  double friction = 0.0;        ///< that the rail offers [-]

  double computeUse() const;  ///< adhesion used over friction offered [-]
};

struct ContactShape {
  Carrier carrier;                   ///< the locomotive's
  std::vector<Arrow> normal_forces;  ///< on the wheel, along the rail's normal
  std::vector<Arrow> creep_forces;   ///< on the wheel, in the contact plane, in the colour of adhesion used
  std::vector<Cylinder> patches;     ///< contact ellipses, enlarged and flat
};

inline constexpr double kArrow_m_per_N = 1.0e-5;  ///< chosen: 1 m for 100 kN, so a wheel's load is as high as the wheel
inline constexpr double kPatchThickness_m = 0.01;
inline constexpr double kPatchScale = 10.0;  ///< chosen: contacts of 10 mm are seen beside wheels of 1 m

/// @param number      of the locomotive, from 1
/// @param location_m  chainage of its CoG
ContactShape computeContactShape(const rail::WorldTrack& world, int number, double location_m,
                                 const std::vector<Contact>& contacts);

}  // namespace viz
