#pragma once

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "loco_dynamics/contact/creep_law.hpp"

namespace fixtures {

/// Rows of a CSV file, each by column name; cells are text.
using Rows = std::vector<std::map<std::string, std::string>>;

inline std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line.substr(0, line.find('\r')));
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

inline Rows readRows(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + " cannot be read");
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> header = cellsOf(line);
  Rows rows;
  while (std::getline(file, line)) {
    const std::vector<std::string> cells = cellsOf(line);
    std::map<std::string, std::string> row;
    for (std::size_t j = 0; j < cells.size(); ++j) row[header.at(j)] = cells[j];
    rows.push_back(row);
  }
  return rows;
}

inline double numberAt(const std::map<std::string, std::string>& row, const std::string& column) {
  return std::stod(row.at(column));
}

/// Largest and root mean square of many differences.
struct Distance {
  double largest = 0.0;
  double squares = 0.0;
  int count = 0;

  void add(double difference) {
    largest = std::max(largest, std::abs(difference));
    squares += difference * difference;
    ++count;
  }
  double rms() const { return std::sqrt(squares / count); }
};

/// The ellipse of the reference tables: a 6 mm, b 4 mm, 100 kN, steel.
inline loco::ContactPatch tablePatch() { return loco::makeContactPatch(6e-3, 4e-3, 100e3, 82e9, 0.28); }

inline loco::CreepLawParameters coulomb(loco::CreepMethod method, double mu, int cells = 20, int strips = 20) {
  loco::CreepLawParameters parameters;
  parameters.method = method;
  parameters.friction = {mu, 1.0, 0.0};
  parameters.cells = cells;
  parameters.strips = strips;
  return parameters;
}

}  // namespace fixtures
