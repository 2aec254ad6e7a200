#pragma once

#include "rail_core/yaml_reader.hpp"

namespace ltd {

/// One vehicle's brake cylinder: it follows the pressure that its valve asks for, at limited rates.       (B5)
///   filling    0.95 p_full / t_fill           t_fill: from empty to 95 % of the full pressure
///   releasing  (p_full - 0.4 bar) / t_release t_release: from full to 0.4 bar
/// Definition of the two times: UIC 540. Not modelled: the piston's stroke and return spring, leakage.
class BrakeCylinder {
 public:
  struct Parameters {
    double full_Pa = 0.0;
    double fill_time_s = 0.0;
    double emergency_fill_time_s = 0.0;
    double release_time_s = 0.0;
  };
  BrakeCylinder() = default;
  explicit BrakeCylinder(const Parameters& parameters);

  /// YAML `cylinder`: position (G, P: the times must lie in UIC 540's ranges; other), full_bar, fill_time_s,
  /// emergency_fill_time_s <= fill_time_s, release_time_s.
  static BrakeCylinder read(rail::YamlReader reader);

  /// @param asked_Pa  pressure that the valve asks for, 0..full
  /// @return pressure after `step_s` [Pa]
  double next(double pressure_Pa, double asked_Pa, bool emergency, double step_s) const;

  double full() const { return full_Pa_; }

 private:
  double full_Pa_ = 0.0;
  double fill_Pa_per_s_ = 0.0;
  double emergency_fill_Pa_per_s_ = 0.0;
  double release_Pa_per_s_ = 0.0;
};

}  // namespace ltd
