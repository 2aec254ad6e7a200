#pragma once

#include "loco_dynamics/contact/closed_form.hpp"
#include "loco_dynamics/contact/contact_patch.hpp"

namespace loco {

/// Reduction of Kalker's stiffness in the areas of adhesion and of slip, for contacts that are not clean.
struct PolachFactors {
  double k_A = 1.0;  ///< adhesion, 0 < k_A <= 1
  double k_S = 1.0;  ///< slip, 0 < k_S <= k_A
};

/// Polach's creep forces, without a grid. On the wheel:                                               (C11), (C12)
///   F = (2 mu N/pi) (k_A e/(1 + (k_A e)^2) + atan(k_S e)),   e = G pi a b C s_c/(4 mu N)
///   C = sqrt((C11 xi_x)^2 + (C22 xi_y)^2)/s,   s^2 = xi_x^2 + xi_y^2,   s_c^2 = xi_x^2 + s_yc^2
///   s_yc = xi_y + phi a or xi_y, whichever is larger in magnitude
///   F_x = -F xi_x/s_c,   F_y = -F xi_y/s_c + spin's share
///   spin's share = (9/16) a mu N K (1 + 6.3 (1 - e^(-a/b))) phi/s_c
///   K = |e_s| (d^3/3 - d^2/2 + 1/6) - sqrt((1 - d^2)^3)/3,   d = (e_s^2 - 1)/(e_s^2 + 1)
///   e_s = (8/3) G b sqrt(a b) C23 s_yc/(mu N) (k_A + k_S)/2/(1 + 6.3 (1 - e^(-a/b)))
/// The sign of spin's share is such that small spin gives Kalker's force; how k_A and k_S enter e_s is chosen such that
/// they reduce it like the slope of F. |F_x, F_y| is cut at mu N, which spin's share may pass.
/// Source: Polach, Vehicle System Dynamics Suppl. 33, 1999 (spin); Polach, Wear 258, 2005 (k_A, k_S).
PlaneForce computePolachForce(const ContactPatch& patch, const PolachFactors& factors, const Creepage& creepage,
                              double mu);

}  // namespace loco
