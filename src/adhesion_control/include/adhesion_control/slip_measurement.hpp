#pragma once

#include <algorithm>

namespace adhesion {

/// Slip is measured against no less than this speed [m/s]: a standing wheel would have none. Chosen: the floor of the
/// creepages in the contacts.
inline constexpr double kLowestSpeed_mps = 0.5;

/// Slip of one wheelset as a controller measures it, a ratio (the longitudinal creep of the nominal wheel).   (A1)
///   s = (omega r - v) / max(v, 0.5 m/s)
/// @param omega_radps  spin of the wheelset [rad/s], + rolling forward
/// @param v_mps  speed of the train along the track [m/s], + forward
/// @param wheel_radius_m  r, nominal: neither wear nor the place of the contact on the tread is known to the controller
/// @return > 0 slipping (traction), < 0 sliding (braking), -1 for a locked wheel from 0.5 m/s on
/// Source: published ("creepage", Wu et al. 2020), floor chosen. Not modelled: noise and resolution of the sensors, and
/// that a real locomotive must estimate v. A train that rolls backwards counts as standing in the denominator.
inline double computeSlip(double omega_radps, double v_mps, double wheel_radius_m) {
  return (omega_radps * wheel_radius_m - v_mps) / std::max(v_mps, kLowestSpeed_mps);
}

}  // namespace adhesion
