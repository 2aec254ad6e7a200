#include "overlap_peaks.hpp"

#include <cmath>

namespace loco {

double findFlatPlace(const Overlap& overlap, double low_m, double low_tilt, double high_m, double high_tilt) {
  constexpr int kMostSteps = 12;
  constexpr double kNear_m = 1e-7;
  double at_m = low_m;
  for (int step = 0; step < kMostSteps; ++step) {
    const double before_m = at_m;
    at_m = low_m - low_tilt * (high_m - low_m) / (high_tilt - low_tilt);
    if (step > 0 && std::abs(at_m - before_m) < kNear_m) break;
    const double tilt = overlap.at(at_m).tilt;
    if ((tilt > 0.0) == (high_tilt > 0.0)) {
      high_m = at_m;
      high_tilt = tilt;
      low_tilt *= 0.5;  // so that the other end moves, too
    } else {
      low_m = high_m;
      low_tilt = high_tilt;
      high_m = at_m;
      high_tilt = tilt;
    }
  }
  return at_m;
}

double findEdge(const Overlap& overlap, const OverlapPeak& peak, double end_m, double end_e_m) {
  constexpr int kMostSteps = 20;
  constexpr double kNear = 1e-5;
  double inside_m = peak.s_m, outside_m = end_m;
  // first guess: a parabola with its vertex at the peak
  double at_m = inside_m + (end_m - inside_m) * std::sqrt(peak.overlap_m / (peak.overlap_m - end_e_m));
  for (int step = 0; step < kMostSteps; ++step) {
    const Overlap::Value value = overlap.at(at_m);
    (value.depth_m > 0.0 ? inside_m : outside_m) = at_m;
    double next_m = at_m + value.newtonStep_m();
    if (!((next_m - inside_m) * (next_m - outside_m) <= 0.0)) next_m = 0.5 * (inside_m + outside_m);
    const double moved_m = std::abs(next_m - at_m);
    at_m = next_m;
    if (moved_m <= kNear * std::abs(at_m - peak.s_m)) break;
  }
  return at_m;
}

}  // namespace loco
