#include "rail_core/energy_account.hpp"

#include <algorithm>

namespace rail {

double EnergyAccount::residualRelative() const {
  const double work = std::max(traction_rail, brake_rail + air_brake);
  if (work > 0.0) return residual() / work;
  if (kinetic_start > 0.0) return residual() / kinetic_start;
  return residual();  // over 1 J
}

}  // namespace rail
