#include "ltd_sim/traction_characteristic.hpp"

#include <algorithm>
#include <string>

#include "notch_table.hpp"
#include "rail_core/constants.hpp"

namespace ltd {

namespace {

constexpr int kMostNotches = 100;  // chosen: more than any controller has, and a typing error is found

// Chosen, wider than any locomotive: kilonewtons given for newtons, or kilowatts for watts, are noticed.
const rail::Range kForces = rail::between(1e3, 1e7);
const rail::Range kPowers = rail::between(1e4, 1e9);

/// Largest F v of a force that is linear in v between its points [W]: at a point, or where the parabola between two of
/// them has its vertex.
double largestPower(const std::vector<double>& v_mps, const std::vector<double>& F_N) {
  double power_W = 0.0;
  for (std::size_t i = 0; i < v_mps.size(); ++i) {
    power_W = std::max(power_W, F_N[i] * v_mps[i]);
    if (i == 0 || F_N[i] == F_N[i - 1]) continue;
    const double slope = (F_N[i] - F_N[i - 1]) / (v_mps[i] - v_mps[i - 1]);
    const double v = 0.5 * (v_mps[i] - F_N[i] / slope);
    if (v > v_mps[i - 1] && v < v_mps[i]) power_W = std::max(power_W, (F_N[i] + slope * (v - v_mps[i])) * v);
  }
  return power_W;
}

}  // namespace

TractionCharacteristic TractionCharacteristic::read(rail::YamlReader reader) {
  TractionCharacteristic c;
  const std::size_t problems_before = reader.problems().count();
  const bool table = reader.choice("law", {"limits", "table"}) == "table";
  c.law_ = table ? Law::kTable : Law::kLimits;
  if (table) {
    c.readTable(reader);
  } else {
    c.notches_ = reader.integer("notches", 1, kMostNotches);
    c.largest_force_N_ = reader.number("largest_force_N", kForces);
    c.force_slope_N_s_per_m_ = reader.number("force_slope_N_s_per_m", rail::notNegative());
    c.power_at_rail_W_ = reader.number("power_at_rail_W", kPowers);
  }
  c.rise_N_per_s_ = reader.number("rise_N_per_s", rail::positive());
  c.fall_N_per_s_ = reader.number("fall_N_per_s", rail::positive());
  if (reader.problems().count() != problems_before) c.notches_ = kMostNotches;  // unknown: refuse none for it
  reader.finish();
  return c;
}

void TractionCharacteristic::readTable(rail::YamlReader& reader) {
  force_of_notch_ = readNotchTable(reader, [](const rail::CsvTable& table, std::size_t row, std::size_t column) {
    const bool rises = row > 0 && table.rows[row][column] > table.rows[row - 1][column];
    return std::string(rises ? "must not rise with speed" : "");
  });
  notches_ = static_cast<int>(force_of_notch_.size());
  for (const rail::LookupTable& force : force_of_notch_)
    power_of_notch_W_.push_back(largestPower(force.x(), force.y()));
}

double TractionCharacteristic::computeForce(int notch, double v_mps) const {
  if (notch <= 0) return 0.0;
  const double v = std::max(v_mps, 0.0);
  if (law_ == Law::kTable) {
    const rail::LookupTable& force = force_of_notch_[static_cast<std::size_t>(notch) - 1];
    const double v_last = force.x().back();
    return v <= v_last ? force(v) : force.y().back() * v_last / v;
  }
  const double share = static_cast<double>(notch) / notches_;
  const double by_force = share * std::max(largest_force_N_ - force_slope_N_s_per_m_ * v, 0.0);
  const double power_W = computeRimPowerLimit(notch);
  return by_force * v <= power_W ? by_force : power_W / v;  // (T3)
}

double TractionCharacteristic::computeRimPowerLimit(int notch) const {
  if (notch <= 0) return 0.0;
  if (law_ == Law::kTable) return power_of_notch_W_[static_cast<std::size_t>(notch) - 1];
  const double share = static_cast<double>(notch) / notches_;
  return share * share * power_at_rail_W_;
}

double TractionCharacteristic::computeResponse(double last_N, double target_N, double step_s) const {
  return std::clamp(target_N, last_N - fall_N_per_s_ * step_s, last_N + rise_N_per_s_ * step_s);  // (T4)
}

double TractionCharacteristic::largestForce() const {
  if (law_ == Law::kLimits) return largest_force_N_;
  return force_of_notch_.empty() ? 0.0 : force_of_notch_.back().y().front();
}

}  // namespace ltd
