#pragma once

#include <vector>

#include "rail_core/lookup_table.hpp"
#include "rail_core/yaml_reader.hpp"

namespace ltd {

/// What a locomotive's motors can hold back at the rail, by speed and brake notch, before motor response and adhesion.
/// Constant.
///
/// YAML `dynamic_brake`, either `law: limits`:                                                      (D1)
///   F = (n/N) min(F_max fade(v), P/v),   fade = 0 below v_0, 1 from v_1 on, straight between
/// with notches N, largest_force_N F_max, power_at_rail_W P, fade_from_kmph v_1, fade_to_kmph v_0; or `law: table` with
/// `table_file: x.csv`, columns speed_kmph, notch_1_N ... notch_N_N (starts at 0 km/h with no force: motors cannot hold
/// a standing train; rises or stays with the notch); between its speeds linear, beyond the last along the hyperbola of
/// the last row's power. Both with rise_N_per_s, fall_N_per_s (motor response). A default-constructed one is no brake.
/// Source: chosen; the usual shape of diesel-electric and electric dynamic brakes. Not modelled: resistor steps,
/// extended range.
class DynamicBrake {
 public:
  static DynamicBrake read(rail::YamlReader reader);

  /// Retarding force at the rail [N], >= 0; 0 for a train that stands or runs backwards.
  double computeForce(int notch, double v_mps) const;

  /// Force after the motor response: moves from `last_N` towards `target_N` no faster than                     (T4)
  ///   -fall <= dF/dt <= rise                   both forces >= 0
  double computeResponse(double last_N, double target_N, double step_s) const;

  int notches() const { return notches_; }  ///< 0: no brake
  double largestForce() const;              ///< over all speeds and notches [N]

 private:
  void readTable(rail::YamlReader& reader);

  int notches_ = 0;
  double largest_force_N_ = 0.0, power_at_rail_W_ = 0.0, fade_from_mps_ = 0.0, fade_to_mps_ = 0.0;
  double rise_N_per_s_ = 0.0, fall_N_per_s_ = 0.0;
  std::vector<rail::LookupTable> force_of_notch_;  ///< law table: force [N] over speed [m/s], one per notch from 1
};

}  // namespace ltd
