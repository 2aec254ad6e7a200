#pragma once

namespace loco {

/// Creepage coefficients of the linear theory of rolling contact for an ellipse.
struct KalkerCoefficients {
  double c11 = 0.0;
  double c22 = 0.0;
  double c23 = 0.0;
};

/// C11, C22, C23 by interpolation: linear in g = min(a/b, b/a), a parabola in nu through 1/C.                (C3)
/// Below g = 0.1, where the table ends, the asymptote for g -> 0, scaled such that it meets the table at 0.1 and is
/// itself at 0: continuous, while the bare asymptotes would jump by up to 6 % there.
/// @param a_over_b  semi-axis along rolling over the one across, > 0
/// @param poisson   Poisson's ratio, 0 <= nu <= 0.5
/// Source: Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, 1990, Table E.3.
KalkerCoefficients computeKalkerCoefficients(double a_over_b, double poisson);

}  // namespace loco
