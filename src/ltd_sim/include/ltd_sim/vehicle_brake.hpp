#pragma once

#include <optional>

#include "ltd_sim/brake_cylinder.hpp"
#include "ltd_sim/shoe_friction.hpp"
#include "rail_core/vehicle.hpp"

namespace ltd {

/// The shoes of one vehicle. Default-constructed: a vehicle without a brake.
struct VehicleBrake {
  double shoe_force_N = 0.0;  ///< sum over all shoes at full cylinder pressure, after the rigging's losses
  int shoes = 0;
  ShoeFriction friction;
  std::optional<BrakeCylinder> cylinder;  ///< its own, where it differs from the train's

  bool present() const { return shoes > 0; }

  /// Force at the wheels' treads that the shoes can hold against.                                          (B6)
  ///   F = mu(F_s/n, v) F_s,  F_s = eta F_full p/p_full
  /// @param filled  p/p_full, 0..1
  /// @return largest retarding force [N], >= 0
  double largestRetardation(double filled, double v_mps) const {
    if (!present() || filled <= 0.0) return 0.0;
    const double force_N = filled * shoe_force_N;
    return friction.coefficient(force_N / shoes, v_mps) * force_N;
  }

  /// YAML `brake`: name, shoes, shoe_force_N or brake_ratio (of the weight), rigging_efficiency, friction, cylinder
  /// (optional).
  static VehicleBrake read(rail::YamlReader reader, const rail::Vehicle& vehicle);
};

}  // namespace ltd
