#pragma once

namespace rail {

/// Gravity [m/s^2]. Chosen: the value with which the paper's adhesion limit 0.35 m g of 134 t is 460.09 kN.
inline constexpr double kGravity_mps2 = 9.81;

inline constexpr double kMetresPerKilometre = 1000.0;
inline constexpr double kKmphPerMps = 3.6;
inline constexpr double kKilogramsPerTonne = 1000.0;
inline constexpr double kJoulesPerKilowattHour = 3.6e6;

}  // namespace rail
