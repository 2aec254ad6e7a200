#include "region_sums.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loco {

namespace {

/// Gauss and Legendre's rule of ten points: half of its nodes on (-1, 1) and their weights (Abramowitz, Stegun 25.4.29).
struct GaussNode {
  double place, weight;
};
constexpr std::array<GaussNode, 5> kGauss{{{0.148874338981631211, 0.295524224714752870},
                                           {0.433395394129247191, 0.269266719309996355},
                                           {0.679409568299024406, 0.219086362515982044},
                                           {0.865063366688984511, 0.149451349150580593},
                                           {0.973906528517171720, 0.066671344308688138}}};

void addPlace(RegionSums& sums, const Overlap& overlap, const PlaceOrigin& origin, double s_m, double weight_m) {
  const Overlap::Place place = overlap.placeAt(s_m);
  const double e_m = std::max(place.overlap_m, 0.0);
  const double length_m = weight_m * place.rail_length;
  const double mass = e_m * std::sqrt(e_m) * length_m, weight = e_m * e_m * length_m;
  const double y_m = place.y_m - origin.y_m, z_m = place.rail_z_m - origin.z_m;
  sums.mass += mass;
  sums.mass_y += mass * y_m;
  sums.mass_z += mass * z_m;
  sums.mass_square += mass * (y_m * y_m + z_m * z_m);
  sums.weight += weight;
  sums.weight_s += weight * s_m;
  sums.weight_up += weight * place.rail_cos;
  sums.weight_side += weight * place.rail_cos * place.rail_slope;
}

void addPeak(RegionSums& sums, const Overlap& overlap, const OverlapPeak& peak, const PlaceOrigin& origin) {
  const double left_m = peak.left_e_m < 0.0 ? findEdge(overlap, peak, peak.left_m, peak.left_e_m) : peak.left_m;
  const double right_m = peak.right_e_m < 0.0 ? findEdge(overlap, peak, peak.right_m, peak.right_e_m) : peak.right_m;
  const double middle_m = 0.5 * (left_m + right_m), half_m = 0.5 * (right_m - left_m);
  for (const GaussNode& node : kGauss) {
    addPlace(sums, overlap, origin, middle_m - half_m * node.place, half_m * node.weight);
    addPlace(sums, overlap, origin, middle_m + half_m * node.place, half_m * node.weight);
  }
}

}  // namespace

void RegionSums::add(const RegionSums& other, double factor) {
  overlap_m += factor * other.overlap_m;
  mass += factor * other.mass;
  mass_y += factor * other.mass_y;
  mass_z += factor * other.mass_z;
  mass_square += factor * other.mass_square;
  weight += factor * other.weight;
  weight_s += factor * other.weight_s;
  weight_up += factor * other.weight_up;
  weight_side += factor * other.weight_side;
}

double RegionSums::computeVariance_m2() const {
  const double y_m = mass_y / mass, z_m = mass_z / mass;
  return mass_square / mass - (y_m * y_m + z_m * z_m);
}

RegionSums computeRegionSums(const Overlap& overlap, const OverlapPeaks& peaks, std::size_t first, std::size_t last) {
  const Overlap::Place near = overlap.placeAt(peaks.peak[0].s_m);
  RegionSums sums;
  for (std::size_t i = first; i <= last; ++i) {
    sums.overlap_m = std::max(sums.overlap_m, peaks.peak[i].overlap_m);
    addPeak(sums, overlap, peaks.peak[i], {near.y_m, near.rail_z_m});
  }
  return sums;
}

}  // namespace loco
