#include "notch_table.hpp"

#include <algorithm>

#include "ltd_sim/csv_file.hpp"
#include "rail_core/constants.hpp"

namespace ltd {

namespace {

/// What a CSV reader cannot know.
void checkTable(const rail::CsvTable& table, const std::string& file, const CellRule& rule, rail::Problems& problems) {
  const auto refuse = [&](std::size_t row, std::size_t column, const std::string& words) {
    problems.add(file, "line " + std::to_string(table.line_of_row[row]) + ": " + table.columns[column],
                 allDigits(table.rows[row][column]), words);
  };
  const std::string header = "line " + std::to_string(table.line_of_header);
  if (table.columns.size() < 2) problems.add(file, header, "must have a column notch_1_N");
  if (table.rows.size() < 2) problems.add(file, "speed_kmph", "must have at least two rows");
  double largest_N = 0.0;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (i == 0 && table.rows[i][0] != 0.0) refuse(i, 0, "must start at 0 km/h");
    if (i > 0 && table.rows[i][0] <= table.rows[i - 1][0]) refuse(i, 0, "must rise from row to row");
    for (std::size_t j = 1; j < table.columns.size(); ++j) {
      if (table.rows[i][j] < 0.0) refuse(i, j, "must be a force >= 0");
      if (const std::string words = rule(table, i, j); !words.empty()) refuse(i, j, words);
      if (j > 1 && table.rows[i][j] < table.rows[i][j - 1]) refuse(i, j, "must not fall with the notch");
    }
    largest_N = std::max(largest_N, table.rows[i].back());
  }
  // Chosen, wider than any locomotive: kilonewtons given for newtons are noticed.
  if (table.columns.size() > 1 && (largest_N < 1e3 || largest_N > 1e7))
    problems.add(file, table.columns.back(), allDigits(largest_N), "the largest force must be from 1e3 to 1e7 N");
  for (std::size_t j = 1; j < table.columns.size(); ++j) {
    const std::string expected = "notch_" + std::to_string(j) + "_N";
    if (table.columns[j] != expected)
      problems.add(file, header + ": " + table.columns[j], "must be column " + expected);
  }
}

}  // namespace

std::vector<rail::LookupTable> readNotchTable(rail::YamlReader& reader, const CellRule& rule) {
  const std::string text = reader.text("table");
  if (text.empty()) return {};
  const std::string file = reader.file("table");
  const std::size_t problems_before = reader.problems().count();
  const rail::CsvTable csv = rail::readOpenCsv(text, file, "speed_kmph", reader.problems());
  if (reader.problems().count() == problems_before) checkTable(csv, file, rule, reader.problems());
  if (reader.problems().count() != problems_before) return {};
  std::vector<rail::LookupTable> force_of_notch;
  for (std::size_t j = 1; j < csv.columns.size(); ++j) {
    std::vector<double> speed_mps, force_N;
    for (const std::vector<double>& row : csv.rows) {
      speed_mps.push_back(row[0] / rail::kKmphPerMps);
      force_N.push_back(row[j]);
    }
    force_of_notch.emplace_back(speed_mps, force_N);
  }
  return force_of_notch;
}

}  // namespace ltd
