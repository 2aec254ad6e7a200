#include "loco_dynamics/profile/standard_profiles.hpp"

#include <array>
#include <cmath>

namespace loco {

namespace {

constexpr double kMetresPerMillimetre = 1e-3;
constexpr double kWheelBegin_mm = -70.0;  // flange back
constexpr double kWheelEnd_mm = 60.0;
constexpr double kPointStep_mm = 0.2;  // chosen: an arc of 12 mm is met to 1e-5 mm, joints' 0.12 um bend it little

template <std::size_t n>
double polynomial(const std::array<double, n>& coefficients, double x) {
  double value = 0.0;
  for (std::size_t i = n; i-- > 0;) value = value * x + coefficients[i];
  return value;
}

/// Arc of a circle about (y, z): above it (the near side of a rail) or below it (the tip of a flange).
double arcAbove(double y, double z, double radius, double at) {
  return z - std::sqrt(radius * radius - (at - y) * (at - y));
}
double arcBelow(double y, double z, double radius, double at) {
  return z + std::sqrt(radius * radius - (at - y) * (at - y));
}

double s1002RootArc(double s) { return arcAbove(-26.210665, 16.446, 13.0, s); }

template <typename Depth>
void appendPoints(ProfilePoints& points, Depth depth, double begin_mm, double end_mm) {
  for (double at = begin_mm; at < end_mm;) {
    points.push_back({at * kMetresPerMillimetre, depth(at) * kMetresPerMillimetre});
    constexpr double kNear = 1e-4;  // for the slope
    const double slope = at + kNear < end_mm ? (depth(at + kNear) - depth(at)) / kNear : 0.0;
    at += std::min(kPointStep_mm / std::sqrt(1.0 + slope * slope), std::max(end_mm - at, 1e-6));
  }
  points.push_back({end_mm * kMetresPerMillimetre, depth(end_mm) * kMetresPerMillimetre});
}

}  // namespace

double computeS1002Depth_mm(double s) {
  // the highest powers last; UIC 510-2, sections A to H
  static constexpr std::array<double, 9> kTread{0.0,
                                                -3.358537058e-2,
                                                1.565681624e-3,
                                                -2.810427944e-5,
                                                5.844240864e-8,
                                                -1.562379023e-8,
                                                5.309217349e-15,
                                                -5.957839843e-12,
                                                2.646656573e-13};
  static constexpr std::array<double, 8> kRoot{-4.320221063e3,  -1.038384026e3,  -1.065501873e2,  -6.051367875,
                                               -2.054332446e-1, -4.169739389e-3, -4.687195829e-5, -2.252755540e-7};
  if (s >= 32.15796) return 1.364323640 - 0.066666667 * s;
  if (s >= -26.0) return polynomial(kTread, s);
  if (s >= -35.0) return polynomial(kRoot, s);
  if (s >= -38.426669) return s1002RootArc(s);
  if (s >= -39.764473) return -93.576667419 - 2.747477419 * s;  // 70 degrees
  if (s >= -49.662510) return arcBelow(-58.558326413, 8.834924130, 20.0, s);
  if (s >= -62.764706) return arcBelow(-55.0, 16.0, 12.0, s);
  return arcBelow(-49.5, 9.519259302, 20.5, s);
}

double computeConed120Depth_mm(double s) {
  constexpr double kTangent_mm = -26.860;
  constexpr double kRaised_mm = 2.119;
  if (s >= kTangent_mm) return -s / 20.0;
  return (s >= -38.426669 ? s1002RootArc(s) : computeS1002Depth_mm(s)) - kRaised_mm;
}

double computeUic60Depth_mm(double y) {
  const double from_middle = std::abs(y);
  if (from_middle <= 10.5) return arcAbove(0.0, 300.0, 300.0, from_middle);
  if (from_middle <= 26.0) return arcAbove(7.70, 80.13479, 80.0, from_middle);
  return arcAbove(23.02625, 14.91128, 13.0, from_middle);
}

const std::vector<std::string>& wheelProfileNames() {
  static const std::vector<std::string> kNames{"S1002", "coned_1_20"};
  return kNames;
}

const std::vector<std::string>& railProfileNames() {
  static const std::vector<std::string> kNames{"UIC60"};
  return kNames;
}

ProfilePoints makeWheelPoints(const std::string& name) {
  ProfilePoints points;
  if (name == "S1002") appendPoints(points, computeS1002Depth_mm, kWheelBegin_mm + 1e-3, kWheelEnd_mm);
  if (name == "coned_1_20") appendPoints(points, computeConed120Depth_mm, kWheelBegin_mm + 1e-3, kWheelEnd_mm);
  return points;
}

ProfilePoints makeRailPoints(const std::string& name) {
  ProfilePoints points;
  if (name != "UIC60") return points;
  constexpr double kSide_mm = 36.010, kSideTop_mm = 14.2621, kSideEnd_mm = 30.0;
  const auto appendSide = [&points](double sign) {  // 1:20, straight
    for (int i = 1; i <= 8; ++i) {
      const double z = sign < 0.0 ? kSideEnd_mm - (kSideEnd_mm - kSideTop_mm) * (i - 1) / 8.0
                                  : kSideTop_mm + (kSideEnd_mm - kSideTop_mm) * i / 8.0;
      const double y = sign * (kSide_mm + (z - kSideTop_mm) / 20.0);
      points.push_back({y * kMetresPerMillimetre, z * kMetresPerMillimetre});
    }
  };
  appendSide(-1.0);
  appendPoints(points, computeUic60Depth_mm, -kSide_mm, kSide_mm);
  appendSide(1.0);
  return points;
}

}  // namespace loco
