#include "ltd_sim/energy_figures.hpp"

#include "rail_core/constants.hpp"

namespace ltd {

namespace {

constexpr double kTonneKilometres = 1000.0;  // the unit of the figures, usual for freight

}  // namespace

double computeKilowattHoursPer1000TonneKm(double energy_J, double gross_t, double distance_km) {
  return energy_J / rail::kJoulesPerKilowattHour * kTonneKilometres / (gross_t * distance_km);  // (F15)
}

double computeLitresPer1000TonneKm(double litres, double gross_t, double distance_km) {
  return litres * kTonneKilometres / (gross_t * distance_km);  // (F15)
}

}  // namespace ltd
