#include "rail_placing.hpp"

#include <algorithm>
#include <cmath>

namespace loco {

namespace {

constexpr double kStep_m = 0.02e-3;  // chosen: less than the points of any profile are apart

bool isHigher(const ProfilePoint& a, const ProfilePoint& b) { return a.z_m < b.z_m; }

/// Chord length, above `low` and below `high`, where the depth passes z_m.
double findDepth(const ProfileCurve& curve, double z_m, double deep, double shallow) {
  constexpr int kHalvings = 50;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (deep + shallow);
    (curve.at(middle).z_m > z_m ? deep : shallow) = middle;
  }
  return 0.5 * (deep + shallow);
}

/// The highest place of the curve about its highest point, where the slope is zero.
ProfileCurve::Value findTop(const ProfileCurve& curve, std::size_t highest) {
  const std::size_t last = curve.points().size() - 1;
  double low = curve.chordAt(highest > 0 ? highest - 1 : 0), high = curve.chordAt(std::min(highest + 1, last));
  constexpr int kHalvings = 60;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (curve.at(middle).dz < 0.0 ? low : high) = middle;
  }
  return curve.at(0.5 * (low + high));
}

}  // namespace

std::size_t findDeepest(const ProfilePoints& points) {
  return static_cast<std::size_t>(std::max_element(points.begin(), points.end(), isHigher) - points.begin());
}

std::size_t findHighest(const ProfilePoints& points) {
  return static_cast<std::size_t>(std::min_element(points.begin(), points.end(), isHigher) - points.begin());
}

ProfilePoints inclineRail(const ProfilePoints& points, double inclination) {
  const double angle = inclination == 0.0 ? 0.0 : std::atan(1.0 / inclination);
  ProfilePoints inclined;
  for (const ProfilePoint& point : points) {
    inclined.push_back({point.y_m * std::cos(angle) + point.z_m * std::sin(angle),
                        -point.y_m * std::sin(angle) + point.z_m * std::cos(angle)});
  }
  const ProfileCurve::Value top = findTop(ProfileCurve(inclined), findHighest(inclined));
  for (ProfilePoint& point : inclined) point = {point.y_m - top.y_m, point.z_m - top.z_m};
  return inclined;
}

std::optional<double> findGaugeFace(const ProfilePoints& inclined_rail) {
  const ProfileCurve curve(inclined_rail);
  double t = curve.chordAt(findHighest(inclined_rail)), reach_m = 0.0;
  for (; t > 0.0 && curve.at(t).z_m < kGaugeDepth_m; t -= kStep_m) reach_m = std::max(reach_m, -curve.at(t).y_m);
  if (t <= 0.0) return std::nullopt;
  return std::max(reach_m, -curve.at(findDepth(curve, kGaugeDepth_m, t, t + kStep_m)).y_m);
}

std::optional<double> findFlangeFace(const ProfilePoints& wheel, double depth_m) {
  const ProfileCurve curve(wheel);
  double t = curve.chordAt(findDeepest(wheel));
  for (; t < curve.length_m(); t += kStep_m) {
    if (curve.at(t).z_m < depth_m) return -curve.at(findDepth(curve, depth_m, t - kStep_m, t)).y_m;
  }
  return std::nullopt;
}

}  // namespace loco
