#include "stray_chord.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace loco {

namespace {

/// Of chords over several points. Chosen: real features, as the lip of a worn head, are longer.
constexpr double kLongestChord_m = 1e-3;
constexpr double kTurn_rad = 6.283185307179586;

/// Points from, from + stride, ... with chords between neighbours and curvatures at the points between them.
struct Chain {
  std::vector<std::size_t> point;
  std::vector<double> length_m;   ///< [i]: of the chord from point i to i + 1
  std::vector<double> kappa_1pm;  ///< [i]: at point i + 1
};

Chain makeChain(const ProfilePoints& points, std::size_t from, std::size_t stride) {
  Chain chain;
  double before_rad = 0.0;
  for (std::size_t i = from; i < points.size(); i += stride) {
    if (i > from) {
      const ProfilePoint &a = points[i - stride], &b = points[i];
      const double direction_rad = std::atan2(b.z_m - a.z_m, b.y_m - a.y_m);
      chain.length_m.push_back(std::hypot(b.y_m - a.y_m, b.z_m - a.z_m));
      const std::size_t chords = chain.length_m.size();
      if (chords > 1) {
        chain.kappa_1pm.push_back(std::remainder(direction_rad - before_rad, kTurn_rad) /
                                  (0.5 * (chain.length_m[chords - 2] + chain.length_m[chords - 1])));
      }
      before_rad = direction_rad;
    }
    chain.point.push_back(i);
  }
  return chain;
}

using Kappas = std::array<double, 5>;

/// Of the step between the middle two of the first four.
double computeStep(const Kappas& k) { return std::min(k[1] - std::max(k[0], k[3]), std::min(k[0], k[3]) - k[2]); }
double computeSpike(const Kappas& k) {
  return std::min(std::min(k[1], k[3]) - std::max(k[0], k[4]), std::min(k[0], k[4]) - k[2]);
}
Kappas negative(Kappas k) {
  for (double& each : k) each = -each;
  return k;
}

void findWorst(const Chain& chain, double longest_m, StrayChord& worst) {
  for (std::size_t i = 0; i + 4 <= chain.kappa_1pm.size(); ++i) {
    Kappas k{};
    const std::size_t count = std::min<std::size_t>(5, chain.kappa_1pm.size() - i);
    std::copy_n(chain.kappa_1pm.begin() + static_cast<std::ptrdiff_t>(i), count, k.begin());
    // the step's chord lies between points i + 2 and i + 3, a spike is point i + 3
    const double length_m = chain.length_m[i + 2];
    if (length_m > longest_m) continue;
    double angle_rad = std::max(computeStep(k), computeStep(negative(k))) * length_m;
    if (count == 5) angle_rad = std::max(angle_rad, std::max(computeSpike(k), computeSpike(negative(k))) * length_m);
    if (angle_rad > worst.angle_rad) worst = {chain.point[i + 3], angle_rad};
  }
}

}  // namespace

std::optional<StrayChord> findStrayChord(const ProfilePoints& points, std::size_t from) {
  StrayChord worst{from, 0.0};
  for (const std::size_t stride : {1U, 2U, 4U, 8U}) {
    const double longest_m = stride == 1 ? std::numeric_limits<double>::infinity() : kLongestChord_m;
    for (std::size_t offset = 0; offset < stride; ++offset) {
      findWorst(makeChain(points, from + offset, stride), longest_m, worst);
    }
  }
  if (worst.angle_rad <= kMostAstray_rad) return std::nullopt;
  return worst;
}

}  // namespace loco
