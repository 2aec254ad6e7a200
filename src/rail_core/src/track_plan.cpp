#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "rail_core/track.hpp"

namespace rail {

/// Gives every piece's cant its sign: the outer rail is the right one where the curvature is to the left.
void Track::buildCant() {
  std::vector<double> side(pieces_.size(), 0.0);  // +1: the left rail is the outer one
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Piece& piece = pieces_[i];
    const double length_m = i + 1 < pieces_.size() ? pieces_[i + 1].s_m - piece.s_m : 0.0;
    const double middle_1pm = piece.curvature_1pm + 0.5 * piece.curvature_slope_1pm2 * length_m;
    if (middle_1pm != 0.0) side[i] = middle_1pm > 0.0 ? -1.0 : 1.0;
  }
  for (std::size_t i = pieces_.size(); i-- > 1;)
    if (side[i - 1] == 0.0) side[i - 1] = side[i];
  for (std::size_t i = 1; i < pieces_.size(); ++i)
    if (side[i] == 0.0) side[i] = side[i - 1];
  double integral_m2 = 0.0, outer_integral_m2 = 0.0;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    Piece& piece = pieces_[i];
    piece.left_cant_m = side[i] * piece.cant_m;
    piece.left_cant_slope = side[i] * piece.cant_slope;
    piece.left_cant_integral_m2 = integral_m2;
    piece.cant_integral_m2 = outer_integral_m2;
    canted_ = canted_ || piece.cant_m != 0.0 || piece.cant_slope != 0.0;
    if (i + 1 == pieces_.size()) break;
    const double length_m = pieces_[i + 1].s_m - piece.s_m;
    integral_m2 += (piece.left_cant_m + 0.5 * piece.left_cant_slope * length_m) * length_m;
    outer_integral_m2 += (piece.cant_m + 0.5 * piece.cant_slope * length_m) * length_m;
  }
}

double Track::largestCurvature() const {
  double largest_1pm = 0.0;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Piece& piece = pieces_[i];
    const double length_m = i + 1 < pieces_.size() ? pieces_[i + 1].s_m - piece.s_m : 0.0;
    largest_1pm = std::max({largest_1pm, std::abs(piece.curvature_1pm),
                            std::abs(piece.curvature_1pm + piece.curvature_slope_1pm2 * length_m)});
  }
  return largest_1pm;
}

TrackStretch Track::stretch(double from_m, double to_m, std::size_t& hint) const {
  if (pieces_.empty()) return {};
  hint = findPiece(from_m, hint);
  const bool ahead = to_m >= from_m;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto count = static_cast<std::ptrdiff_t>(pieces_.size());
  const auto beginOf = [&](std::ptrdiff_t i) {
    return i < 0 ? -kInfinity : i < count ? pieces_[static_cast<std::size_t>(i)].s_m : kInfinity;
  };
  TrackStretch sum;
  double s_m = from_m;
  for (std::ptrdiff_t i = from_m < beginOf(0) ? -1 : static_cast<std::ptrdiff_t>(hint);; i += ahead ? 1 : -1) {
    const double end_m = beginOf(i + 1), begin_m = beginOf(i);
    const bool last = !(to_m > end_m) && !(to_m < begin_m);
    const double D = (last ? to_m : ahead ? end_m : begin_m) - s_m;
    const Piece& piece = pieces_[i < 0 ? 0 : static_cast<std::size_t>(i)];
    const double slope = i < 0 ? 0.0 : piece.curvature_slope_1pm2;  // before the start the value there holds
    const double kappa = piece.curvature_1pm + slope * (s_m - piece.s_m);
    sum.lateral_m += (sum.heading_rad + (0.5 * kappa + slope * D / 6.0) * D) * D;  // (T10)
    sum.heading_rad += (kappa + 0.5 * slope * D) * D;
    if (last) return sum;
    s_m += D;
  }
}

double TrackCant::computeRoll_rad() const { return std::asin(left_m / kCantBaseline_m); }

double TrackCant::computeRollSlope_1pm() const {
  return slope / std::sqrt(kCantBaseline_m * kCantBaseline_m - left_m * left_m);
}

TrackCant Track::cant(double s_m, double window_m, std::size_t& hint) const {
  if (!canted_) return {};
  hint = findPiece(s_m, hint);
  struct End {
    double left_m, left_integral_m2, outer_m, outer_integral_m2;
  } ends[2];
  for (int end = 0; end < 2; ++end) {
    const double at_m = s_m + (end == 0 ? -0.5 : 0.5) * window_m;
    const Piece& piece = pieces_[findPiece(at_m, hint)];
    const double beyond_m = at_m - piece.s_m;
    const double inside = beyond_m < 0.0 ? 0.0 : 1.0;  // before the start the value there holds
    const double left_slope = inside * piece.left_cant_slope, outer_slope = inside * piece.cant_slope;
    ends[end] = {piece.left_cant_m + left_slope * beyond_m,
                 piece.left_cant_integral_m2 + (piece.left_cant_m + 0.5 * left_slope * beyond_m) * beyond_m,
                 piece.cant_m + outer_slope * beyond_m,
                 piece.cant_integral_m2 + (piece.cant_m + 0.5 * outer_slope * beyond_m) * beyond_m};
  }
  return {(ends[1].left_integral_m2 - ends[0].left_integral_m2) / window_m,
          (ends[1].left_m - ends[0].left_m) / window_m,
          (ends[1].outer_integral_m2 - ends[0].outer_integral_m2) / window_m,
          (ends[1].outer_m - ends[0].outer_m) / window_m};
}

}  // namespace rail
