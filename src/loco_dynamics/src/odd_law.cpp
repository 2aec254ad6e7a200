#include "loco_dynamics/odd_law.hpp"

#include <algorithm>
#include <cmath>

namespace loco {

namespace {

/// What a law and its integral gain along a piece, from its beginning on.
struct PieceGain {
  double slope, value, integral;
};

PieceGain gainOf(const LawPiece& piece, double length, double x) {
  const double bend = piece.slope_rise == 0.0 ? 0.0 : piece.slope_rise / length;
  return {piece.slope + bend * x, (piece.slope + 0.5 * bend * x) * x, (0.5 * piece.slope + bend * x / 6.0) * x * x};
}

/// Slope, value and integral of the law at ax >= 0.
PieceGain evaluate(const std::vector<LawPiece>& pieces, double ax) {
  PieceGain sum{0.0, 0.0, 0.0};
  double from = 0.0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const bool last = i + 1 == pieces.size() || ax <= pieces[i].up_to;
    const double along = (last ? ax : pieces[i].up_to) - from;
    const PieceGain gain = gainOf(pieces[i], pieces[i].up_to - from, along);
    sum.integral += sum.value * along + gain.integral;
    sum.value += gain.value;
    sum.slope = gain.slope;
    if (last) break;
    from = pieces[i].up_to;
  }
  return sum;
}

}  // namespace

double OddLaw::operator()(double x) const {
  const double value = evaluate(pieces_, std::abs(x)).value;
  return x < 0.0 ? -value : value;
}

double OddLaw::slope(double x) const { return evaluate(pieces_, std::abs(x)).slope; }

double OddLaw::integral(double x) const { return evaluate(pieces_, std::abs(x)).integral; }

double OddLaw::largestSlope() const {
  double largest = 0.0;
  for (const LawPiece& piece : pieces_) largest = std::max({largest, piece.slope, piece.slope + piece.slope_rise});
  return largest;
}

}  // namespace loco
