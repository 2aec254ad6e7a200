#pragma once

#include "rail_core/vehicle.hpp"

namespace ltd {

/// Magnitude of the propulsion resistance of one vehicle.                                           (Eq. 5)
///   F = m (2.943 + 89.2 / m_a + 0.0306 V + 0.122 V^2 / m)      m, m_a in t, V in km/h, F in N
/// with the four numbers as coefficients of the vehicle (m 89.2/m_a is 89.2 N per axle).
/// @param v_mps  speed along the track [m/s]; its direction does not matter here
/// @return [N], >= 0; it opposes the motion
/// Source: Wu et al. 2020, Eq. (5). Not modelled: wind, tunnels, starting resistance.
double computePropulsionResistance(const rail::Vehicle& vehicle, double v_mps);

/// Magnitude of the curving resistance of one vehicle.                                              (Eq. 6)
///   F = m 6116 |kappa|      m in t, F in N
/// @param curvature_1pm  1/R [1/m], either sign
/// @return [N], >= 0; it opposes the motion
/// Source: Wu et al. 2020, Eq. (6).
double computeCurvingResistance(const rail::Vehicle& vehicle, double curvature_1pm);

/// Force of the grade on one vehicle.
///   F_G = -m g i      i = dz/ds, the rise per distance along the track
/// @return [N], + forward (so < 0 uphill)
double computeGradeForce(const rail::Vehicle& vehicle, double grade);

/// Force of all resistances together on one vehicle, with stiction.                                 (T1)
///   F_res = -clamp(F + m v / H, -R, +R)
/// A moving vehicle feels R against its motion; one that would come to rest within the step is brought to rest exactly;
/// a standing one is held until the other forces exceed R. (A smoothed sign would let it creep on a grade.)
/// @param other_forces_N     sum of all other forces on the vehicle [N], + forward
/// @param resistance_N       R >= 0 [N]
/// @param inertial_mass_kg   m [kg]
/// @param v_mps              speed at the start of the step [m/s]
/// @param step_s             H [s]
/// @return force on the vehicle [N], + forward
/// Source: chosen; Coulomb friction, implicit in the speed.
double computeHeldResistance(double other_forces_N, double resistance_N, double inertial_mass_kg, double v_mps,
                             double step_s);

}  // namespace ltd
