#include "loco_dynamics/profile/wheel_rail_geometry.hpp"

#include <algorithm>

#include "loco_dynamics/profile/standard_profiles.hpp"
#include "rail_placing.hpp"

namespace loco {

namespace {

constexpr double kFlangeBackToTaping_m = 70e-3;  // UIC 510-2
constexpr double kSteepest = 5.67;  // tangent of 80 degrees: beyond, a profile goes on straight; no flange is as steep

HeightTable makeWheelTable(const ProfilePoints& points) {
  const ProfileCurve curve(points);
  const std::size_t tip = findDeepest(points);
  std::size_t tread = tip;
  while (tread + 1 < points.size() && points[tread].y_m < 0.0) ++tread;
  CurveRange range = findRangeBelowSlope(curve, tread, kSteepest);
  range.begin_m = std::max(range.begin_m, curve.chordAt(tip));  // nothing can touch the flange's back
  return {curve, range};
}

HeightTable makeRailTable(const ProfilePoints& inclined) {
  const ProfileCurve curve(inclined);
  return {curve, findRangeBelowSlope(curve, findHighest(inclined), kSteepest)};
}

}  // namespace

WheelRailGeometry::WheelRailGeometry(const ProfilePoints& wheel, const ProfilePoints& rail,
                                     const WheelRailDimensions& dimensions)
    : dimensions_(dimensions),
      wheel_(makeWheelTable(wheel)),
      rail_(makeRailTable(inclineRail(rail, dimensions.inclination))),
      taping_line_m_(0.5 * dimensions.flange_back_m + kFlangeBackToTaping_m),
      rail_top_m_(0.5 * dimensions.gauge_m +
                  findGaugeFace(inclineRail(rail, dimensions.inclination)).value_or(0.0)) {}

WheelRailGeometry::WheelRailGeometry(const WheelRailDimensions& dimensions)
    : WheelRailGeometry(makeWheelPoints("S1002"), makeRailPoints("UIC60"), dimensions) {}

}  // namespace loco
