#pragma once

#include <string>
#include <vector>

#include "loco_dynamics/profile/profile_points.hpp"

namespace loco {

/// Depth z(s) of the wheel profile S1002 [mm] at s [mm] from the taping line, -70 <= s <= 60, + to the field side.
/// Its eight pieces meet within 0.12 um: the coefficients are printed with ten digits.
/// Source: UIC 510-2.
double computeS1002Depth_mm(double s_mm);

/// Depth of a 1:20 cone with the flange of S1002 [mm]: -s/20 down to s = -26.860 mm, where it runs tangentially into
/// S1002's root arc of 13 mm, raised with the whole flange by 2.119 mm. Tread and flange are far apart in angle, so the
/// wheel has clear two-point contact. Chosen: a classical tread, no standard.
double computeConed120Depth_mm(double s_mm);

/// Depth of the rail head UIC60 [mm] at y [mm] from its middle, not canted, |y| <= 36.010: arcs of 300, 80 and 13 mm.
/// Tangent arcs, fitted to the points of the Manchester benchmark's rail. Sides 1:20 follow below 14.2621 mm.
double computeUic60Depth_mm(double y_mm);

/// Names that a configuration may give: S1002, coned_1_20.
const std::vector<std::string>& wheelProfileNames();
/// UIC60.
const std::vector<std::string>& railProfileNames();

/// Points of a named profile, 0.2 mm apart along the curve; empty if there is no such name.
ProfilePoints makeWheelPoints(const std::string& name);
ProfilePoints makeRailPoints(const std::string& name);

}  // namespace loco
