#pragma once

#include "rail_core/lookup_table.hpp"
#include "rail_core/yaml_reader.hpp"

namespace ltd {

/// Friction between a brake shoe and the wheel's tread.                                             (B7), (B8)
///   constant   mu
///   karwatzki  mu = 0.6 (16 F/g + 100)/(80 F/g + 100) (V + 100)/(5 V + 100), cast iron; F in kN on one shoe, V in km/h
///   table      mu over V, linear between the points, constant beyond both ends
/// (B7) is Karwatzki's formula, from tests. Not modelled: heat, water, the shoe's wear.
class ShoeFriction {
 public:
  static ShoeFriction constant(double mu);
  static ShoeFriction karwatzki();
  /// @param speed_mps  rises strictly
  static ShoeFriction table(std::vector<double> speed_mps, std::vector<double> mu);

  /// YAML `friction`: {law: constant, mu}, {law: karwatzki} or {law: table, points: [[V in km/h, mu], ...]}.
  static ShoeFriction read(rail::YamlReader reader);

  /// @param shoe_force_N  normal force on one shoe, >= 0
  /// @param v_mps  speed, either sign
  /// @return mu [-]
  double coefficient(double shoe_force_N, double v_mps) const;

 private:
  enum class Law { kConstant, kKarwatzki, kTable };
  Law law_ = Law::kConstant;
  double mu_ = 0.0;
  rail::LookupTable table_;  ///< over the speed in m/s
};

}  // namespace ltd
