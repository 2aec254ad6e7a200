#include "region_sums.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loco {

namespace {

/// Gauss and Legendre's rule of eight points on (-1, 1), from the middle outwards (Abramowitz, Stegun 25.4.29).
constexpr std::size_t kGauss = 8;
constexpr std::array<double, kGauss> kGaussPlace{-0.183434642495649805, 0.183434642495649805,  //
                                                 -0.525532409916328986, 0.525532409916328986,  //
                                                 -0.796666477413626740, 0.796666477413626740,  //
                                                 -0.960289856497536232, 0.960289856497536232};
constexpr std::array<double, kGauss> kGaussWeight{0.362683783378361983, 0.362683783378361983,  //
                                                  0.313706645877887287, 0.313706645877887287,  //
                                                  0.222381034453374471, 0.222381034453374471,  //
                                                  0.101228536290376259, 0.101228536290376259};

// Stretches are cut at multiples of this, fixed on the wheel: where an end passes a cut, the sums go on smoothly.
// Chosen: longer ones smear the jumps of curvature between a profile's arcs.
constexpr double kPanel_m = 6e-3;

/// Adds the places of one panel.
void addPanel(RegionSums& sums, const Overlap& overlap, const PlaceOrigin& origin, double middle_m, double half_m) {
  std::array<double, kGauss> mass, weight, y_m, z_m, up, side;
  Overlap::Lanes<kGauss> at;
  for (std::size_t i = 0; i < kGauss; ++i) at.s_m[i] = middle_m + half_m * kGaussPlace[i];
  overlap.lookUpWheel(at);
  overlap.computeLanes(at);
  for (std::size_t i = 0; i < kGauss; ++i) {
    const double slope_length = std::sqrt(1.0 + at.rail_slope[i] * at.rail_slope[i]), rail_cos = 1.0 / slope_length;
    const double e_m = std::max((at.d_m[i] - at.rail_z_m[i]) * rail_cos, 0.0);
    const double length_m = half_m * kGaussWeight[i] * (slope_length * at.y_slope[i]);
    mass[i] = e_m * std::sqrt(e_m) * length_m;
    weight[i] = e_m * e_m * length_m;
    y_m[i] = at.y_m[i] - origin.y_m;
    z_m[i] = at.rail_z_m[i] - origin.z_m;
    up[i] = rail_cos;
    side[i] = rail_cos * at.rail_slope[i];
  }
  for (std::size_t i = 0; i < kGauss; ++i) {
    sums.mass += mass[i];
    sums.mass_y += mass[i] * y_m[i];
    sums.mass_z += mass[i] * z_m[i];
    sums.mass_square += mass[i] * (y_m[i] * y_m[i] + z_m[i] * z_m[i]);
    sums.weight += weight[i];
    sums.weight_s += weight[i] * at.s_m[i];
    sums.weight_up += weight[i] * up[i];
    sums.weight_side += weight[i] * side[i];
  }
}

void addStretch(RegionSums& sums, const Overlap& overlap, const PlaceOrigin& origin, double begin_m, double end_m) {
  for (double panel = std::floor(begin_m / kPanel_m) + 1.0; begin_m < end_m; panel += 1.0) {
    const double next_m = std::min(std::max(panel * kPanel_m, begin_m), end_m);
    addPanel(sums, overlap, origin, 0.5 * (begin_m + next_m), 0.5 * (next_m - begin_m));
    begin_m = next_m;
  }
}

}  // namespace

void RegionShape::add(const RegionShape& other, double factor) {
  overlap_m += factor * other.overlap_m;
  across_1pm += factor * other.across_1pm;
  s_m += factor * other.s_m;
  up += factor * other.up;
  side += factor * other.side;
}

RegionShape computeShape(const RegionSums& sums) {
  return {sums.overlap_m, sums.overlap_m / (3.0 * sums.computeVariance_m2()),  // (G3)
          sums.weight_s / sums.weight, sums.weight_up / sums.weight, sums.weight_side / sums.weight};
}

double RegionSums::computeVariance_m2() const {
  const double y_m = mass_y / mass, z_m = mass_z / mass;
  return mass_square / mass - (y_m * y_m + z_m * z_m);
}

RegionSums computeRegionSums(const Overlap& overlap, const OverlapPeaks& peaks, std::size_t first, std::size_t last) {
  const Overlap::Place near = overlap.placeAt(peaks.peak[0].s_m);
  RegionSums sums;
  double begin_m = 0.0;
  bool open = false;
  for (std::size_t i = first; i <= last; ++i) {
    const OverlapPeak& peak = peaks.peak[i];
    sums.overlap_m = std::max(sums.overlap_m, peak.overlap_m);
    if (!open) begin_m = peak.left_e_m < 0.0 ? findEdge(overlap, peak, peak.left_m, peak.left_e_m) : peak.left_m;
    open = i < last && peak.right_e_m >= 0.0;  // no cut in a valley that overlaps: the valley may have come up just now
    if (open) continue;
    const double end_m = peak.right_e_m < 0.0 ? findEdge(overlap, peak, peak.right_m, peak.right_e_m) : peak.right_m;
    addStretch(sums, overlap, {near.y_m, near.rail_z_m}, begin_m, end_m);
  }
  return sums;
}

}  // namespace loco
