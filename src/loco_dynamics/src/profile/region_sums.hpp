#pragma once

#include "overlap_peaks.hpp"

namespace loco {

/// Where sums of places are counted from: any place near the contact, so that few digits are lost.
struct PlaceOrigin {
  double y_m, z_m;
};

/// Integrals along the rail over the part of a region where wheel and rail overlap. With e = delta (1 - x^2/w^2), as
/// Hertz's bodies would have, the variance of x weighted by e^1.5 is w^2/6, so
///   2 B = 2 delta/w^2 = delta/(3 variance)                                                                  (G3)
/// is the effective curvature of any other region. Place and angle are means weighted by e^2.
/// Both weights were chosen to meet area, aspect, place of non-Hertzian patches (docs/wheel_rail_geometry.md).
struct RegionSums {
  double overlap_m = 0.0;                     ///< delta, the largest overlap
  double mass = 0.0;                          ///< of e^1.5 [m^2.5]
  double mass_y = 0.0, mass_z = 0.0;          ///< of e^1.5 times place on the rail
  double mass_square = 0.0;                   ///< of e^1.5 (y^2 + z^2)
  double weight = 0.0;                        ///< of e^2 [m^3]
  double weight_s = 0.0;                      ///< of e^2 times s
  double weight_up = 0.0, weight_side = 0.0;  ///< of e^2 times the rail's normal

  double computeVariance_m2() const;
};

/// What the sums say of a region; a mean of several shapes is one, too.
struct RegionShape {
  double overlap_m = 0.0;
  double across_1pm = 0.0;      ///< effective curvature, (G3)
  double s_m = 0.0;             ///< place on the wheel
  double up = 0.0, side = 0.0;  ///< mean normal of the rail, not of unit length

  void add(const RegionShape& other, double factor);
};
RegionShape computeShape(const RegionSums& sums);

/// Sums over the peaks first to last as one region.
RegionSums computeRegionSums(const Overlap& overlap, const OverlapPeaks& peaks, std::size_t first, std::size_t last);

}  // namespace loco
