#pragma once

#include <utility>
#include <vector>

namespace loco {

/// One piece of a law odd in its argument, from the end of the previous one: straight, or with a slope that changes
/// linearly along it.
struct LawPiece {
  double up_to = 0.0;  ///< magnitude at which the piece ends; the last goes on for ever
  double slope = 0.0;
  double slope_rise = 0.0;  ///< by how much the slope is larger at the end; none in the last piece
};

/// Law in pieces, odd and continuous: force over displacement [N/m], or over speed [N s/m].
class OddLaw {
 public:
  OddLaw() = default;
  explicit OddLaw(std::vector<LawPiece> pieces) : pieces_(std::move(pieces)) {}
  double operator()(double x) const;
  double slope(double x) const;
  double integral(double x) const;  ///< from 0 to x, >= 0 for rising laws
  double largestSlope() const;

 private:
  std::vector<LawPiece> pieces_;
};

}  // namespace loco
