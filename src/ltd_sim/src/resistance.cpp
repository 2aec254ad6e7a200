#include "ltd_sim/resistance.hpp"

#include <algorithm>
#include <cmath>

#include "rail_core/constants.hpp"

namespace ltd {

double computePropulsionResistance(const rail::Vehicle& vehicle, double v_mps) {
  const rail::ResistanceCoefficients& c = vehicle.resistance;
  const double m = vehicle.mass_kg / rail::kKilogramsPerTonne;
  const double V = std::abs(v_mps) * rail::kKmphPerMps;
  return m * (c.per_mass_N_per_t + c.per_mass_speed_N_per_t_kmph * V) + vehicle.axles * c.per_axle_N +
         c.per_speed_squared_N_per_kmph2 * V * V;  // Eq. (5)
}

double computeCurvingResistance(const rail::Vehicle& vehicle, double curvature_1pm) {
  const double m = vehicle.mass_kg / rail::kKilogramsPerTonne;
  return m * vehicle.resistance.curving_N_m_per_t * std::abs(curvature_1pm);  // Eq. (6)
}

double computeGradeForce(const rail::Vehicle& vehicle, double grade) {
  return -vehicle.mass_kg * rail::kGravity_mps2 * grade;
}

double computeHeldResistance(double other_forces_N, double resistance_N, double inertial_mass_kg, double v_mps,
                             double step_s) {
  const double needed = other_forces_N + inertial_mass_kg * v_mps / step_s;  // to be at rest at the end of the step
  return -std::clamp(needed, -resistance_N, resistance_N);                   // (T1)
}

}  // namespace ltd
