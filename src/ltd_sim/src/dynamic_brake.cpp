#include "ltd_sim/dynamic_brake.hpp"

#include <algorithm>

#include "ltd_sim/csv_file.hpp"
#include "rail_core/constants.hpp"
#include "rail_core/csv_table.hpp"

namespace ltd {

namespace {

constexpr int kMostNotches = 100;  // chosen: more than any controller has, and a typing error is found

// Chosen, wider than any locomotive: kilonewtons given for newtons, or kilowatts for watts, are noticed.
const rail::Range kForces = rail::between(1e3, 1e7);
const rail::Range kPowers = rail::between(1e4, 1e9);

/// Rules of a table that a CSV reader cannot know; messages name the line.
void checkTable(const rail::CsvTable& table, const std::string& file, rail::Problems& problems) {
  const auto refuse = [&](std::size_t row, std::size_t column, const std::string& rule) {
    problems.add(file, "line " + std::to_string(table.line_of_row[row]) + ": " + table.columns[column],
                 allDigits(table.rows[row][column]), rule);
  };
  if (table.columns.size() < 2) problems.add(file, "line 1", "must have a column notch_1_N");
  if (table.rows.size() < 2) problems.add(file, "speed_kmph", "must have at least two rows");
  for (std::size_t j = 1; j < table.columns.size(); ++j) {
    const std::string expected = "notch_" + std::to_string(j) + "_N";
    if (table.columns[j] != expected) problems.add(file, "line 1: " + table.columns[j], "must be column " + expected);
  }
  double largest_N = 0.0;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (i == 0 && table.rows[i][0] != 0.0) refuse(i, 0, "must start at 0 km/h");
    if (i > 0 && table.rows[i][0] <= table.rows[i - 1][0]) refuse(i, 0, "must rise from row to row");
    for (std::size_t j = 1; j < table.columns.size(); ++j) {
      if (table.rows[i][j] < 0.0) refuse(i, j, "must be a retarding force >= 0");
      if (i == 0 && table.rows[i][j] != 0.0) refuse(i, j, "must be 0: motors cannot hold a standing train");
      if (j > 1 && table.rows[i][j] < table.rows[i][j - 1]) refuse(i, j, "must not fall with the notch");
      largest_N = std::max(largest_N, table.rows[i][j]);
    }
  }
  if (table.columns.size() > 1 && (largest_N < kForces.low || largest_N > kForces.high))
    problems.add(file, table.columns.back(), allDigits(largest_N), "the largest force must be from 1e3 to 1e7 N");
}

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
  const std::string text = reader.text("table");
  if (text.empty()) return;
  const std::string file = reader.file("table");
  const std::size_t problems_before = reader.problems().count();
  const rail::CsvTable csv = rail::readOpenCsv(text, file, "speed_kmph", reader.problems());
  if (reader.problems().count() == problems_before) checkTable(csv, file, reader.problems());
  if (reader.problems().count() != problems_before) return;
  notches_ = static_cast<int>(csv.columns.size()) - 1;
  for (std::size_t j = 1; j < csv.columns.size(); ++j) {
    std::vector<double> speed_mps, force_N;
    for (const std::vector<double>& row : csv.rows) {
      speed_mps.push_back(row[0] / rail::kKmphPerMps);
      force_N.push_back(row[j]);
    }
    force_of_notch_.emplace_back(speed_mps, force_N);
  }
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
