#include "region_blend.hpp"

#include <algorithm>
#include <cmath>

namespace loco {

namespace {

constexpr double kOneBelow_m = 4e-3;  // regions nearer than this are one patch (as CONTACT merges them)
constexpr double kTwoBeyond_m = 8e-3;
// Elastic bodies touch where the undeformed ones overlap by about 0.45 of the largest overlap or more (Kik, Piotrowski
// 1996), so a patch is one while the valley is above that: the step is laid around 1 - 0.45.
constexpr double kOneAboveDepth = 0.35;
constexpr double kTwoBelowDepth = 0.75;
/// Of the regions that find no place beside the largest three, the third one's share goes to 0 where they are equal.
constexpr double kFadeBelow = 0.2;

double step(double x, double begin, double end) {
  const double u = std::min(std::max((x - begin) / (end - begin), 0.0), 1.0);
  return u * u * (3.0 - 2.0 * u);
}

/// Neighbouring peaks that are wholly one.
struct Group {
  std::size_t first, last, highest;  ///< peaks
  double cut = 0.0;                  ///< sigma of the gap behind it
  double mass = 0.0;                 ///< of its own e^1.5
};
struct Groups {
  std::array<Group, kMostPeaks> group;
  std::size_t count = 0;
};

/// sigma between two peaks.
double computeCut(const Overlap& overlap, const OverlapPeak& left, const OverlapPeak& right, double valley_m) {
  const double lower_m = std::min(left.overlap_m, right.overlap_m);
  const double depth = step(1.0 - std::max(valley_m, 0.0) / lower_m, kOneAboveDepth, kTwoBelowDepth);
  if (depth == 0.0) return 0.0;
  const Overlap::Place a = overlap.placeAt(left.s_m), b = overlap.placeAt(right.s_m);
  return depth * step(std::hypot(b.y_m - a.y_m, b.rail_z_m - a.rail_z_m), kOneBelow_m, kTwoBeyond_m);  // (G5)
}

Groups groupPeaks(const Overlap& overlap, const OverlapPeaks& peaks) {
  Groups groups;
  groups.group[0] = {0, 0, 0};
  groups.count = 1;
  for (std::size_t i = 1; i < peaks.count; ++i) {
    Group& last = groups.group[groups.count - 1];
    last.cut = computeCut(overlap, peaks.peak[last.highest], peaks.peak[i], peaks.peak[i].left_e_m);
    if (last.cut > 0.0) {
      groups.group[groups.count++] = {i, i, i};
    } else {
      last.last = i;
      if (peaks.peak[i].overlap_m > peaks.peak[last.highest].overlap_m) last.highest = i;
    }
  }
  return groups;
}

/// For each group the mean, over all ways to cut, of its piece's shape and of the sum of that piece's masses.
struct Means {
  std::array<RegionShape, kMostPeaks> shape;
  std::array<double, kMostPeaks> mass{};
};

Means computeMeans(const Overlap& overlap, const OverlapPeaks& peaks, const Groups& groups,
                   const std::array<RegionShape, kMostPeaks>& own) {
  Means means;
  for (std::size_t first = 0; first < groups.count; ++first) {
    double uncut_weight = first > 0 ? groups.group[first - 1].cut : 1.0, mass = 0.0;
    for (std::size_t last = first; last < groups.count && uncut_weight > 0.0; ++last) {  // a piece: first to last
      const Group& group = groups.group[last];
      const double cut = last + 1 < groups.count ? group.cut : 1.0;
      const double weight = uncut_weight * cut;
      mass += group.mass;
      if (weight > 0.0) {
        const RegionShape shape =
            first == last ? own[first]
                          : computeShape(computeRegionSums(overlap, peaks, groups.group[first].first, group.last));
        for (std::size_t i = first; i <= last; ++i) {
          means.shape[i].add(shape, weight);
          means.mass[i] += weight * mass;
        }
      }
      uncut_weight *= 1.0 - cut;
    }
  }
  return means;
}

/// Takes the least region out until three are left.
void keepLargest(std::array<RegionShape, kMostPeaks>& shapes, std::array<double, kMostPeaks>& share, Groups& groups) {
  while (groups.count > kMostContacts) {
    const auto end = groups.group.begin() + static_cast<std::ptrdiff_t>(groups.count);
    const auto least =
        std::min_element(groups.group.begin(), end, [](const Group& a, const Group& b) { return a.mass < b.mass; });
    const double mass = least->mass;
    const auto at = static_cast<std::size_t>(least - groups.group.begin());
    for (std::size_t i = at; i + 1 < groups.count; ++i) {
      groups.group[i] = groups.group[i + 1];
      shapes[i] = shapes[i + 1];
      share[i] = share[i + 1];
    }
    --groups.count;
    for (std::size_t i = 0; i < groups.count; ++i) share[i] *= step(1.0 - mass / groups.group[i].mass, 0.0, kFadeBelow);
  }
}

}  // namespace

BlendedRegions blendRegions(const Overlap& overlap, const OverlapPeaks& peaks) {
  BlendedRegions regions;
  if (peaks.count == 0) return regions;
  Groups groups = groupPeaks(overlap, peaks);
  std::array<RegionShape, kMostPeaks> own;
  for (std::size_t i = 0; i < groups.count; ++i) {
    const RegionSums sums = computeRegionSums(overlap, peaks, groups.group[i].first, groups.group[i].last);
    groups.group[i].mass = sums.mass;
    own[i] = computeShape(sums);
  }
  if (groups.count == 1) {
    regions.shape[0] = own[0];
    regions.share[0] = 1.0;
    regions.count = 1;
    return regions;
  }
  Means means = computeMeans(overlap, peaks, groups, own);
  std::array<double, kMostPeaks> share{};
  for (std::size_t i = 0; i < groups.count; ++i) share[i] = groups.group[i].mass / means.mass[i];  // (G6)
  keepLargest(means.shape, share, groups);
  for (; regions.count < groups.count; ++regions.count) {
    regions.shape[regions.count] = means.shape[regions.count];
    regions.share[regions.count] = share[regions.count];
  }
  return regions;
}

}  // namespace loco
