#include "track_profile.hpp"

#include <cmath>
#include <limits>

namespace rail {

void appendSegment(std::vector<Segment>& segments, const Segment& next) {
  if (!segments.empty() && segments.back().s_m == next.s_m) segments.pop_back();
  if (!segments.empty()) {
    const Segment& last = segments.back();
    if (last.slope == 0.0 && next.slope == 0.0 && last.value == next.value) return;
  }
  segments.push_back(next);
}

double cleanChainage(double s_m) {
  constexpr double kPerMetre = 1e6;        // chosen: surveys do not know micrometres
  constexpr double kRoundingErrors = 4.0;  // chosen: a product and a sum or two
  const double clean_m = std::round(s_m * kPerMetre) / kPerMetre;
  const double tolerance_m = kRoundingErrors * std::numeric_limits<double>::epsilon() * std::abs(s_m);
  return std::abs(clean_m - s_m) <= tolerance_m ? clean_m : s_m;
}

}  // namespace rail
