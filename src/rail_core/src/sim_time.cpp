#include "rail_core/sim_time.hpp"

#include <cmath>

namespace rail {

std::optional<Nanoseconds> wholeNanoseconds(double seconds) {
  constexpr double kTolerance_ns = 1e-3;
  constexpr double kLargest_ns = 9.2e18;  // below 2^63, so that the conversion is defined
  const double exact_ns = seconds * 1e9;
  if (!(std::abs(exact_ns) < kLargest_ns)) return std::nullopt;  // also refuses NaN
  const double rounded_ns = std::round(exact_ns);
  const auto whole = static_cast<Nanoseconds>(rounded_ns);
  // From some hours on a double is coarser than the tolerance: there the nearest double of the whole number must do.
  if (std::abs(exact_ns - rounded_ns) <= kTolerance_ns || toSeconds(whole) == seconds) return whole;
  return std::nullopt;
}

}  // namespace rail
