#include "rail_core/csv_table.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "rail_core/number_text.hpp"
#include "text_fault.hpp"
#include "words.hpp"

namespace rail {
namespace {

/// A line of the text that is neither blank nor a comment.
struct Line {
  int number;  ///< 1-based
  std::vector<std::string> cells;
};

std::string trimmed(const std::string& text) {
  const char* const blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Cells of one line. A comma within double quotes does not separate; the quotes are not part of the cell.
std::vector<std::string> splitCells(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  for (std::string& cell : cells) cell = trimmed(cell);
  return cells;
}

std::vector<Line> splitLines(const std::string& text) {
  const std::string byte_order_mark = "\xEF\xBB\xBF";  // what spreadsheets write first: no content
  std::size_t begin = text.compare(0, byte_order_mark.size(), byte_order_mark) == 0 ? byte_order_mark.size() : 0;
  std::vector<Line> lines;
  for (int number = 1; begin < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = trimmed(text.substr(begin, end - begin));
    if (!line.empty() && line.front() != '#') lines.push_back({number, splitCells(line)});
    begin = end + 1;
  }
  return lines;
}

/// The lines with cells; none, with the problem added, if there are none or the text is no text.
std::vector<Line> readLines(const std::string& text, const std::string& file, Problems& problems) {
  const std::string fault = textFault(text);
  const std::vector<Line> lines = fault.empty() ? splitLines(text) : std::vector<Line>();
  if (lines.empty()) problems.add(file, "", fault.empty() ? "is empty" : fault);
  return lines;
}

std::string lineKey(int number) { return "line " + std::to_string(number); }

/// Rules that hold for every header. False if its columns cannot be told apart.
bool checkHeader(const Line& header, const std::string& file, Problems& problems) {
  const std::string key = lineKey(header.number);
  const std::vector<std::string>& names = header.cells;
  for (const auto& [separator, word] : {std::pair(';', "';'"), std::pair('\t', "tabs")}) {
    if (names.front().find(separator) == std::string::npos) continue;
    problems.add(file, key, "columns must be separated by ',', not by " + std::string(word));
    return false;
  }
  bool good = true;
  for (std::size_t j = 0; j < names.size(); ++j) {
    const bool repeated = std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(j), names[j]) !=
                          names.begin() + static_cast<std::ptrdiff_t>(j);
    if (names[j].empty()) {
      const char* const hint = j > 0 && j + 1 == names.size() ? " (a comma at the end of the line?)" : "";
      problems.add(file, key, "column " + std::to_string(j + 1) + " has no name" + hint);
    } else if (repeated) {
      problems.add(file, key, "column '" + names[j] + "' is given twice");
    }
    good = good && !names[j].empty() && !repeated;
  }
  return good;
}

/// False if there are columns that nobody knows.
bool checkKnown(const Line& header, const std::string& file, const std::vector<std::string>& columns,
                Problems& problems) {
  bool good = true;
  for (const std::string& name : header.cells) {
    if (contains(columns, name)) continue;
    const std::string near = nearestWord(name, columns);
    problems.add(file, lineKey(header.number),
                 "unknown column '" + name + "'" + (near.empty() ? "" : ", did you mean '" + near + "'?"));
    good = false;
  }
  return good;
}

/// False if a column is missing.
bool checkComplete(const Line& header, const std::string& file, const std::vector<std::string>& columns,
                   Problems& problems) {
  const std::string key = lineKey(header.number);
  bool good = true;
  for (const std::string& name : columns) {
    if (contains(header.cells, name)) continue;
    problems.add(file, key, "column '" + name + "' is missing");
    good = false;
  }
  return good;
}

std::optional<double> readCell(const std::string& cell, const std::string& file, const std::string& key,
                               Problems& problems) {
  const std::optional<double> number = parseNumber(cell);
  if (number) return number;
  if (cell.empty()) {
    problems.add(file, key, "is empty: must be a number");
  } else if (isDecimal(cell)) {
    problems.add(file, key, cell, "is beyond the range of a double");
  } else {
    const bool comma = cell.find(',') != std::string::npos;
    const bool unit = isDecimal(cell.substr(0, cell.find_first_not_of("+-.0123456789")));
    const char* const hint = comma ? ", with a decimal point" : unit ? ", without unit or other text" : "";
    problems.add(file, key, cell, std::string("must be a number") + hint);
  }
  return std::nullopt;
}

/// One row, its cells in the file's order, those of other columns than `columns` as 0 whatever stands there; nothing if
/// anything is wrong with it.
std::optional<std::vector<double>> readRow(const Line& line, const std::vector<std::string>& names,
                                           const std::vector<std::string>& columns, const std::string& file,
                                           Problems& problems) {
  if (line.cells.size() != names.size()) {
    const char* const hint = line.cells.size() > names.size() ? " (a decimal comma?)" : "";
    problems.add(
        file, lineKey(line.number),
        "has " + std::to_string(line.cells.size()) + " cells, the header names " + std::to_string(names.size()) + hint);
    return std::nullopt;
  }
  if (std::all_of(line.cells.begin(), line.cells.end(), [](const std::string& cell) { return cell.empty(); })) {
    problems.add(file, lineKey(line.number), "has only empty cells: remove it");
    return std::nullopt;
  }
  std::vector<double> row;
  for (std::size_t j = 0; j < names.size(); ++j) {
    if (!contains(columns, names[j])) {
      row.push_back(0.0);
      continue;
    }
    const std::optional<double> cell = readCell(line.cells[j], file, lineKey(line.number) + ": " + names[j], problems);
    if (cell) row.push_back(*cell);
  }
  if (row.size() != names.size()) return std::nullopt;
  return row;
}

/// The rows below the header, with the columns in the order of `columns`.
CsvTable readRows(const std::vector<Line>& lines, const std::string& file, const std::vector<std::string>& columns,
                  Problems& problems) {
  CsvTable table;
  table.columns = columns;
  table.line_of_header = lines.front().number;
  const std::vector<std::string>& names = lines.front().cells;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::optional<std::vector<double>> cells = readRow(lines[i], names, columns, file, problems);
    if (!cells) continue;
    std::vector<double> row;
    for (const std::string& column : columns) {
      const auto at = std::find(names.begin(), names.end(), column) - names.begin();
      row.push_back((*cells)[static_cast<std::size_t>(at)]);
    }
    table.rows.push_back(std::move(row));
    table.line_of_row.push_back(lines[i].number);
  }
  if (lines.size() < 2) problems.add(file, "", "has no rows");
  return table;
}

}  // namespace

