#pragma once

namespace rail {

/// The energy account of the whole train since the start of the run [J]. What comes in is traction; everything else
/// says where it went. Dissipation is >= 0.
///
///   traction = brake_rail + air_brake + propulsion_resistance + curving_resistance + coupler_loss
///            + d(kinetic) + d(potential) + d(coupler_stored) + residual
///
/// Work of a force over a step is force times the mean of the old and the new speed times the step. The grade's work
/// is booked that way too, but the balance uses the height of each vehicle, so that residual tests the integration.
struct EnergyAccount {
  double traction_rail = 0.0;          ///< sum over locomotives of F_t S, Eq. (4), while they do not brake
  double traction_rim = 0.0;           ///< work at the wheel rims, what the driving motors pay
  double slip_loss = 0.0;              ///< lost between rim and rail to slip
  double brake_rail = 0.0;             ///< taken at the rail by the locomotives' brakes, motors and shoes together
  double recovered_rim = 0.0;          ///< of it at the wheel rims, what the braking motors get
  double shoes = 0.0;                  ///< of it heat in the locomotives' brake shoes
  double air_brake = 0.0;              ///< heat in the wagons' brake shoes
  double propulsion_resistance = 0.0;  ///< Eq. (5)
  double curving_resistance = 0.0;     ///< Eq. (6)
  double grade = 0.0;                  ///< work done against gravity, from force times speed
  double coupler_loss = 0.0;           ///< dissipated in the draft gears
  double coupler_stored = 0.0;         ///< elastic energy in the couplers now
  double kinetic = 0.0;                ///< kinetic energy now, rotary inertia included if the scenario says so
  double potential = 0.0;              ///< m g height now
  double kinetic_start = 0.0, potential_start = 0.0, coupler_stored_start = 0.0;

  /// What the account does not explain [J].
  double residual() const {
    return traction_rail - brake_rail - air_brake - propulsion_resistance - curving_resistance - coupler_loss -
           (kinetic - kinetic_start) - (potential - potential_start) - (coupler_stored - coupler_stored_start);
  }
  /// residual over the traction work or the work of the brakes, whichever is larger; without either over the kinetic
  /// energy at the start (a coasting run); else over 1 J, so that a residual from nothing is seen, not hidden [-].
  double residualRelative() const;
};

}  // namespace rail
