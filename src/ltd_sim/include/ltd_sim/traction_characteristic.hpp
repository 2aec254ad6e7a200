#pragma once

#include "rail_core/lookup_table.hpp"
#include "rail_core/yaml_reader.hpp"

namespace ltd {

/// What a locomotive's drive can give at the rail, by speed and notch, before motor response and adhesion. Constant.
///
/// YAML `traction`, either `law: limits`:                                                           (T3)
///   F = min((n/N) (F_max - k_f v), (n/N)^2 P / v)
/// with notches N, largest_force_N F_max, force_slope_N_s_per_m k_f, power_at_rail_W P;
/// or `law: table` with `table_file: x.csv`, columns speed_kmph, notch_1_N ... notch_N_N (speed rises, force falls or
/// stays with speed and rises or stays with the notch); between its speeds linear, beyond the last along the hyperbola
/// of the last row's power; then the rim power limit of a notch is the largest F v of its column. Both with
/// rise_N_per_s, fall_N_per_s (motor response). Source: Wu et al. 2020, Sect. 3.1 (look-up by notch and speed, gradual
/// motor response); the law (T3) is the form identified from the paper's Fig. 6.
class TractionCharacteristic {
 public:
  static TractionCharacteristic read(rail::YamlReader reader);

  /// Traction at the rail [N], >= 0. @param notch 0..notches(); @param v_mps running backwards counts as standing.
  double computeForce(int notch, double v_mps) const;
  /// Power that the notch allows at the wheel rims [W].
  double computeRimPowerLimit(int notch) const;

  /// Traction reference after the motor response: moves from `last_N` towards `target_N` no faster than (T4)
  ///   -fall <= dF/dt <= rise
  double computeResponse(double last_N, double target_N, double step_s) const;

  int notches() const { return notches_; }
  double largestForce() const;  ///< over all speeds and notches [N]

 private:
  enum class Law { kLimits, kTable };
  void readTable(rail::YamlReader& reader);

  Law law_ = Law::kLimits;
  int notches_ = 1;
  double largest_force_N_ = 0.0, force_slope_N_s_per_m_ = 0.0, power_at_rail_W_ = 0.0;
  double rise_N_per_s_ = 0.0, fall_N_per_s_ = 0.0;
  std::vector<rail::LookupTable> force_of_notch_;  ///< law table: force [N] over speed [m/s], one per notch from 1
  std::vector<double> power_of_notch_W_;
};

}  // namespace ltd
