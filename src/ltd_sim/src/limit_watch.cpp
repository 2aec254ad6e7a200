#include "ltd_sim/limit_watch.hpp"

#include <cstdio>

#include "rail_core/constants.hpp"

namespace ltd {

void LimitWatch::look(const DriverView& view) {
  const double excess = view.speed_mps - view.speed_limit_mps;
  const bool now = excess > kTolerance_kmph / rail::kKmphPerMps;
  if (now && !above) ++times;
  above = now;
  if (!now || excess <= excess_mps) return;
  excess_mps = excess;
  location_m = view.location_m;
  speed_mps = view.speed_mps;
  limit_mps = view.speed_limit_mps;
}

std::string LimitWatch::note() const {
  if (times == 0) return {};
  char text[160];
  std::snprintf(text, sizeof text,
                "speed limit exceeded %llu time%s, worst at %.3f km: %.1f km/h where %.1f are allowed",
                static_cast<unsigned long long>(times), times == 1 ? "" : "s", location_m / rail::kMetresPerKilometre,
                speed_mps * rail::kKmphPerMps, limit_mps * rail::kKmphPerMps);
  return text;
}

}  // namespace ltd
