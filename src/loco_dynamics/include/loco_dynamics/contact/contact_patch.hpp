#pragma once

#include "loco_dynamics/contact/kalker.hpp"

namespace loco {

// Frame P of a contact: x in rolling direction, z along the rail's outward normal (up), y = z cross x (to the left).
// Every force named here is the one ON THE WHEEL. Kalker's and CONTACT's signs exist in contact_signs.hpp only.

/// An elliptic contact of wheel and rail and the load that it carries.
struct ContactPatch {
  double a_m = 0.0;                ///< semi-axis along x (rolling direction), > 0
  double b_m = 0.0;                ///< semi-axis along y, > 0
  double normal_N = 0.0;           ///< load, >= 0; no load, no force
  double shear_modulus_Pa = 82e9;  ///< G of both bodies; 82 GPa is steel with E = 210 GPa, nu = 0.28
  KalkerCoefficients kalker;       ///< for a_m/b_m and Poisson's ratio
};

/// Patch with its Kalker coefficients. They depend on a/b alone, which load does not change in a Hertzian contact.
ContactPatch makeContactPatch(double a_m, double b_m, double normal_N, double shear_modulus_Pa, double poisson);

/// How the wheel moves over the rail where they touch.
struct Creepage {
  double xi_x = 0.0;            ///< velocity of wheel over rail along x, over the speed V [-]; < 0 when driving
  double xi_y = 0.0;            ///< the same along y [-]
  double phi_1pm = 0.0;         ///< spin: angular velocity of wheel over rail about z, over V [1/m]
  double slip_speed_mps = 0.0;  ///< true slip speed w [m/s], >= 0: decides on friction, Eq. (2); spin does not count
};

/// What a contact answers.
struct CreepForce {
  double x_N = 0.0;        ///< on the wheel, along x: opposes xi_x
  double y_N = 0.0;        ///< on the wheel, along y: opposes xi_y and spin
  double friction = 0.0;   ///< mu of Eq. (2) at this slip speed: what the rail offers [-]
  double reduction = 1.0;  ///< k of Eq. (3) [-]; 1 where the method has none
};

}  // namespace loco
