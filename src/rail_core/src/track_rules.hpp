#pragma once

namespace rail {

// What a track may be. Chosen wide: beyond these a file has its units or columns mixed up.
inline constexpr double kSmallestRadius_m = 50.0;
inline constexpr double kLargestGrade_permille = 100.0;
inline constexpr double kLargestCant_mm = 300.0;

inline constexpr double kPermillePerOne = 1000.0;
inline constexpr double kMillimetresPerMetre = 1000.0;

}  // namespace rail
