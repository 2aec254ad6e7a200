#pragma once

namespace ltd {

/// Energy for moving 1000 gross tonnes over one kilometre [kWh per 1000 gross tonne km].                  (F15)
/// @param energy_J  at the stage that the caller names: rail, rim or fuel
/// @param gross_t  mass of the whole train [t], locomotives included; @param distance_km  run so far.
/// Of a train that has not moved there is no such figure: NaN (or an infinity) tells.
double computeKilowattHoursPer1000TonneKm(double energy_J, double gross_t, double distance_km);

/// Fuel for the same [l per 1000 gross tonne km].                                                         (F15)
double computeLitresPer1000TonneKm(double litres, double gross_t, double distance_km);

}  // namespace ltd
