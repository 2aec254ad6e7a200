#pragma once

#include <algorithm>
#include <cmath>

#include "loco_dynamics/shoe_brake.hpp"

namespace loco {

/// One axle of the 2D locomotive in one micro step. Its creep force is linearly implicit in w where it rises with w,
/// because creep is stiff at low speed and with clean rail. (P2)
struct AxleStep {
  double h, r, m, J;
  double others_N;        ///< along the track, without the contact
  double creep_N, slope;  ///< at the start of the step; dF/dw [N s/m]
  double largest_N;       ///< mu N: the straight line may pass what the law cannot

  double stiffening() const { return 1.0 + slope * h * (r * r / J + 1.0 / m); }
  double line(double torque_N_m) const {
    const double free_rate = r * torque_N_m / J - others_N / m;  // dw/dt without the contact
    return (creep_N + slope * h * free_rate) / stiffening();
  }
  double creepForce(double torque_N_m) const { return std::clamp(line(torque_N_m), -largest_N, largest_N); }

  /// @param torque_N_m  on the wheelset, without shoes and contact
  /// @param turning_radps  of the wheelset against its frame, at the start of the step
  /// @return torque of the shoes, which stops this turning if it can, with the creep force that it leaves      (P3)
  double shoeTorque(double torque_N_m, double turning_radps, double largest_N_m) const {
    if (!(largest_N_m > 0.0)) return 0.0;
    const double free_N_m = J * turning_radps / h + torque_N_m;
    const double left = 1.0 - slope * h * r * r / J / stiffening();  // share of a torque that the contact leaves
    double stopping_N_m = (free_N_m - r * line(torque_N_m)) / left;
    const double held_N = line(torque_N_m - stopping_N_m);
    if (std::abs(held_N) > largest_N) stopping_N_m = free_N_m - r * std::copysign(largest_N, held_N);
    return computeHoldingForce(stopping_N_m, largest_N_m);
  }
};

}  // namespace loco
