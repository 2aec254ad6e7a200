#pragma once

#include <string>

#include "rail_core/yaml_reader.hpp"

namespace rail {

/// Coefficients of the running resistances of one vehicle; the laws are in ltd_sim/resistance.hpp (Eqs. 5, 6).
struct ResistanceCoefficients {
  double per_mass_N_per_t = 0.0;               ///< 2.943 in Eq. (5)
  double per_axle_N = 0.0;                     ///< 89.2: m 89.2/m_axle is 89.2 N per axle
  double per_mass_speed_N_per_t_kmph = 0.0;    ///< 0.0306
  double per_speed_squared_N_per_kmph2 = 0.0;  ///< 0.122
  double curving_N_m_per_t = 0.0;              ///< 6116 in Eq. (6)
};

/// What train and locomotive both know of a vehicle. Constant.
struct Vehicle {
  std::string name;
  double mass_kg = 0.0;
  int axles = 0;
  double length_m = 0.0;                 ///< over couplers
  double rotary_mass_kg_per_axle = 0.0;  ///< inertia of wheels and motors as mass at the rail
  ResistanceCoefficients resistance;

  /// Mass that resists acceleration [kg]: with rotary inertia if the scenario counts it.
  double inertialMass(bool rotary_inertia) const {
    return rotary_inertia ? mass_kg + axles * rotary_mass_kg_per_axle : mass_kg;
  }
};

/// Reads a vehicle. A mass must lie between 1 t and 1000 t: chosen, so that tonnes given for kilograms are noticed.
/// Asks `reader` for the keys of a vehicle: name, mass_kg, axles, length_m, rotary_mass_kg_per_axle and the map
/// resistance; leaves finish() to the caller, who knows of further keys.
Vehicle readVehicle(YamlReader& reader);

}  // namespace rail
