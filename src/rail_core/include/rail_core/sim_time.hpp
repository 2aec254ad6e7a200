#pragma once

#include <cstdint>
#include <optional>

namespace rail {

/// Simulation time and step lengths are whole nanoseconds, counted from the start of the run: step k starts at k H
/// exactly, whatever k, and no two nodes can disagree about it.
using Nanoseconds = std::int64_t;

inline constexpr Nanoseconds kNanosecondsPerSecond = 1000000000;

/// @return t [s]; exact to the nearest double.
inline double toSeconds(Nanoseconds t) { return static_cast<double>(t) / 1e9; }

/// The whole number of nanoseconds nearest to `seconds` if it lies within 1e-3 ns of it (a decimal fraction such as
/// 0.002 is not exact in binary), or if `seconds` is the double nearest to it (doubles are coarser than that from 10^4
/// s on), otherwise nothing: 0.3333333333333 s is not a step that two nodes can share.
std::optional<Nanoseconds> wholeNanoseconds(double seconds);

}  // namespace rail
