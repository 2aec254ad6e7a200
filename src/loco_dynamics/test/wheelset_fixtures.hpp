#pragma once

#include "loco_3d_fixtures.hpp"
#include "loco_dynamics/wheelset_contact.hpp"

/// One wheelset on its rails.
namespace fixtures {

constexpr double kWheelRadius_m = 0.5335;
constexpr double kAxleLoad_N = kWeight_N / 6.0;

inline loco::RailConditions paperRail() {
  loco::RailConditions rail;
  rail.elsewhere = readFile("/adhesion/paper_table1.yaml", loco::readCreepLaw);
  return rail;
}

/// Clean steel: Kalker's stiffness, friction 0.4.
inline loco::RailConditions cleanRail() {
  loco::RailConditions rail = paperRail();
  rail.elsewhere.friction = {0.4, 1.0, 0.0};
  rail.elsewhere.reduction = {1.0, 1.0, 0.0};
  return rail;
}

template <typename Search>
loco::WheelsetContact contactOf(Search search, const loco::RailConditions& rail = paperRail(), double damping = 100e3) {
  return {{kWheelRadius_m, damping, {210e9, 0.28}, 82e9}, rail, finderOf(search)};
}

inline loco::WheelsetMotion rolling(double v_mps, double yaw_rad = 0.0) {
  loco::WheelsetMotion motion;
  motion.q.setZero();
  motion.v.setZero();
  motion.q[loco::kYaw] = yaw_rad;
  motion.v[loco::kX] = v_mps;
  motion.v[loco::kPitch] = v_mps / kWheelRadius_m;
  return motion;
}

}  // namespace fixtures
