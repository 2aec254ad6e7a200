#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "rail_core/csv_table.hpp"
#include "rail_core/yaml_reader.hpp"

namespace ltd {

/// Entries of one channel as they stand in the user's file, and how to refuse one of their cells.
struct DriverSource {
  bool given = false;
  std::vector<std::vector<double>> rows;  ///< [from, value] in the file's units
  double from_to_si = 1.0, value_to_si = 1.0;
  std::function<void(std::size_t row, std::size_t cell, const std::string& rule)> refuse;
};

/// The end of every rule that an air brake which is not there breaks.
inline constexpr const char* kNoAirBrake = "or the scenario must have an air_brake: it has none";

/// A column that the user named, and its unit.
struct Named {
  std::string name;
  double to_si = 1.0;
};

/// One column of a CSV that stands in the reader's map as `key`; the first column says from where.
DriverSource makeCsvSource(rail::YamlReader& reader, const std::string& key, const rail::CsvTable& csv,
                           std::size_t column);

}  // namespace ltd
