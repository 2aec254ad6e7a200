#pragma once

#include <functional>
#include <string>
#include <vector>

#include "rail_core/csv_table.hpp"
#include "rail_core/lookup_table.hpp"
#include "rail_core/yaml_reader.hpp"

namespace ltd {

/// A rule of its own for one cell of a notch table: empty, or what the force at this row and column must be.
using CellRule = std::function<std::string(const rail::CsvTable& table, std::size_t row, std::size_t column)>;

/// Reads `table` (usually table_file), forces by speed and notch: columns speed_kmph, notch_1_N ... notch_N_N; speed
/// starts at 0 and rises, forces are >= 0 and stay or rise with the notch. Messages name the line.
/// @return force [N] over speed [m/s], one per notch from 1; empty if anything was refused
std::vector<rail::LookupTable> readNotchTable(rail::YamlReader& reader, const CellRule& rule);

}  // namespace ltd
