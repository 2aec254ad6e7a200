#include "profile_check.hpp"

#include <algorithm>
#include <cmath>

#include "rail_core/message_number.hpp"
#include "rail_placing.hpp"
#include "stray_chord.hpp"

namespace loco {

namespace {

constexpr double kMillimetresPerMetre = 1e3;
constexpr double kMilliradiansPerRadian = 1e3;
constexpr std::size_t kFewest = 20;
constexpr double kWidestGap_mm = 5.0;     // chosen: two points on a root arc of 12 mm are still 24 degrees apart
constexpr double kSharpest_rad = 0.785;   // chosen: 45 degrees between neighbouring chords is a slip, no profile
constexpr double kSteepestFlange = 4.70;  // tangent of 78 degrees; tables end at 80
constexpr double kClosedBehindTip_mm = 1.0;
constexpr double kTreadBeyond_mm = 20.0;
constexpr double kHeadBeyond_mm = 20.0;
constexpr double kTapingLineTolerance_mm = 0.1;
constexpr double kFlangeBack_mm = -70.0;  // UIC 510-2: the taping line is where the wheel is 70 mm from its back
// Chosen: a back face is measured to 0.1 mm, and where it bends to the tip (arc of 12 mm) it is 0.5 mm further out than
// a first point 3.4 mm lower. A profile shifted that much carries the wheelset's flanges 1 mm too far apart.
constexpr double kFlangeBackTolerance_mm = 0.5;

std::string shown(double value) { return rail::messageNumber(value); }

/// The unit in which a span would be right, and what to do; "" if there is none.
std::string unitHint(double span, double low_mm, double high_mm) {
  struct Unit {
    const char* name;
    double millimetres;
  };
  for (const Unit& unit : {Unit{"metres", 1e3}, Unit{"inches", 25.4}, Unit{"centimetres", 10.0}, Unit{"um", 1e-3}}) {
    if (span * unit.millimetres < low_mm || span * unit.millimetres > high_mm) continue;
    return std::string(" ") + unit.name + " would be right: multiply them by " + shown(unit.millimetres);
  }
  return "";
}

double direction(const ProfilePoint& a, const ProfilePoint& b) { return std::atan2(b.z_m - a.z_m, b.y_m - a.y_m); }

}  // namespace

void ProfileCheck::refuse(const std::string& column, std::size_t point, double value_mm, const std::string& rule) {
  problems_.add(file_, "line " + std::to_string(lines_[point]) + ": " + column, shown(value_mm), rule);
}

void ProfileCheck::check(ProfileKind kind) {
  if (!checkCount()) return;
  kind == ProfileKind::kWheel ? checkWheel() : checkRail();
}

bool ProfileCheck::checkCount() {
  if (points_.size() >= kFewest) return true;
  refuse("has " + std::to_string(points_.size()) + " points, must have " + std::to_string(kFewest) + " at least");
  return false;
}

bool ProfileCheck::checkUnit(double narrowest_mm, double widest_mm, double shallowest_mm, double deepest_mm) {
  const auto [left, right] = std::minmax_element(
      points_.begin(), points_.end(), [](const ProfilePoint& a, const ProfilePoint& b) { return a.y_m < b.y_m; });
  const double width_mm = (right->y_m - left->y_m) * kMillimetresPerMetre;
  const double depth_mm =
      (points_[findDeepest(points_)].z_m - points_[findHighest(points_)].z_m) * kMillimetresPerMetre;
  const auto check_span = [this](const std::string& column, double span_mm, double low_mm, double high_mm) {
    if (span_mm >= low_mm && span_mm <= high_mm) return true;
    problems_.add(file_, column, "spans " + shown(span_mm),
                  "must span " + shown(low_mm) + " to " + shown(high_mm) + " mm: are these millimetres?" +
                      unitHint(span_mm, low_mm, high_mm));
    return false;
  };
  const bool width_is_right = check_span("y_mm", width_mm, narrowest_mm, widest_mm);
  return check_span("z_mm", depth_mm, shallowest_mm, deepest_mm) && width_is_right;
}

bool ProfileCheck::checkOrder(std::size_t from) {
  for (std::size_t i = from + 1; i < points_.size(); ++i) {
    if (points_[i].y_m > points_[i - 1].y_m) continue;
    refuse("y_mm", i, points_[i].y_m * kMillimetresPerMetre,
           "must rise from point to point, the one before is at " + shown(points_[i - 1].y_m * kMillimetresPerMetre) +
               " (order: flange or gauge face first, field side last)");
    return false;
  }
  return true;
}

void ProfileCheck::checkNeighbours(std::size_t from) {
  for (std::size_t i = from + 1; i < points_.size(); ++i) {
    const double gap_mm =
        kMillimetresPerMetre * std::hypot(points_[i].y_m - points_[i - 1].y_m, points_[i].z_m - points_[i - 1].z_m);
    if (gap_mm > kWidestGap_mm) {
      refuse("y_mm", i, points_[i].y_m * kMillimetresPerMetre,
             "is open here: " + shown(gap_mm) + " mm from the point before, must be 5 mm at most");
    }
    if (i < from + 2) continue;
    const double turn = direction(points_[i - 1], points_[i]) - direction(points_[i - 2], points_[i - 1]);
    if (std::abs(std::remainder(turn, 6.283185307179586)) > kSharpest_rad) {
      refuse("z_mm", i - 1, points_[i - 1].z_m * kMillimetresPerMetre,
             "the profile turns by more than 45 degrees here");
    }
  }
}

void ProfileCheck::checkWheel() {
  // wide enough for a tread, with a flange of a real wheel's height
  if (!checkUnit(80.0, 200.0, 20.0, 60.0)) return;
  const std::size_t tip = findDeepest(points_);
  if (!checkFlangeSide(tip) || !checkOrder(tip)) return;
  checkNeighbours(0);
  checkFlange(tip);
  checkFlangeBack(tip);
  checkTapingLine(tip);
  checkSmoothness(tip);  // nothing can touch what lies behind the tip
}

bool ProfileCheck::checkFlangeSide(std::size_t tip) {
  const double tip_mm = points_[tip].z_m * kMillimetresPerMetre;
  const std::size_t top = findHighest(points_);
  if (-points_[top].z_m > points_[tip].z_m) {
    refuse("z_mm", top, points_[top].z_m * kMillimetresPerMetre,
           "z must point down: the flange's tip must have z > 0: change the sign of every z_mm");
    return false;
  }
  if (points_[tip].y_m >= 0.0) {
    refuse("y_mm", tip, points_[tip].y_m * kMillimetresPerMetre,
           "mirrored: the flange (tip at z = " + shown(tip_mm) + ") must be on the gauge side, y < 0");
    return false;
  }
  return true;
}

void ProfileCheck::checkFlange(std::size_t tip) {
  const double tip_mm = points_[tip].z_m * kMillimetresPerMetre;
  if ((points_[tip].z_m - points_.front().z_m) * kMillimetresPerMetre < kClosedBehindTip_mm) {
    refuse("z_mm", 0, points_.front().z_m * kMillimetresPerMetre,
           "the flange is open: the first point must lie behind the tip and 1 mm above it at least (tip at " +
               shown(tip_mm) + "), or there are phantom contacts");
  }
  for (std::size_t i = tip + 1; i < points_.size(); ++i) {
    const double width_m = points_[i].y_m - points_[i - 1].y_m;
    if (std::abs(points_[i].z_m - points_[i - 1].z_m) > kSteepestFlange * width_m) {
      refuse("z_mm", i, points_[i].z_m * kMillimetresPerMetre, "the flange is steeper than 78 degrees here");
      return;
    }
  }
}

void ProfileCheck::checkFlangeBack(std::size_t tip) {
  std::size_t back = 0;
  for (std::size_t i = 1; i <= tip; ++i) {
    if (points_[i].y_m < points_[back].y_m) back = i;
  }
  const double back_mm = points_[back].y_m * kMillimetresPerMetre;
  if (std::abs(back_mm - kFlangeBack_mm) <= kFlangeBackTolerance_mm) return;
  refuse("y_mm", back, back_mm,
         "the flange's back, which is the least y, must be at y = -70 within 0.5 mm: y counts from the taping line, "
         "which is 70 mm from it: add " +
             shown(kFlangeBack_mm - back_mm) + " to every y_mm");
}

void ProfileCheck::checkSmoothness(std::size_t from) {
  const std::optional<StrayChord> stray = findStrayChord(points_, from);
  if (!stray) return;
  refuse("z_mm", stray->point, points_[stray->point].z_m * kMillimetresPerMetre,
         "noise or a step: the profile turns here by " + shown(stray->angle_rad * kMilliradiansPerRadian) +
             " mrad and back, must be " + shown(kMostAstray_rad * kMilliradiansPerRadian) +
             " mrad at most (points that were measured must be smoothed)");
}

void ProfileCheck::checkTapingLine(std::size_t tip) {
  if (points_.back().y_m * kMillimetresPerMetre < kTreadBeyond_mm) {
    refuse("y_mm", points_.size() - 1, points_.back().y_m * kMillimetresPerMetre,
           "the tread must reach y >= 20: it is open on the field side");
    return;
  }
  for (std::size_t i = tip + 1; i < points_.size(); ++i) {
    const ProfilePoint &a = points_[i - 1], &b = points_[i];
    if (b.y_m < 0.0) continue;
    const double z_mm = kMillimetresPerMetre * (a.z_m + (b.z_m - a.z_m) * (0.0 - a.y_m) / (b.y_m - a.y_m));
    if (std::abs(z_mm) > kTapingLineTolerance_mm) {
      refuse("z_mm", i, b.z_m * kMillimetresPerMetre,
             "z must be 0 within 0.1 mm at the taping line y = 0, where the wheel's radius is the nominal one; it is " +
                 shown(z_mm) + ": subtract that from every z_mm");
    }
    return;
  }
}

void ProfileCheck::checkRail() {
  // a head, perhaps with parts of its sides
  if (!checkUnit(45.0, 120.0, 14.0, 60.0) || !checkOrder(0)) return;
  checkNeighbours(0);
  const std::size_t top = findHighest(points_), low = findDeepest(points_);
  if (top == 0 || top + 1 == points_.size()) {
    const double low_mm = points_[low].z_m * kMillimetresPerMetre;
    refuse("z_mm", low, low_mm,
           "z must point down, so that the head's top has the least z, and this is the largest: if this is the top, "
           "write " +
               shown(low_mm) + " - z for every z");
    return;
  }
  if ((points_.back().y_m - points_[top].y_m) * kMillimetresPerMetre < kHeadBeyond_mm) {
    refuse("y_mm", points_.size() - 1, points_.back().y_m * kMillimetresPerMetre,
           "the head must reach 20 mm from its top to the field side");
  }
  if ((points_.front().z_m - points_[top].z_m) < kGaugeDepth_m) {
    refuse("z_mm", 0, points_.front().z_m * kMillimetresPerMetre,
           "the gauge face must reach 14 mm below the top, where the gauge is measured" +
               std::string(points_.back().z_m - points_[top].z_m < kGaugeDepth_m
                               ? ""
                               : "; the other side does: is the rail mirrored?"));
  }
  checkSmoothness(0);
}

}  // namespace loco
