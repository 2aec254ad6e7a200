#pragma once

#include <array>
#include <string>

#include "loco_dynamics/body_layout.hpp"
#include "loco_dynamics/wheelset_contact.hpp"

namespace loco {

/// Watches that wheels stay on their rails.
struct RunningSafety {
  double lift_time_s = 0.1;      ///< chosen: longer than a wheel bounces off a joint
  double climb_rise_m = 0.0157;  ///< WheelRailGeometry::computeClimbRise_m(), here that of S1002
  double drop_m = 0.04;          ///< chosen: a wheelset so far below nominal has fallen between its rails

  /// @param wheel_radius_m   nominal
  /// @param pose_z_m         height of the wheelset over nominal
  /// @param time_in_air_s    of the left and the right wheel; updated for a step of length h
  /// @return empty, or which wheel has left its rail, and how: "wheelset 1, left wheel, at 3.412000 km: ..."
  std::string check(const std::string& wheelset, double location_m, double wheel_radius_m, double pose_z_m, double h,
                    const WheelsetContact::Contacts& contacts, double* time_in_air_s) const;
};

}  // namespace loco
