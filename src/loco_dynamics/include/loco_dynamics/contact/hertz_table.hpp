#pragma once

#include <vector>

#include "loco_dynamics/contact/hertz.hpp"
#include "loco_dynamics/contact/kalker.hpp"

namespace loco {

/// HertzContact for curvatures that change from step to step: what depends on the ratio of the curvatures is tabulated
/// once, what depends on their size follows from similarity, so that a contact costs two powers instead of elliptic
/// integrals.                                                                                             (C13)
///   a, b ~ along^(-1/3) f(across/along),   K ~ along^(-1/2) g(across/along)
/// Linear in ln(across/along) between entries; interpolation errs by less than 1e-5. Constant after construction.
class HertzTable {
 public:
  HertzTable(const Elasticity& elasticity);

  struct Contact {
    double a_unit, b_unit;  ///< semi-axes at 1 N [m]; with N they grow by N^(1/3)
    double stiffness;       ///< K [N/m^1.5]
    KalkerCoefficients kalker;
  };
  /// Both curvatures must be > 0. A ratio beyond e^-7 or e^7 is taken as that: no rail and wheel that touch at one
  /// place come near it.
  Contact at(const RelativeCurvature& curvature) const;

 private:
  std::vector<Contact> contacts_;  ///< for along = 1 1/m
};

}  // namespace loco
