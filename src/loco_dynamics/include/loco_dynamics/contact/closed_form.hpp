#pragma once

#include "loco_dynamics/contact/contact_patch.hpp"
#include "loco_dynamics/contact/flexibility.hpp"

namespace loco {

/// Share of full slip that a patch of the simplified theory carries without spin: FASTSIM on an infinitely fine grid.
/// (C10)
///   H = 3x/4.  F/(mu N) = 1 for H >= 2, else with t0 = acos(H/2), s0 = sin t0, c0 = H/2
///   F/(mu N) = (4/pi) {2H (s0 - s0^3/3) - H^2 (t0 + s0 c0)/2 + H^3 s0/6 + (4/3) (I4(pi/2) - I4(t0))},
///   I4(t) = 3t/8 + sin(2t)/4 + sin(4t)/32
/// @param x  k G pi a b C11 |xi_x|/(4 mu N) for longitudinal creep, >= 0; full slip at 8/3
/// @return F/(mu N), 0 to 1; 4x/pi for small x
double computeClosedForm(double x);

struct PlaneForce {
  double x_N;
  double y_N;
};

/// Forces on the wheel of a patch without spin. The stress of all strips then has one direction, so that creep along
/// both axes is no harder than along one.
/// @param flexibility  already divided by the reduction factor k
PlaneForce computeClosedForce(const ContactPatch& patch, const Flexibilities& flexibility, const Creepage& creepage,
                              double mu);

}  // namespace loco
