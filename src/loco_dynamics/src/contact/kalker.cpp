#include "loco_dynamics/contact/kalker.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "loco_dynamics/contact/contact_patch.hpp"

namespace loco {

namespace {

constexpr double kPi = 3.14159265358979323846;

/// Table E.3 of Kalker 1990: a < b, then a > b; g = 0.1, 0.2, ..., 1; C11, C22, C23; nu = 0, 1/4, 1/2.
// clang-format off
constexpr double kTable[2][10][3][3] = {
    {
        {{2.51, 3.31, 4.85}, {2.51, 2.52, 2.53}, {0.334, 0.473, 0.731}},
        {{2.59, 3.37, 4.81}, {2.59, 2.63, 2.66}, {0.483, 0.603, 0.809}},
        {{2.68, 3.44, 4.8}, {2.68, 2.75, 2.81}, {0.607, 0.715, 0.889}},
        {{2.78, 3.53, 4.82}, {2.78, 2.88, 2.98}, {0.72, 0.823, 0.977}},
        {{2.88, 3.62, 4.83}, {2.88, 3.01, 3.14}, {0.827, 0.929, 1.07}},
        {{2.98, 3.72, 4.91}, {2.98, 3.14, 3.31}, {0.93, 1.03, 1.18}},
        {{3.09, 3.81, 4.97}, {3.09, 3.28, 3.48}, {1.03, 1.14, 1.29}},
        {{3.19, 3.91, 5.05}, {3.19, 3.41, 3.65}, {1.13, 1.25, 1.4}},
        {{3.29, 4.01, 5.12}, {3.29, 3.54, 3.82}, {1.23, 1.36, 1.51}},
        {{3.4, 4.12, 5.2}, {3.4, 3.67, 3.98}, {1.33, 1.47, 1.63}},
    },
    {
        {{10.7, 11.7, 12.9}, {10.7, 12.8, 16.0}, {12.2, 14.6, 18.0}},
        {{6.96, 7.78, 8.82}, {6.96, 8.14, 9.79}, {5.72, 6.63, 7.89}},
        {{5.57, 6.34, 7.34}, {5.57, 6.4, 7.51}, {3.79, 4.32, 5.01}},
        {{4.84, 5.57, 6.57}, {4.84, 5.48, 6.31}, {2.88, 3.24, 3.7}},
        {{4.37, 5.1, 6.11}, {4.37, 4.9, 5.56}, {2.35, 2.62, 2.96}},
        {{4.06, 4.78, 5.8}, {4.06, 4.5, 5.04}, {2.01, 2.23, 2.5}},
        {{3.82, 4.54, 5.58}, {3.82, 4.21, 4.67}, {1.76, 1.95, 2.18}},
        {{3.65, 4.36, 5.42}, {3.65, 3.99, 4.39}, {1.58, 1.75, 1.94}},
        {{3.51, 4.22, 5.3}, {3.51, 3.81, 4.16}, {1.44, 1.59, 1.77}},
        {{3.4, 4.12, 5.2}, {3.4, 3.67, 3.98}, {1.33, 1.47, 1.63}},
    },
};
// clang-format on
constexpr double kTableStep = 0.1;  ///< of g, and its first value

/// The parabola through 1/C at nu = 0, 1/4, 1/2.
double interpolateInPoisson(const double (&c)[3], double nu) {
  const double at_0 = 8.0 * (nu - 0.25) * (nu - 0.5);
  const double at_quarter = -16.0 * nu * (nu - 0.5);
  const double at_half = 8.0 * nu * (nu - 0.25);
  return 1.0 / (at_0 / c[0] + at_quarter / c[1] + at_half / c[2]);
}

KalkerCoefficients tableValue(bool a_longer, double g, double nu) {
  const auto& table = kTable[a_longer ? 1 : 0];
  const double position = g / kTableStep - 1.0;
  const auto row = static_cast<std::size_t>(std::clamp(position, 0.0, 8.0));
  const double share = position - static_cast<double>(row);
  double c[3];
  for (std::size_t i = 0; i < 3; ++i) {
    double at_nu[3];
    for (std::size_t n = 0; n < 3; ++n) at_nu[n] = (1.0 - share) * table[row][i][n] + share * table[row + 1][i][n];
    c[i] = interpolateInPoisson(at_nu, nu);
  }
  return {c[0], c[1], c[2]};
}

/// a << b. The last factor of C23 stands in the numerator, as in Kalker's table: there it follows the table's rise with
/// nu towards small g (1.36 from nu = 0 to 1/4 at g = 0.1, the table has 1.42), as a divisor it would fall (1.31).
KalkerCoefficients narrowAsymptote(double g, double nu) {
  return {kPi * kPi / (4.0 * (1.0 - nu)), kPi * kPi / 4.0,
          kPi * std::sqrt(g) / (3.0 * (1.0 - nu)) * (1.0 + nu * (std::log(16.0 / g) - 5.0))};
}

/// a >> b.
KalkerCoefficients longAsymptote(double g, double nu) {
  const double big_l = std::log(16.0 / (g * g));
  const double c = 3.0 - std::log(4.0);
  const double m = (1.0 - nu) * big_l + 2.0 * nu;
  return {2.0 * kPi / ((big_l - 2.0 * nu) * g) * (1.0 + c / (big_l - 2.0 * nu)),
          2.0 * kPi / g * (1.0 + (1.0 - nu) * c / m) / m,
          2.0 * kPi / (3.0 * g * std::sqrt(g)) / ((1.0 - nu) * big_l - 2.0 + 4.0 * nu)};
}

}  // namespace

KalkerCoefficients computeKalkerCoefficients(double a_over_b, double poisson) {
  assert(a_over_b > 0.0 && poisson >= 0.0 && poisson <= 0.5);
  const bool a_longer = a_over_b > 1.0;
  const double g = a_longer ? 1.0 / a_over_b : a_over_b;
  if (g >= kTableStep) return tableValue(a_longer, g, poisson);

  const auto asymptote = a_longer ? longAsymptote : narrowAsymptote;
  const KalkerCoefficients there = asymptote(g, poisson);
  const KalkerCoefficients end = asymptote(kTableStep, poisson);
  const KalkerCoefficients table = tableValue(a_longer, kTableStep, poisson);
  const double share = g / kTableStep;
  return {there.c11 * (1.0 + share * (table.c11 / end.c11 - 1.0)),
          there.c22 * (1.0 + share * (table.c22 / end.c22 - 1.0)),
          there.c23 * (1.0 + share * (table.c23 / end.c23 - 1.0))};
}

ContactPatch makeContactPatch(double a_m, double b_m, double normal_N, double shear_modulus_Pa, double poisson) {
  return {a_m, b_m, normal_N, shear_modulus_Pa, computeKalkerCoefficients(a_m / b_m, poisson)};
}

}  // namespace loco
