#include "loco_dynamics/profile/profile_curve.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace loco {

namespace {

/// Second derivatives at the knots of the natural cubic spline through (t, values), by Thomas's algorithm.
std::vector<double> computeSecondDerivatives(const std::vector<double>& t, const std::vector<double>& values) {
  const std::size_t n = t.size();
  std::vector<double> second(n, 0.0), upper(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = t[i] - t[i - 1], after = t[i + 1] - t[i];
    const double right = 6.0 * ((values[i + 1] - values[i]) / after - (values[i] - values[i - 1]) / before);
    const double pivot = 2.0 * (before + after) - before * upper[i - 1];
    upper[i] = after / pivot;
    second[i] = (right - before * second[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) second[i] -= upper[i] * second[i + 1];
  return second;
}

struct SplineValue {
  double value, first, second;
};

/// Cubic between two knots a distance h apart, u = 0 to 1 between them.
SplineValue evaluate(double v0, double v1, double dd0, double dd1, double h, double u) {
  const double w = 1.0 - u;
  return {w * v0 + u * v1 + h * h / 6.0 * ((w * w * w - w) * dd0 + (u * u * u - u) * dd1),
          (v1 - v0) / h + h / 6.0 * ((1.0 - 3.0 * w * w) * dd0 + (3.0 * u * u - 1.0) * dd1), w * dd0 + u * dd1};
}

}  // namespace

double ProfileCurve::Value::computeCurvature_1pm() const {
  const double speed = std::hypot(dy, dz);
  return (dy * ddz_1pm - dz * ddy_1pm) / (speed * speed * speed);
}

ProfileCurve::ProfileCurve(ProfilePoints points) : points_(std::move(points)) {
  assert(points_.size() >= 2);
  std::vector<double> y, z;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    y.push_back(points_[i].y_m);
    z.push_back(points_[i].z_m);
    t_m_.push_back(i == 0 ? 0.0 : t_m_.back() + std::hypot(y[i] - y[i - 1], z[i] - z[i - 1]));
  }
  ddy_1pm_ = computeSecondDerivatives(t_m_, y);
  ddz_1pm_ = computeSecondDerivatives(t_m_, z);
}

ProfileCurve::Value ProfileCurve::at(double t_m) const {
  const auto above = std::upper_bound(t_m_.begin() + 1, t_m_.end() - 1, t_m);
  const auto i = static_cast<std::size_t>(above - t_m_.begin()) - 1;
  const double h = t_m_[i + 1] - t_m_[i], u = (t_m - t_m_[i]) / h;
  const SplineValue y = evaluate(points_[i].y_m, points_[i + 1].y_m, ddy_1pm_[i], ddy_1pm_[i + 1], h, u);
  const SplineValue z = evaluate(points_[i].z_m, points_[i + 1].z_m, ddz_1pm_[i], ddz_1pm_[i + 1], h, u);
  return {y.value, z.value, y.first, z.first, y.second, z.second};
}

CurveRange findRangeBelowSlope(const ProfileCurve& curve, std::size_t about, double largest_slope) {
  const auto isGentle = [&](double t_m) {
    const ProfileCurve::Value value = curve.at(t_m);
    return value.dy > 0.0 && std::abs(value.dz) <= largest_slope * value.dy;
  };
  const auto walk = [&](double direction) {
    constexpr double kStep_m = 0.05e-3;  // finer than any feature of a profile
    const double end_m = direction > 0.0 ? curve.length_m() : 0.0;
    double t_m = curve.chordAt(about);
    while (direction * (end_m - t_m) > kStep_m && isGentle(t_m + direction * kStep_m)) t_m += direction * kStep_m;
    return direction * (end_m - t_m) <= kStep_m && isGentle(end_m) ? end_m : t_m;
  };
  return {walk(-1.0), walk(1.0)};
}

}  // namespace loco
