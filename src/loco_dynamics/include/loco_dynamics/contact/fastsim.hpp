#pragma once

#include <vector>

#include "loco_dynamics/contact/contact_patch.hpp"
#include "loco_dynamics/contact/flexibility.hpp"

namespace loco {

/// Kalker's simplified theory, integrated over a grid of an elliptic patch.                               (C8), (C9)
///
/// The patch is cut into `strips` along x, at equal steps of the ellipse's angle (y/b = sin t: narrower towards the
/// sides, where the midpoint rule then errs less than with equal widths), each strip into `cells` of equal length.
/// Along a strip, from the leading edge to the trailing one, the stress p on the wheel follows
///   L dp/dx = xi_x - phi y, xi_y + phi x   where it sticks,   |p| = mu p_n, against the slip,   where it slips,
/// with the parabolic pressure p_n = 2N/(pi a b) (1 - x^2/a^2 - y^2/b^2), normalised such that the cells carry N: full
/// slip gives mu N on any grid.
///
/// Stress is taken at the cells' midpoints, so a step between two of them has its rigid slip at the edge between. In
/// slip the direction of p relaxes towards that of the rigid slip within a distance that may be far below a cell: the
/// step then uses the exponential that solves this to second order (see docs/contact.md), for which plain FASTSIM
/// needs a grid 5 times finer.
/// Source: Kalker, Vehicle System Dynamics 11, 1982; integration in slip: ours.
class FastsimGrid {
 public:
  /// Everything that does not depend on the patch; 1 <= cells, strips <= kMostCells.
  FastsimGrid(int cells, int strips);
  static constexpr int kMostCells = 1000;

  struct Force {
    double x_N;
    double y_N;
  };
  /// Forces on the wheel. Allocates nothing; sums run in a fixed order, mirrored strips in pairs, so a mirrored
  /// creepage gives the mirrored force to the last bit.
  /// @param flexibility  already divided by the reduction factor k
  /// @param mu           friction of the whole patch, > 0; patch.normal_N must be > 0
  Force computeForce(const ContactPatch& patch, const Flexibilities& flexibility, const Creepage& creepage,
                     double mu) const;

  int cells() const { return cells_; }
  int strips() const { return strips_; }

 private:
  int cells_;
  int strips_;
  int lanes_;                         ///< strips, filled up with strips of no weight for the vector registers
  std::vector<double> y_;             ///< y/b of each strip's middle
  std::vector<double> one_over_eta_;  ///< eta = sqrt(1 - (y/b)^2): half chord over a
  std::vector<double> weight_;        ///< ~ eta^4 (load eta^3, width eta), such that full slip gives 1
  std::vector<double> place_;         ///< x over the half chord of each cell's middle, from the leading edge on
  std::vector<double> bound_;         ///< 1 - place^2
};

}  // namespace loco
