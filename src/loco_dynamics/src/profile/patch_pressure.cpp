#include "loco_dynamics/profile/patch_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "loco_dynamics/contact/elastic_pressure.hpp"
#include "overlap.hpp"

namespace loco {

namespace {

constexpr double kGap_m = 4e-3;  // nearer stretches are one contact, as in the search (G5)
constexpr double kStepOfWidth = 0.01;
constexpr std::size_t kColumns = 36;  // chosen: of CONTACT's cases 18 to 72 give the same within 2 %

/// A stretch of wheel that overlaps, by its length along the rail.
struct Stretch {
  std::vector<double> way_m, overlap_m, y_m;
  bool holds(double y) const { return !y_m.empty() && y >= y_m.front() && y <= y_m.back(); }
  void shorten(std::size_t count) {
    way_m.resize(count);
    overlap_m.resize(count);
    y_m.resize(count);
  }
};

/// The one about the contact whose place on the rail is y_m, with what is nearer to it than kGap_m; empty if none is.
Stretch findStretch(const Overlap& overlap, const WheelRailGeometry& geometry, double y_m, double step_m) {
  Stretch stretch;
  double way_m = 0.0;
  std::size_t touching = 0;  // points up to the last that overlaps
  for (double s_m = geometry.wheel().begin_m(); s_m < geometry.wheel().end_m(); s_m += step_m) {
    const Overlap::Place place = overlap.placeAt(s_m);
    way_m += step_m * place.rail_length;
    if (touching > 0 && place.overlap_m <= 0.0 && way_m - stretch.way_m[touching - 1] > kGap_m) {
      stretch.shorten(touching);
      if (stretch.holds(y_m)) return stretch;
      stretch = {};
      touching = 0;
    }
    if (touching == 0 && place.overlap_m <= 0.0) continue;
    if (touching == 0) way_m = 0.0;
    stretch.way_m.push_back(way_m);
    stretch.overlap_m.push_back(place.overlap_m);
    stretch.y_m.push_back(place.y_m);
    if (place.overlap_m > 0.0) touching = stretch.way_m.size();
  }
  stretch.shorten(touching);
  return stretch.holds(y_m) ? stretch : Stretch{};
}

ContactSection makeSection(const Stretch& stretch, double along_1pm) {
  ContactSection section;
  section.along_1pm = along_1pm;
  section.step_m = stretch.way_m.back() / static_cast<double>(kColumns);
  for (std::size_t i = 0, at = 0; i < kColumns; ++i) {
    const double middle_m = (static_cast<double>(i) + 0.5) * section.step_m;
    while (at + 1 < stretch.way_m.size() && stretch.way_m[at] < middle_m) ++at;
    section.overlap_m.push_back(stretch.overlap_m[at]);
  }
  return section;
}

}  // namespace

double computePatchPressure(const WheelRailGeometry& geometry, const StandingWheelset& standing, Side side,
                            std::size_t patch, const Elasticity& elasticity) {
  const double sign = side == Side::kLeft ? 1.0 : -1.0;  // a right wheel is a left one, mirrored
  const WheelsetPose& pose = standing.pose;
  const Overlap overlap(geometry, {sign * pose.y_m, pose.z_m, sign * pose.roll_rad, sign * pose.yaw_rad});
  const LoadedWheel& wheel = standing.wheel[static_cast<std::size_t>(side)];
  const ContactRegion& region = wheel.patch[patch].region;
  const Stretch stretch =
      findStretch(overlap, geometry, sign * region.p_T.y(), kStepOfWidth * wheel.patch[patch].ellipse.b_m);
  if (stretch.way_m.size() < kColumns) return std::nan("");  // the place lies in no overlap: never seen
  double normal_N = 0.0;
  for (std::size_t i = 0; i < wheel.count; ++i) {
    if (stretch.holds(sign * wheel.patch[i].region.p_T.y())) normal_N += wheel.patch[i].normal_N;
  }
  const std::vector<double> pressure_Pa =
      computeElasticPressure(makeSection(stretch, region.curvature.along_1pm), normal_N, elasticity);
  return *std::max_element(pressure_Pa.begin(), pressure_Pa.end());
}

}  // namespace loco
