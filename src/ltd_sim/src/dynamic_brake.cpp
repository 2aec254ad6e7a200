#include "ltd_sim/dynamic_brake.hpp"

#include <algorithm>

#include "notch_table.hpp"
#include "rail_core/constants.hpp"

namespace ltd {

namespace {

constexpr int kMostNotches = 100;  // chosen: more than any controller has, and a typing error is found

// Chosen, wider than any locomotive: kilonewtons given for newtons, or kilowatts for watts, are noticed.
const rail::Range kForces = rail::between(1e3, 1e7);
const rail::Range kPowers = rail::between(1e4, 1e9);

}  // namespace

DynamicBrake DynamicBrake::read(rail::YamlReader reader) {
  DynamicBrake b;
  const std::size_t problems_before = reader.problems().count();
  if (reader.choice("law", {"limits", "table"}) == "table") {
    b.readTable(reader);
  } else {
    b.notches_ = reader.integer("notches", 1, kMostNotches);
    b.largest_force_N_ = reader.number("largest_force_N", kForces);
    b.power_at_rail_W_ = reader.number("power_at_rail_W", kPowers);
    b.fade_to_mps_ = reader.number("fade_to_kmph", rail::between(0.0, 100.0)) / rail::kKmphPerMps;
    b.fade_from_mps_ = reader.number("fade_from_kmph", rail::between(0.0, 100.0)) / rail::kKmphPerMps;
    if (reader.problems().count() == problems_before && b.fade_from_mps_ <= b.fade_to_mps_)
      reader.refuse("fade_from_kmph", "must be above fade_to_kmph: the force fades from the one down to the other");
  }
  b.rise_N_per_s_ = reader.number("rise_N_per_s", rail::positive());
  b.fall_N_per_s_ = reader.number("fall_N_per_s", rail::positive());
  if (reader.problems().count() != problems_before) b.notches_ = kMostNotches;  // unknown: refuse none for it
  reader.finish();
  return b;
}

void DynamicBrake::readTable(rail::YamlReader& reader) {
  force_of_notch_ = readNotchTable(reader, [](const rail::CsvTable& table, std::size_t row, std::size_t column) {
    const bool pushes = row == 0 && table.rows[row][column] != 0.0;
    return std::string(pushes ? "must be 0: motors cannot hold a standing train" : "");
  });
  notches_ = static_cast<int>(force_of_notch_.size());
}

double DynamicBrake::computeForce(int notch, double v_mps) const {
  if (notch <= 0 || v_mps <= 0.0) return 0.0;
  if (!force_of_notch_.empty()) {
    const rail::LookupTable& force = force_of_notch_[static_cast<std::size_t>(notch) - 1];
    const double v_last = force.x().back();
    return v_mps <= v_last ? force(v_mps) : force.y().back() * v_last / v_mps;
  }
  const double share = static_cast<double>(notch) / notches_;
  const double fade = std::clamp((v_mps - fade_to_mps_) / (fade_from_mps_ - fade_to_mps_), 0.0, 1.0);
  return share * std::min(largest_force_N_ * fade, power_at_rail_W_ / v_mps);  // (D1)
}

double DynamicBrake::computeResponse(double last_N, double target_N, double step_s) const {
  return std::clamp(target_N, last_N - fall_N_per_s_ * step_s, last_N + rise_N_per_s_ * step_s);  // (T4)
}

double DynamicBrake::largestForce() const {
  if (force_of_notch_.empty()) return largest_force_N_;
  return *std::max_element(force_of_notch_.back().y().begin(), force_of_notch_.back().y().end());
}

}  // namespace ltd
