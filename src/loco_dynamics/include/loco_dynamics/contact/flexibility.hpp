#pragma once

#include "loco_dynamics/contact/contact_patch.hpp"

namespace loco {

/// Flexibilities of Kalker's simplified theory, displacement = L x stress [m/Pa], one for each kind of creepage.
struct Flexibilities {
  double l1 = 0.0;  ///< longitudinal
  double l2 = 0.0;  ///< lateral
  double l3 = 0.0;  ///< spin
};

enum class FlexibilityRule {
  kBlended,  ///< three at small creepage, going over to one as the patch slides, as CONTACT does
  kThree     ///< always three, Kalker 1982
};

/// The flexibilities with which the simplified theory gives the forces of the linear theory.             (C6)
///   L1 = 8a/(3 C11 G),   L2 = 8a/(3 C22 G),   L3 = pi a sqrt(a/b)/(4 C23 G)
/// Source: Kalker, Vehicle System Dynamics 11, 1982.
Flexibilities computeFlexibilities(const ContactPatch& patch);

/// Three flexibilities that become one as creepage grows.                                                (C7)
///   L   = (xi_x^2 + xi_y^2 + s^2) / (xi_x^2/L1 + xi_y^2/L2 + s^2/L3),   s = 3 pi a phi/32
///   L_i = (1 - t) L_i + t L,   t = min(1, sqrt((xi_x^2 + xi_y^2 + p^2)/(x1^2 + x2^2 + x3^2))/3),   p = phi x 1 mm
///   x1 = mu_s N/(a b G C11),  x2 = mu_s N/(a b G C22),  x3 = mu_s N/((a b)^1.5 G C23) x 1 mm
/// Three of them are right where the patch sticks, but turn the force away from the slip where it slides, by up to
/// |L1/L2 - 1|. One is right where it slides. With 1 mm the sum has one unit; it is a fixed length, not one of the
/// patch, because CONTACT adds up creepages and spin as numbers in its unit mm.
/// @param mu_static  friction at no slip, which sets the scale
/// Source: CONTACT v25 (E.A.H. Vollebregt), open source, subroutine simpflex; formulas restated in SI.
Flexibilities blendFlexibilities(const Flexibilities& three, const ContactPatch& patch, const Creepage& creepage,
                                 double mu_static);

}  // namespace loco
