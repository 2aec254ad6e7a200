#pragma once

namespace adhesion {

/// What limits the torque reference of one axle. Constant.
struct TorqueLimit {
  double wheel_radius_m = 0.0;  ///< r, nominal
  double mass_kg = 0.0;         ///< m of the locomotive
  int axles = 0;                ///< n, all driven
  double adhesion_limit = 0.0;  ///< mu_lim, traction over weight [-]
};

/// Torque reference of one axle: an equal share of the locomotive's, within the adhesion limit.               (A7)
///   T_ref = r F_ref/n,   |T_ref|/r <= mu_lim m g/n
/// The static weight counts: load transfer between the axles is not known here.
/// @param force_reference_N  F_ref of the locomotive [N], > 0 traction, < 0 braking
/// @return torque on the wheelset [N m], + driving forward
/// Source: Wu et al. 2020, Sect. 5 ("a 0.35 adhesion limit was applied" in all three simulations).
double computeTorqueReference(const TorqueLimit& limit, double force_reference_N);

/// The same torque, lowered so that the axle takes no more than its share of the power at the rim (an option). (A8)
///   T_ref omega <= P/n
/// Acts on torque that drives the wheelset; braking torque takes power out and passes.
/// @param omega_radps  spin of the wheelset [rad/s]
/// @param rim_power_limit_W  P of the locomotive [W], >= 0
/// Source: chosen. A constant power at the rim is what an engine gives; without (A8) the power reference is met only
/// as long as the wheels do not slip.
double limitRimPower(const TorqueLimit& limit, double torque_reference_N_m, double omega_radps,
                     double rim_power_limit_W);

/// Dynamic brake at low speed: motors that generate cannot turn a wheel backwards.                          (A11)
///   F = F_ref min(1, max(0, u)/(0.5 m/s))   for F_ref < 0
/// @param reference  force or torque, < 0: dynamic brake; others pass
/// @param rim_speed_mps  u = omega r, + forward
/// Source: chosen. Without it a wheel that locks would be driven backwards; the speed is the floor of slip (A1).
double fadeDynamicBrake(double reference, double rim_speed_mps);

}  // namespace adhesion
