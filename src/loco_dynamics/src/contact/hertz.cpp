#include "loco_dynamics/contact/hertz.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace loco {

namespace {

constexpr double kPi = 3.14159265358979323846;

/// Complete elliptic integrals of an ellipse whose minor over major axis is g, with m = 1 - g^2.
struct EllipticIntegrals {
  double K;
  double D;  ///< (K - E)/m; pi/4 for a circle
};

/// By the arithmetic-geometric mean: K - E = K (c_0^2 + 2 c_1^2 + 4 c_2^2 + ...)/2, c_0^2 = m. Each c_n^2 is kept as a
/// multiple of m, so that nothing is lost for a circle.
EllipticIntegrals computeEllipticIntegrals(double g) {
  double mean = 0.5 * (1.0 + g);
  double geometric = std::sqrt(g);
  double c_over_m = (1.0 - g) / (4.0 * (1.0 + g));  // c_1^2/m
  double sum = 0.5 + c_over_m;
  double weight = 1.0;
  constexpr int kSteps = 7;  // from g = 1e-6 on, six leave an error below 1e-16
  for (int n = 0; n < kSteps; ++n) {
    const double c = 0.5 * (mean - geometric);
    const double next = 0.5 * (mean + geometric);
    // c_(n+1) = c_n^2/(4 a_(n+1)), so c_(n+1)^2/m = (c_n^2/m) c_n^2/(16 a_(n+1)^2)
    const double c_before = 4.0 * next * c;  // c_n^2
    c_over_m *= c_before / (16.0 * next * next);
    weight *= 2.0;
    sum += weight * c_over_m;
    geometric = std::sqrt(mean * geometric);
    mean = next;
  }
  const double K = kPi / (2.0 * mean);
  return {K, K * sum};
}

/// Smaller over larger curvature of the ellipse with minor over major axis g: rises from 0 to 1 with g.
double computeCurvatureRatio(double g) {
  const EllipticIntegrals integrals = computeEllipticIntegrals(g);
  return g * g * integrals.D / (integrals.K - integrals.D);
}

/// The g that belongs to a ratio of curvatures, by bisection in ln g.
double findAxisRatio(double curvature_ratio) {
  double low = std::log(1e-6);
  double high = 0.0;
  constexpr int kHalvings = 56;  // ln(1e6) 2^-56 is below round-off
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (computeCurvatureRatio(std::exp(middle)) < curvature_ratio ? low : high) = middle;
  }
  return std::exp(0.5 * (low + high));
}

}  // namespace

HertzContact::HertzContact(const RelativeCurvature& curvature, const Elasticity& elasticity) {
  assert(curvature.along_1pm > 0.0 && curvature.across_1pm > 0.0);
  // the gap is h = A x^2 + B y^2 with half the sums of curvatures
  const double small = 0.5 * std::min(curvature.along_1pm, curvature.across_1pm);
  const double large = 0.5 * std::max(curvature.along_1pm, curvature.across_1pm);
  const double g = findAxisRatio(small / large);
  const auto [K, D] = computeEllipticIntegrals(g);
  const double reduced_Pa = elasticity.young_Pa / (2.0 * (1.0 - elasticity.poisson * elasticity.poisson));  // E*

  // at 1 N: small = 3 D/(2 pi E* major^3), delta = 3 K/(2 pi E* major)
  const double major = std::cbrt(3.0 * D / (2.0 * kPi * reduced_Pa * small));
  const bool along_is_longer = curvature.along_1pm < curvature.across_1pm;
  a_unit_ = along_is_longer ? major : g * major;
  b_unit_ = along_is_longer ? g * major : major;
  const double approach = 3.0 * K / (2.0 * kPi * reduced_Pa * major);
  stiffness_ = 1.0 / (approach * std::sqrt(approach));
}

HertzContact::Ellipse HertzContact::computeEllipse(double normal_N) const {
  const double growth = std::cbrt(normal_N);
  return {a_unit_ * growth, b_unit_ * growth};
}

double HertzContact::computeNormalForce(double approach_m) const {
  return approach_m > 0.0 ? stiffness_ * approach_m * std::sqrt(approach_m) : 0.0;  // (C1)
}

double HertzContact::computeApproach(double normal_N) const {
  const double root = std::cbrt(normal_N / stiffness_);
  return root * root;
}

double HertzContact::computeTangentStiffness(double approach_m) const {
  return approach_m > 0.0 ? 1.5 * stiffness_ * std::sqrt(approach_m) : 0.0;
}

}  // namespace loco
