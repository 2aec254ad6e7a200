#pragma once

#include <string>
#include <vector>

#include "rail_core/problems.hpp"

namespace rail {

/// A CSV text of numbers: first line the column names, `#` starts a comment line, blank lines are skipped, LF or CRLF.
/// Values are kept as numbers with the line each row came from, so that messages can name it.
struct CsvTable {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;  ///< rows[i][j] belongs to columns[j]
  std::vector<int> line_of_row;           ///< 1-based line in the text
  int line_of_header = 1;

  /// Index of a column; -1 if there is none.
  int column(const std::string& name) const;
};

/// Reads a table that must have exactly the named columns, in any order; the result has them in the order of `columns`.
/// Problems read `file: line 17: chainage_km = 3,2: must be a number`.
CsvTable readCsv(const std::string& text, const std::string& file, const std::vector<std::string>& columns,
                 Problems& problems);

/// Reads the named columns of a table that may have others; what stands in those is of no matter, it need not be a
/// number.
CsvTable readCsvColumns(const std::string& text, const std::string& file, const std::vector<std::string>& columns,
                        Problems& problems);

/// Reads a table whose columns the file names itself (`first` must be the name of the first one).
CsvTable readOpenCsv(const std::string& text, const std::string& file, const std::string& first, Problems& problems);

}  // namespace rail
