#pragma once

#include <array>
#include <cstddef>

#include "overlap.hpp"

namespace loco {

/// A local maximum of the overlap and the stretch of wheel around it in which it is the only one.
struct OverlapPeak {
  double s_m;
  double overlap_m;            ///< > 0
  double left_m, right_m;      ///< places beyond which another peak's stretch begins, or where the overlap has ended
  double left_e_m, right_e_m;  ///< overlap there
};

/// More than a worn pair has; what lies further to the field side is left out.
inline constexpr std::size_t kMostPeaks = 8;

struct OverlapPeaks {
  std::array<OverlapPeak, kMostPeaks> peak;
  std::size_t count = 0;
};

/// Where de/ds = 0.
struct FlatPlace {
  double s_m;
  double overlap_m;
};

/// Place in (low, high) where de/ds is 0; its signs at both ends, which are those of the tilts, differ. By the secant
/// method, the first step by Newton's, kept within the bracket, to 1e-7 m, which moves the overlap by 1e-12 m.
FlatPlace findFlatPlace(const Overlap& overlap, double low_m, double low_tilt, double high_m, double high_tilt);

/// Place between a peak and an end of its stretch (e there < 0) where the overlap ends, by Newton's method kept within
/// the bracket, to 1e-5 of the distance from the peak.
double findEdge(const Overlap& overlap, const OverlapPeak& peak, double end_m, double end_e_m);

}  // namespace loco
