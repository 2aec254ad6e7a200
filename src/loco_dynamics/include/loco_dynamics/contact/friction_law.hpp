#pragma once

namespace loco {

/// Friction that falls with slip speed.
struct FrictionLaw {
  double mu0 = 0.0;        ///< static friction mu_s [-], > 0
  double A = 1.0;          ///< kinetic over static friction, 0 < A <= 1; 1 is Coulomb's law
  double B_s_per_m = 0.0;  ///< how fast friction falls, >= 0
};

/// Friction at a slip speed.                                                                         (Eq. 2)
///   mu = mu_s ((1 - A) e^(-B w) + A)
/// @param slip_speed_mps  true slip speed w [m/s], >= 0: neither divided by V nor floored
/// @return mu [-]: mu_s at w = 0, A mu_s at high slip
/// Source: Wu et al. 2020, Eq. (2); Polach 2005. One mu for a whole patch. Not modelled: temperature, a film that is
/// rubbed off, differences of slip within the patch.
double computeFriction(const FrictionLaw& law, double slip_speed_mps);

}  // namespace loco
