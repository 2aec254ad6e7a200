#include "loco_dynamics/profile/wheel_rail_geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "loco_dynamics/profile/contact_search.hpp"
#include "loco_dynamics/profile/standard_profiles.hpp"
#include "rail_core/message_number.hpp"
#include "rail_placing.hpp"

namespace loco {

namespace {

constexpr double kFlangeBackToTaping_m = 70e-3;  // UIC 510-2
constexpr double kFlangeDepth_m = 10e-3;         // below the taping line: where a flange's thickness is measured
constexpr double kLeastTread_m = 5e-3;           // of tread outside the rail's top, chosen
constexpr double kSteepestTread_rad = 0.35;      // chosen: 20 degrees is a flange's root, no tread
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

std::string millimetres(double value_m) { return rail::fixedNumber(value_m * 1e3, 1); }

/// The first contact of the left wheel of a centred wheelset that is lowered onto the track; none if it falls through.
bool findFirstContact(const WheelRailGeometry& geometry, ContactRegion& first) {
  const ContactSearch search(geometry);
  std::array<ContactRegion, kMostContacts> regions;
  constexpr double kDeep_m = 0.1;
  double below_m = -kDeep_m, above_m = kDeep_m;
  constexpr int kHalvings = 40;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle_m = 0.5 * (below_m + above_m);
    const bool touches = search.find(Side::kLeft, {0.0, middle_m, 0.0, 0.0}, regions) > 0;
    if (touches) first = regions[0];
    (touches ? below_m : above_m) = middle_m;
  }
  return below_m > -kDeep_m;
}

}  // namespace

WheelRailGeometry::WheelRailGeometry(const ProfilePoints& wheel, const ProfilePoints& rail,
                                     const WheelRailDimensions& dimensions)
    : dimensions_(dimensions),
      wheel_(makeWheelTable(wheel)),
      rail_(makeRailTable(inclineRail(rail, dimensions.inclination))),
      taping_line_m_(0.5 * dimensions.flange_back_m + kFlangeBackToTaping_m),
      rail_top_m_(0.5 * dimensions.gauge_m + findGaugeFace(inclineRail(rail, dimensions.inclination)).value_or(0.0)),
      flange_face_m_(findFlangeFace(wheel, kFlangeDepth_m).value_or(0.0)) {}

WheelRailGeometry::WheelRailGeometry(const WheelRailDimensions& dimensions)
    : WheelRailGeometry(makeWheelPoints("S1002"), makeRailPoints("UIC60"), dimensions) {}

double WheelRailGeometry::computeClimbRise_m() const {
  constexpr double kStep_m = 2e-5;
  constexpr double kAlike_rad = 2e-3;  // chosen: what a spline leaves of a straight flank; 0.04 mm on an arc of 20 mm
  const auto angle = [this](double y_m) { return std::atan(-wheel_.at(y_m).slope); };
  double largest_rad = 0.0;
  for (double y = wheel_.begin_m(); y < 0.0; y += kStep_m) largest_rad = std::max(largest_rad, angle(y));
  double y_m = wheel_.begin_m();
  while (angle(y_m) < largest_rad - kAlike_rad) y_m += kStep_m;
  return wheel_.at(y_m).z_m;
}

std::vector<WheelRailGeometry::Misfit> WheelRailGeometry::findMisfits() const {
  std::vector<Misfit> misfits;
  const double flanges_m = 2.0 * (taping_line_m_ - flange_face_m_);
  if (flanges_m >= dimensions_.gauge_m) {
    misfits.push_back({"gauge_mm", "gauge too narrow for the wheelset: its flanges are " + millimetres(flanges_m) +
                                       " mm apart outside, 10 mm below the taping line, with flange_back_mm = " +
                                       millimetres(dimensions_.flange_back_m)});
    return misfits;
  }
  if (rail_top_m_ > taping_line_m_ + wheel_.end_m() - kLeastTread_m) {
    misfits.push_back({"gauge_mm", "gauge too wide for the wheelset: the rails' tops are " +
                                       millimetres(2.0 * rail_top_m_) + " mm apart, the treads end at " +
                                       millimetres(2.0 * (taping_line_m_ + wheel_.end_m())) + " mm"});
    return misfits;
  }
  ContactRegion first;
  if (!findFirstContact(*this, first) || std::abs(first.angle_rad) > kSteepestTread_rad) {
    misfits.push_back({"rail", "phantom contact: the centred wheelset touches the rail at " +
                                   millimetres(first.p_T.y() - rail_top_m_) + " mm from its top, at " +
                                   std::to_string(std::lround(first.angle_rad * 1e3)) +
                                   " mrad, and not with its treads"});
  }
  return misfits;
}

}  // namespace loco
