#pragma once

#include <algorithm>

#include "loco_dynamics/exchange.hpp"

namespace ltd {

/// Net work at a locomotive's wheel rims over one step, torque times spin, by its direction. This is the one rule of
/// what is motored and what recovered, for the energy account and for the supply: the sign of the work alone. A
/// locomotive that rolls back under traction turns its motors, so it recovers.
struct RimWork {
  /// @param net_J  + motoring
  explicit RimWork(double net_J) : motored_J(std::max(net_J, 0.0)), recovered_J(std::max(-net_J, 0.0)) {}

  double motored_J;    ///< of the motors on the wheels, >= 0
  double recovered_J;  ///< of the wheels on the motors, >= 0
};

/// Energies of one locomotive since the start of the run [J].
struct LocoEnergy {
  double rail = 0.0;           ///< Eq. (4), sum of F_t S, while it does not brake
  double rim = 0.0;            ///< work at the wheel rims, what the driving motors pay
  double slip = 0.0;           ///< lost between rim and rail to slip, driving and braking
  double brake_rail = 0.0;     ///< taken at the rail by its brakes, motors and shoes together
  double recovered_rim = 0.0;  ///< at the wheel rims, what the braking motors get
  double shoes = 0.0;          ///< heat in its brake shoes
};

/// What one step adds. Negative work at the rail is its brakes', also that of motors which pull while the train rolls
/// back; but a locomotive that coasts (neither traction nor brake asked for, no shoes) takes nothing with a brake: what
/// its wheels' inertia gives and takes is traction of either sign.
/// @param distance_m  of its CoG over the step                                                           Eq. (4)
LocoEnergy computeStepEnergy(const loco::LocoTraction& answer, double distance_m, bool coasts);

LocoEnergy& operator+=(LocoEnergy& sum, const LocoEnergy& step);

}  // namespace ltd
