#include "creep_force_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <istream>
#include <iterator>
#include <ostream>

#include "loco_dynamics/contact/contact_signs.hpp"
#include "loco_dynamics/contact/hertz.hpp"
#include "rail_core/csv_table.hpp"
#include "rail_core/message_number.hpp"
#include "rail_core/number_text.hpp"
#include "rail_core/problems.hpp"
#include "rail_core/yaml_reader.hpp"

namespace loco {

namespace {

constexpr char kInput[] = "standard input";
constexpr double kPascalsPerGigapascal = 1e9;
constexpr double kMetresPerMillimetre = 1e-3;
constexpr char kAlong[] = "curvature_along_1pm";

/// A column, what it must keep, and its value where the file has no such column.
struct Column {
  std::string name;
  rail::Range range;
  std::optional<double> fallback;  ///< nothing: the column must be there
};

/// @param curved  the ellipse comes from curvatures and the load
std::vector<Column> columnsFor(const CreepForceArguments& arguments, bool curved) {
  const bool reduced = arguments.method == CreepMethod::kModfastsim || arguments.method == CreepMethod::kClosed;
  const auto unless = [](bool needed, double value) { return needed ? std::nullopt : std::optional<double>(value); };
  // chosen: a wheel that races at 50 m/s has it over the models' creepage floor of 0.5 m/s; a flange's spin is 2 rad/m
  const rail::Range creepage = rail::between(-100.0, 100.0);
  std::vector<Column> columns = {{curved ? kAlong : "a_mm", rail::aboveUpTo(0.0, 1e3), {}},
                                 {curved ? "curvature_across_1pm" : "b_mm", rail::aboveUpTo(0.0, 1e3), {}},
                                 {"N_N", rail::between(0.0, 1e9), {}},
                                 {"V_mps", rail::between(0.0, 1e3), {}},
                                 {"mu0", rail::aboveUpTo(0.0, 1.0), {}},
                                 {"A", rail::aboveUpTo(0.0, 1.0), {}},
                                 {"B_s_per_m", rail::notNegative(), {}},
                                 {"creep_x", creepage, {}},
                                 {"creep_y", creepage, {}},
                                 {"spin_rad_per_m", creepage, {}},
                                 {"k0", rail::aboveUpTo(0.0, 1.0), unless(reduced, 1.0)},
                                 {"alpha_inf", rail::between(0.0, 1.0), unless(reduced, 1.0)},
                                 {"beta", rail::notNegative(), unless(reduced, 0.0)},
                                 {"G_GPa", rail::aboveUpTo(0.0, 1e4), 82.0},
                                 {"nu", rail::between(0.0, 0.5), 0.28},
                                 {"kA", rail::aboveUpTo(0.0, 1.0), arguments.k_A.value_or(1.0)},
                                 {"kS", rail::aboveUpTo(0.0, 1.0), arguments.k_S.value_or(1.0)}};
  if (curved) columns.push_back({"E_GPa", rail::aboveUpTo(0.0, 1e4), 210.0});
  return columns;
}

std::vector<std::string> splitLines(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    if (!lines.back().empty() && lines.back().back() == '\r') lines.back().pop_back();
    begin = end + 1;
  }
  return lines;
}

/// Index of the line that names the columns; -1 if there is none.
int findHeader(const std::vector<std::string>& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::size_t first = lines[i].find_first_not_of(" \t");
    if (first != std::string::npos && lines[i][first] != '#') return static_cast<int>(i);
  }
  return -1;
}

/// Whether a header names a column.
bool names(const std::string& header, const std::string& name) {
  for (std::size_t at = header.find(name); at != std::string::npos; at = header.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    const auto parts = [&header](std::size_t i) { return header[i] == ',' || header[i] == ' ' || header[i] == '"'; };
    if ((at == 0 || parts(at - 1)) && (end == header.size() || parts(end))) return true;
  }
  return false;
}

/// Columns to ask for: those that must be there, and those that may and are.
std::vector<std::string> columnsToRead(const std::vector<Column>& columns, const std::string& header) {
  std::vector<std::string> asked;
  for (const Column& column : columns) {
    if (!column.fallback || names(header, column.name)) asked.push_back(column.name);
  }
  return asked;
}

bool keeps(double value, const rail::Range& range) {
  return (range.low_included ? value >= range.low : value > range.low) &&
         (range.high_included ? value <= range.high : value < range.high);
}

std::string shown(double value) { return rail::formatNumber(value, 10); }

std::string ruleOf(const rail::Range& range) {
  const std::string low = (range.low_included ? ">= " : "> ") + rail::messageNumber(range.low);
  return "must be " + low + (range.high < 1e300 ? " and <= " + rail::messageNumber(range.high) : "");
}

/// One case: the values of all columns, in their order.
struct Case {
  double a_mm, b_mm;  // or the curvatures
  double N_N, V_mps, mu0, A, B, creep_x, creep_y, spin, k0, alpha_inf, beta, G_GPa, nu, k_A, k_S;
  std::optional<double> E_GPa;  // with curvatures
};

Case caseOf(const std::vector<double>& v) {
  return {v[0],  v[1],  v[2],  v[3],  v[4],  v[5],
          v[6],  v[7],  v[8],  v[9],  v[10], v[11],
          v[12], v[13], v[14], v[15], v[16], v.size() > 17 ? std::optional<double>(v[17]) : std::nullopt};
}

