#include "train_viz/colour_scale.hpp"

#include <algorithm>
#include <cmath>

namespace viz {

namespace {

// Chosen: draft and buff are told apart by the colour-blind too, and both from the track's grey.
constexpr Colour kNoForce{0.75, 0.75, 0.75, 1.0};
constexpr Colour kDraft{0.95, 0.05, 0.05, 1.0};
constexpr Colour kBuff{0.05, 0.25, 1.0, 1.0};
constexpr Colour kUnused{0.1, 0.85, 0.2, 1.0};
constexpr Colour kHalfUsed{1.0, 0.9, 0.1, 1.0};
constexpr Colour kAllUsed{0.95, 0.05, 0.05, 1.0};

Colour mix(const Colour& from, const Colour& to, double share) {
  const auto part = [&](double a, double b) { return a + share * (b - a); };
  return {part(from.r, to.r), part(from.g, to.g), part(from.b, to.b), part(from.a, to.a)};
}

}  // namespace

Colour couplerColour(double force_N) {
  const double share = std::min(std::abs(force_N) / kFullCouplerForce_N, 1.0);
  return mix(kNoForce, force_N < 0.0 ? kBuff : kDraft, share);
}

Colour adhesionColour(double use) {
  const double share = std::min(2.0 * use, 2.0);
  return share < 1.0 ? mix(kUnused, kHalfUsed, share) : mix(kHalfUsed, kAllUsed, share - 1.0);
}

}  // namespace viz
