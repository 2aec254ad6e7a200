#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "rail_core/constants.hpp"
#include "rail_core/csv_table.hpp"
#include "rail_core/number_text.hpp"
#include "track_profile.hpp"
#include "track_rules.hpp"

namespace rail {
namespace {

enum Column : std::size_t { kChainage, kGrade, kRadius, kCant, kSpeedLimit };
const std::vector<std::string> kColumns = {"chainage_km", "grade_permille", "radius_m", "cant_mm", "speed_limit_kmph"};

/// Adds the problems of a table that could be read as numbers.
class TableCheck {
 public:
  TableCheck(const CsvTable& table, const std::string& file, Problems& problems)
      : table_(table), file_(file), problems_(problems) {}

  void check() {
    for (std::size_t i = 0; i < table_.rows.size(); ++i) {
      checkValues(i);
      if (i > 0) checkChainage(i);
    }
    const auto& rows = table_.rows;
    if (!rows.empty() && rows.front()[kChainage] == rows.back()[kChainage]) {
      problems_.add(file_, "chainage_km", "must have two different values at least");
    }
  }

 private:
  void checkValues(std::size_t i) {
    const std::vector<double>& row = table_.rows[i];
    if (std::abs(row[kGrade]) > kLargestGrade_permille) refuse(i, kGrade, "must be a number >= -100 and <= 100");
    if (row[kRadius] != 0.0 && std::abs(row[kRadius]) < kSmallestRadius_m) {
      refuse(i, kRadius, "must be 0 (straight), <= -50 (right) or >= 50 (left)");
    }
    if (row[kCant] < 0.0 || row[kCant] > kLargestCant_mm) refuse(i, kCant, "must be a number >= 0 and <= 300");
    if (row[kSpeedLimit] <= 0.0) refuse(i, kSpeedLimit, "must be a number > 0");
  }

  void checkChainage(std::size_t i) {
    const double here = table_.rows[i][kChainage], before = table_.rows[i - 1][kChainage];
    if (here < before) refuse(i, kChainage, "must not go back, the row before is at " + formatNumber(before));
    if (i > 1 && here == before && here == table_.rows[i - 2][kChainage]) {
      refuse(i, kChainage, "two rows make a jump, a third has no meaning");
    }
  }

  void refuse(std::size_t i, Column column, const std::string& rule) {
    problems_.add(file_, "line " + std::to_string(table_.line_of_row[i]) + ": " + kColumns[column],
                  formatNumber(table_.rows[i][column]), rule);
  }

  const CsvTable& table_;
  const std::string& file_;
  Problems& problems_;
};

/// Segments through (s, value) of all rows: joined, or each held until the next.
std::vector<Segment> joinRows(const std::vector<double>& s_m, const std::vector<double>& values, bool linear) {
  std::vector<Segment> segments;
  for (std::size_t i = 0; i + 1 < s_m.size(); ++i) {
    const double length_m = s_m[i + 1] - s_m[i];
    if (length_m <= 0.0) continue;  // the first row of a jump ends the segment before
    appendSegment(segments, {s_m[i], values[i], linear ? (values[i + 1] - values[i]) / length_m : 0.0});
  }
  appendSegment(segments, {s_m.back(), values.back(), 0.0});
  return segments;
}

double curvature(double radius_m) { return radius_m == 0.0 ? 0.0 : 1.0 / radius_m; }

TrackProfile profileOf(const CsvTable& table, bool linear_grade, bool linear_curvature) {
  std::vector<double> s_m, grade, curvature_1pm, cant_m, speed_limit_mps;
  for (const std::vector<double>& row : table.rows) {
    s_m.push_back(cleanChainage(row[kChainage] * kMetresPerKilometre));
    grade.push_back(row[kGrade] / kPermillePerOne);
    curvature_1pm.push_back(curvature(row[kRadius]));
    cant_m.push_back(row[kCant] / kMillimetresPerMetre);
    speed_limit_mps.push_back(row[kSpeedLimit] / kKmphPerMps);
  }
  TrackProfile profile;
  profile.start_m = s_m.front();
  profile.end_m = s_m.back();
  profile.grade = joinRows(s_m, grade, linear_grade);
  profile.curvature = joinRows(s_m, curvature_1pm, linear_curvature);
  profile.cant = joinRows(s_m, cant_m, linear_curvature);
  profile.speed_limit = joinRows(s_m, speed_limit_mps, false);
  return profile;
}

}  // namespace

TrackProfile readTrackTable(YamlReader& reader) {
  Problems& problems = reader.problems();
  const std::string text = reader.text("table");
  YamlReader between_rows = reader.map("between_rows");
  const std::vector<std::string> choices = {"constant", "linear"};
  const bool linear_grade = between_rows.choice("grade", choices) == "linear";
  const bool linear_curvature = between_rows.choice("curvature", choices) == "linear";
  between_rows.finish();
  if (text.empty()) return {};  // has been reported
  const std::size_t before = problems.count();
  const std::string file = reader.file("table");
  const CsvTable table = readCsv(text, file, kColumns, problems);
  TableCheck(table, file, problems).check();
  if (problems.count() != before) return {};
  return profileOf(table, linear_grade, linear_curvature);
}

}  // namespace rail
