#pragma once

#include <cstdint>
#include <vector>

namespace rail {
class Digest;
}

namespace loco {

/// What one axle does at the end of a macro step, in its last micro step. Forces act on the wheelset; a wheel's are
/// left, right.
struct AxleAdhesion {
  /// (omega r - v)/max(v, 0.5 m/s), r nominal [-]; > 0 driving. v is this wheelset's own speed, while the controller's
  /// slip s takes the speed that LTD tells.
  double creep = 0.0;
  double adhesion = 0.0;              ///< used: force along the track over normal force [-]; > 0 driving
  double friction = 0.0;              ///< what the rail offers: mu at this slip speed [-]
  double static_friction = 0.0;       ///< what it would offer without slip: mu0 of the rail at this place [-]
  double normal_force_N = 0.0;        ///< of both wheels, >= 0
  double force_N = 0.0;               ///< of both wheels along the track, + forward
  double torque_reference_N_m = 0.0;  ///< asked for, before control; on the wheelset, + driving forward
  double torque_N_m = 0.0;            ///< applied by the motor
  double shoe_torque_N_m = 0.0;       ///< of the brake shoes, on the wheelset, < 0 rolling forward
  bool controlled = false;            ///< the controller takes torque away
  double frictional_power_W = 0.0;    ///< lost to slip in the contacts, >= 0
  double t_gamma_N = 0.0;  ///< sum of |F_x xi_x + F_y xi_y| over the contacts, energy lost per distance [N = J/m]
  double vertical_force_N[2] = {0.0, 0.0};  ///< up, of all contacts of the wheel
  double lateral_force_N[2] = {0.0, 0.0};   ///< + to the left
};

/// What one contact of a wheel with its rail does at the end of a macro step, in its own frame P (x rolling direction,
/// z outward rail normal). Forces act on the wheel. Models whose wheelsets stay in the middle of the track report none:
/// both wheels have one contact, and both are alike.
struct ContactAdhesion {
  std::uint8_t axle = 0;                   ///< from 1 at the front
  bool right = false;                      ///< of the right wheel
  double x_m = 0.0, y_m = 0.0, z_m = 0.0;  ///< ahead of the axle, left of the track's centre, above the rails
  double angle_rad = 0.0;                  ///< of the contact plane about x; n = (0, -sin, cos)
  double rolling_radius_m = 0.0;
  double a_m = 0.0, b_m = 0.0;        ///< semi-axes along x, across
  double normal_force_N = 0.0;        ///< >= 0
  double longitudinal_force_N = 0.0;  ///< creep force along x
  double lateral_force_N = 0.0;       ///< creep force along y of P
  double xi_x = 0.0, xi_y = 0.0;      ///< creepages [-]
  double phi_1pm = 0.0;               ///< spin [1/m]
  double friction = 0.0;              ///< mu that the rail offers [-]
};

/// What a locomotive tells of its contacts with each answer; empty for models that have none.
struct AdhesionReport {
  std::vector<AxleAdhesion> axles;  ///< from the front
  std::vector<ContactAdhesion> contacts;
};

bool allFinite(const AdhesionReport& report);
void addTo(rail::Digest& digest, const AdhesionReport& report);

}  // namespace loco
