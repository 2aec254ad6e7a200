#include "loco_dynamics/profile/height_table.hpp"

#include <cmath>

namespace loco {

namespace {

/// Value of the curve where it has this y, between the chord lengths low and high (y rises between them).
ProfileCurve::Value findAt(const ProfileCurve& curve, double y_m, double low, double high) {
  constexpr int kHalvings = 60;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (curve.at(middle).y_m < y_m ? low : high) = middle;
  }
  return curve.at(0.5 * (low + high));
}

}  // namespace

HeightTable::HeightTable(const ProfileCurve& curve, const CurveRange& range)
    : begin_m_(curve.at(range.begin_m).y_m), end_m_(curve.at(range.end_m).y_m) {
  constexpr double kCell_m = 0.1e-3;
  const auto count = static_cast<std::size_t>(std::ceil((end_m_ - begin_m_) / kCell_m));
  const double width = (end_m_ - begin_m_) / static_cast<double>(count);
  cells_per_m_ = 1.0 / width;
  first_m_ = begin_m_ - width;
  last_cell_ = static_cast<double>(count + 1);

  ProfileCurve::Value left = curve.at(range.begin_m);
  cells_.push_back({begin_m_, left.z_m, left.slope(), 0.0, 0.0});
  double low = range.begin_m;
  for (std::size_t i = 0; i < count; ++i) {
    const ProfileCurve::Value right =
        i + 1 == count ? curve.at(range.end_m)
                       : findAt(curve, begin_m_ + width * static_cast<double>(i + 1), low, range.end_m);
    const double h = right.y_m - left.y_m, chord = (right.z_m - left.z_m) / h;
    cells_.push_back({left.y_m, left.z_m, left.slope(), (3.0 * chord - 2.0 * left.slope() - right.slope()) / h,
                      (left.slope() + right.slope() - 2.0 * chord) / (h * h)});
    left = right;
  }
  cells_.push_back({end_m_, left.z_m, left.slope(), 0.0, 0.0});
}

}  // namespace loco