int CsvTable::column(const std::string& name) const {
  const auto at = std::find(columns.begin(), columns.end(), name);
  return at == columns.end() ? -1 : static_cast<int>(at - columns.begin());
}

namespace {

CsvTable readNamed(const std::string& text, const std::string& file, const std::vector<std::string>& columns,
                   bool others_allowed, Problems& problems) {
  CsvTable empty;
  empty.columns = columns;
  const std::vector<Line> lines = readLines(text, file, problems);
  if (lines.empty()) return empty;
  if (!checkHeader(lines.front(), file, problems)) return empty;
  const bool known = others_allowed || checkKnown(lines.front(), file, columns, problems);
  const bool complete = checkComplete(lines.front(), file, columns, problems);
  if (!known || !complete) return empty;
  return readRows(lines, file, columns, problems);
}

}  // namespace

CsvTable readCsv(const std::string& text, const std::string& file, const std::vector<std::string>& columns,
                 Problems& problems) {
  return readNamed(text, file, columns, false, problems);
}

CsvTable readCsvColumns(const std::string& text, const std::string& file, const std::vector<std::string>& columns,
                        Problems& problems) {
  return readNamed(text, file, columns, true, problems);
}

CsvTable readOpenCsv(const std::string& text, const std::string& file, const std::string& first, Problems& problems) {
  const std::vector<Line> lines = readLines(text, file, problems);
  if (lines.empty()) return {};
  const Line& header = lines.front();
  if (!checkHeader(header, file, problems)) return {};
  if (header.cells.front() != first) {
    problems.add(file, lineKey(header.number),
                 "the first column must be '" + first + "', not '" + header.cells.front() + "'");
    return {};
  }
  return readRows(lines, file, header.cells, problems);
}

}  // namespace rail
