#pragma once

#include "loco_dynamics/contact/contact_patch.hpp"

namespace loco {

/// How much softer than Kalker's theory a contact with a third body between wheel and rail is.
struct ReductionFactor {
  double k0 = 1.0;         ///< at no creep, 0 < k0 <= 1; 1 is clean steel
  double alpha_inf = 1.0;  ///< k/k0 at infinite creep, 0 <= alpha_inf <= 1; 1 leaves k = k0 everywhere
  double beta = 0.0;       ///< how fast k falls with eps, >= 0
};

/// Gradient of the tangential stress in the area of adhesion.                                            (C5)
///   eps = k0 G pi a b C11 nu_tot / (4 mu N),   nu_tot = sqrt(xi_x^2 + nu_y^2)
/// nu_y is whichever of xi_y + phi a and xi_y is larger in magnitude. mu is the already fallen friction.
/// Source: Spiryagin, Polach, Cole, Vehicle System Dynamics 51(11) 2013, as documented for CONTACT.
double computeStressGradient(double k0, const ContactPatch& patch, const Creepage& creepage, double mu);

/// Variable reduction factor.                                                                        (Eq. 3)
///   k = k0 (alpha_inf + (1 - alpha_inf)/(1 + beta eps))
/// @return k, 0 < k <= k0: every flexibility of the contact is divided by it
/// Source: as above; the paper's text lost Eq. (3).
double computeReduction(const ReductionFactor& factor, double eps);

}  // namespace loco
