#include "ltd_sim/coupler.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ltd {

Coupler::Coupler(Parameters parameters) : parameters_(std::move(parameters)) {
  Knot knot{0.0, 0.0, 0.0, 0.0};
  for (const Parameters::Piece& piece : parameters_.loading) {
    knot.stiffness_N_per_m = piece.stiffness_N_per_m;
    knots_.push_back(knot);
    const double length = piece.up_to_m - knot.deflection_m;
    knot.energy_J += knot.force_N * length + 0.5 * piece.stiffness_N_per_m * length * length;
    knot.force_N += piece.stiffness_N_per_m * length;
    knot.deflection_m = piece.up_to_m;
  }
}

/// Chosen, as wide as the slack may be: no gear travels as far, millimetres given for metres are noticed.
constexpr double kLongestTravel_m = 1.0;

Coupler::Parameters Coupler::read(rail::YamlReader reader) {
  Parameters p;
  reader.text("name");
  p.slack_m = reader.number("slack_m", rail::between(0.0, 1.0));
  p.unloading_ratio = reader.number("unloading_ratio", rail::aboveUpTo(0.0, 1.0));
  p.smoothing_speed_mps = reader.number("smoothing_speed_mps", rail::positive());
  std::vector<rail::YamlReader> pieces = reader.maps("loading");
  if (pieces.empty() && reader.has("loading")) reader.refuse("loading", "must have at least one piece");
  double last_m = 0.0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Parameters::Piece piece;
    piece.stiffness_N_per_m = pieces[i].number("stiffness_N_per_m", rail::positive());
    if (i + 1 < pieces.size()) {
      piece.up_to_m = pieces[i].number("up_to_m", rail::aboveUpTo(last_m, kLongestTravel_m));
      last_m = piece.up_to_m;
    } else if (pieces[i].has("up_to_m")) {
      pieces[i].number("up_to_m", rail::anyNumber());
      pieces[i].refuse("up_to_m", "the last piece goes on for ever and must have no end");
    }
    pieces[i].finish();
    p.loading.push_back(piece);
  }
  reader.finish();
  return p;
}

Coupler::Loading Coupler::loadingAt(double deflection_m) const {
  std::size_t i = knots_.size() - 1;
  while (i > 0 && deflection_m < knots_[i].deflection_m) --i;
  const Knot& k = knots_[i];
  const double d = deflection_m - k.deflection_m;
  return {k.force_N + k.stiffness_N_per_m * d, k.energy_J + (k.force_N + 0.5 * k.stiffness_N_per_m * d) * d};
}

Coupler::Force Coupler::computeForce(double elongation_m, double elongation_speed_mps) const {
  const double x = elongation_m;
  const double d = std::abs(x) - 0.5 * parameters_.slack_m;
  if (d <= 0.0) return {};
  const double sign = x > 0.0 ? 1.0 : -1.0;
  const double L = sign * loadingAt(d).force_N;
  const double U = parameters_.unloading_ratio * L;
  const double vs = parameters_.smoothing_speed_mps;
  Force result;
  result.mean_N = 0.5 * (L + U);
  result.force_N = result.mean_N + 0.5 * (L - U) * std::tanh(sign * elongation_speed_mps / vs);  // (T2)
  result.friction_N_s_per_m = 0.5 * std::abs(L - U) / vs;
  return result;
}

double Coupler::computeStoredEnergy(double elongation_m) const {
  const double d = std::abs(elongation_m) - 0.5 * parameters_.slack_m;
  return d <= 0.0 ? 0.0 : 0.5 * (1.0 + parameters_.unloading_ratio) * loadingAt(d).energy_J;
}

double Coupler::deflectionAt(double force_N) const {
  std::size_t i = knots_.size() - 1;
  while (i > 0 && force_N < knots_[i].force_N) --i;
  return knots_[i].deflection_m + (force_N - knots_[i].force_N) / knots_[i].stiffness_N_per_m;
}

double Coupler::stiffnessUpTo(double force_N) const {
  double largest = knots_.front().stiffness_N_per_m;
  for (const Knot& knot : knots_) {
    if (knot.force_N < force_N) largest = std::max(largest, knot.stiffness_N_per_m);
  }
  return largest;
}

}  // namespace ltd