HertzContact::Ellipse ellipseOf(const Case& c) {
  if (c.E_GPa) return HertzContact({c.a_mm, c.b_mm}, {*c.E_GPa * kPascalsPerGigapascal, c.nu}).computeEllipse(c.N_N);
  return {c.a_mm * kMetresPerMillimetre, c.b_mm * kMetresPerMillimetre};
}

ContactForce computeCase(const CreepForceArguments& arguments, const Case& c) {
  CreepLawParameters parameters;
  parameters.method = arguments.method;
  parameters.flexibility = arguments.flexibility;
  parameters.cells = arguments.cells;
  parameters.strips = arguments.strips;
  parameters.friction = {c.mu0, c.A, c.B};
  parameters.reduction = {c.k0, c.alpha_inf, c.beta};
  parameters.polach = {c.k_A, c.k_S};
  const HertzContact::Ellipse ellipse = ellipseOf(c);
  const ContactPatch patch = makeContactPatch(ellipse.a_m, ellipse.b_m, c.N_N, c.G_GPa * kPascalsPerGigapascal, c.nu);
  const Creepage creepage = fromContactSigns({c.creep_x, c.creep_y, c.spin}, c.V_mps);
  return toContactSigns(CreepLaw(parameters).computeForce(patch, creepage));
}

/// A creepage that would be possible on its own may not be so at its speed: then it was meant in percent.
void checkSlip(const std::string& line, const std::string& column, double creepage, double V_mps,
               rail::Problems& problems) {
  constexpr double kLargestSlip_mps = 60.0;  // chosen: no wheel's rim is 216 km/h faster than its train
  const double slip_mps = std::abs(creepage) * V_mps;
  if (slip_mps > kLargestSlip_mps) {
    problems.add(
        kInput, line + ": " + column, shown(creepage),
        "a ratio, 0.07 for 7 %: over V_mps it is a slip of " + rail::messageNumber(slip_mps) + " m/s, must be <= 60");
  }
}

/// Number of the line that a problem names, 0 if it names none.
int lineOf(const std::string& problem) {
  const std::string start = std::string(kInput) + ": line ";
  int number = 0;
  if (problem.compare(0, start.size(), start) == 0)
    std::from_chars(problem.data() + start.size(), problem.data() + problem.size(), number);
  return number;
}

/// Values of one row in the order of `columns`; problems of ranges and relations are added.
std::vector<double> checkedValues(const CreepForceArguments& arguments, const std::vector<Column>& columns,
                                  const rail::CsvTable& table, std::size_t row, rail::Problems& problems) {
  const std::string line = "line " + std::to_string(table.line_of_row[row]);
  std::vector<double> values;
  for (const Column& column : columns) {
    const int index = table.column(column.name);
    values.push_back(index < 0 ? *column.fallback : table.rows[row][static_cast<std::size_t>(index)]);
    if (!keeps(values.back(), column.range)) {
      problems.add(kInput, line + ": " + column.name, shown(values.back()), ruleOf(column.range));
    }
  }
  const Case c = caseOf(values);
  if (arguments.method == CreepMethod::kClosed && c.spin != 0.0) {
    problems.add(kInput, line + ": spin_rad_per_m", shown(c.spin), "must be 0 for --method closed");
  }
  checkSlip(line, "creep_x", c.creep_x, c.V_mps, problems);
  checkSlip(line, "creep_y", c.creep_y, c.V_mps, problems);
  if (c.k_S > c.k_A) problems.add(kInput, line + ": kS", shown(c.k_S), "must not be larger than kA");
  return values;
}

}  // namespace

int runCreepForce(const CreepForceArguments& arguments, const std::string& text, std::ostream& output,
                  std::ostream& errors) {
  const std::vector<std::string> lines = splitLines(text);
  const int at = findHeader(lines);
  const std::string header = at < 0 ? "" : lines[static_cast<std::size_t>(at)];
  const std::vector<Column> columns = columnsFor(arguments, names(header, kAlong));
  rail::Problems problems;
  const rail::CsvTable table = rail::readCsv(text, kInput, columnsToRead(columns, header), problems);
  if (!table.rows.empty()) output << header << ",Fx_N,Fy_N\n";
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const std::size_t before = problems.lines().size();
    const std::vector<double> values = checkedValues(arguments, columns, table, row, problems);
    if (problems.lines().size() > before) continue;
    const ContactForce force = computeCase(arguments, caseOf(values));
    output << lines[static_cast<std::size_t>(table.line_of_row[row] - 1)] << ',' << shown(force.x_N + 0.0) << ','
           << shown(force.y_N + 0.0) << '\n';  // + 0.0: never -0
  }
  std::vector<std::string> told = problems.lines();
  std::stable_sort(told.begin(), told.end(),
                   [](const std::string& a, const std::string& b) { return lineOf(a) < lineOf(b); });
  for (const std::string& line : told) errors << line << '\n';
  return problems.empty() ? 0 : 2;
}

int creepForceProgram(const std::vector<std::string>& arguments, std::istream& input, std::ostream& output,
                      std::ostream& errors) {
  CreepForceArguments parsed;
  const std::string wrong = parsed.parse(arguments);
  if (!wrong.empty()) {
    errors << "creep_force: " << wrong << "\ncreep_force --help tells more\n";
    return 2;
  }
  if (parsed.help) {
    output << kCreepForceHelp;
    return 0;
  }
  const std::string text{std::istreambuf_iterator<char>(input), std::istreambuf_iterator<char>()};
  return runCreepForce(parsed, text, output, errors);
}

}  // namespace loco
