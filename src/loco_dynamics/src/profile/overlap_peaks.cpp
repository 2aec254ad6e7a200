#include "overlap_peaks.hpp"

#include <cmath>

namespace loco {

FlatPlace findFlatPlace(const Overlap& overlap, double low_m, double low_tilt, double high_m, double high_tilt) {
  constexpr int kMostSteps = 24;
  constexpr double kNear_m = 1e-7;
  const bool rises = high_tilt > low_tilt;
  double at_m = low_m - low_tilt * (high_m - low_m) / (high_tilt - low_tilt), next_m = at_m;
  double before_m = 0.0, before_tilt = 0.0;
  Overlap::Value here{};
  for (int step = 0; step < kMostSteps; ++step) {
    at_m = next_m;
    double tilt_slope = 0.0;
    here = overlap.at(at_m, tilt_slope);
    if (step > 0) tilt_slope = (here.tilt - before_tilt) / (at_m - before_m);
    ((here.tilt > 0.0) == rises ? high_m : low_m) = at_m;
    next_m = at_m - here.tilt / tilt_slope;
    // at a joint of arcs the tilt jumps and only halving helps; outside the bracket, or not a number, too
    const bool stuck = step > 0 && std::abs(here.tilt) > 0.5 * std::abs(before_tilt);
    if (stuck || !((next_m - low_m) * (next_m - high_m) <= 0.0)) next_m = 0.5 * (low_m + high_m);
    if (std::abs(next_m - at_m) < kNear_m) break;
    before_m = at_m;
    before_tilt = here.tilt;
  }
  return {at_m, here.overlap_m()};
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
