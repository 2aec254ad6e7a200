#include "loco_dynamics/contact/hertz_table.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace loco {

namespace {

constexpr double kLargest = 7.0;          ///< of |ln(across/along)|
constexpr double kSpacing = 1.0 / 128.0;  ///< chosen: the error falls with its square
constexpr int kEntries = 2 * 7 * 128 + 1;

double blend(double from, double to, double t) { return from + t * (to - from); }

}  // namespace

HertzTable::HertzTable(const Elasticity& elasticity) {
  contacts_.reserve(kEntries);
  for (int i = 0; i < kEntries; ++i) {
    const HertzContact hertz({1.0, std::exp(kSpacing * i - kLargest)}, elasticity);
    const HertzContact::Ellipse unit = hertz.computeEllipse(1.0);
    contacts_.push_back({unit.a_m, unit.b_m, hertz.computeNormalForce(1.0),
                         computeKalkerCoefficients(hertz.aOverB(), elasticity.poisson)});
  }
}

HertzTable::Contact HertzTable::at(const RelativeCurvature& curvature) const {
  assert(curvature.along_1pm > 0.0 && curvature.across_1pm > 0.0);
  const double ratio = std::log(curvature.across_1pm / curvature.along_1pm);
  const double place = (std::clamp(ratio, -kLargest, kLargest) + kLargest) / kSpacing;
  const auto i = static_cast<std::size_t>(std::clamp(static_cast<int>(place), 0, kEntries - 2));
  const double t = place - static_cast<double>(i);
  const Contact &p = contacts_[i], &q = contacts_[i + 1];
  const double size = 1.0 / std::cbrt(curvature.along_1pm);
  return {blend(p.a_unit, q.a_unit, t) * size,
          blend(p.b_unit, q.b_unit, t) * size,
          blend(p.stiffness, q.stiffness, t) / std::sqrt(curvature.along_1pm),
          {blend(p.kalker.c11, q.kalker.c11, t), blend(p.kalker.c22, q.kalker.c22, t),
           blend(p.kalker.c23, q.kalker.c23, t)}};
}

}  // namespace loco
