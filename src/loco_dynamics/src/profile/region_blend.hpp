#pragma once

#include "region_sums.hpp"

namespace loco {

/// Regions of one wheel, from the flange to the field side.
struct BlendedRegions {
  std::array<RegionShape, kMostContacts> shape;
  std::array<double, kMostContacts> share;
  std::size_t count = 0;
};

/// Makes regions of peaks: near ones are one region, far ones are their own, between there is a blend.
///
/// Each gap between neighbours is cut to the degree sigma, 0 to 1:
///   sigma = step(distance; 4 mm, 8 mm) step(1 - valley/lower peak; 0.35, 0.75),  step cubic from 0 to 1        (G5)
/// Where sigma = 0 both are one. Otherwise each has its own region, whose shape is the mean over all ways to cut, each
/// with its weight (product of sigma where cut, 1 - sigma where not), and its share of the pieces' sums m of e^1.5:
///   share_i = m_i / mean over cuts of (sum of m_j in its piece)                                               (G6)
/// At sigma = 0 the regions are alike and their shares add up to 1, at sigma = 1 every share is 1: nothing jumps.
BlendedRegions blendRegions(const Overlap& overlap, const OverlapPeaks& peaks);

}  // namespace loco
