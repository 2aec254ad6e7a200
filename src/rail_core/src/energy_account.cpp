#include "rail_core/energy_account.hpp"

namespace rail {

double EnergyAccount::residualRelative() const {
  if (traction_rail > 0.0) return residual() / traction_rail;
  if (brake_rail + air_brake > 0.0) return residual() / (brake_rail + air_brake);
  if (kinetic_start > 0.0) return residual() / kinetic_start;
  return residual();  // over 1 J
}

}  // namespace rail
