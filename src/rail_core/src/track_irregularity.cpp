#include "rail_core/track_irregularity.hpp"

#include <algorithm>
#include <cmath>

#include "rail_core/constants.hpp"
#include "rail_core/csv_table.hpp"
#include "rail_core/message_number.hpp"
#include "rail_core/number_text.hpp"
#include "track_profile.hpp"
#include "track_rules.hpp"

namespace rail {
namespace {

enum Column : std::size_t { kChainage, kLateral, kVertical, kCrossLevel, kGauge };
const std::vector<std::string> kColumns = {"chainage_km", "lateral_mm", "vertical_mm", "cross_level_mm",
                                           "gauge_widening_mm"};

// Chosen: beyond these no train may run at all, so units or columns are mixed up.
constexpr double kLowest_mm[] = {-30.0, -30.0, -30.0, -15.0};
constexpr double kHighest_mm[] = {30.0, 30.0, 30.0, 40.0};
constexpr double kLeastSpacing_m = 0.1;      // chosen: some lengths of a contact, which does not see less
constexpr double kLargestSpacing_m = 5.0;    // chosen: below it lies what a wheelset and a bogie can follow
constexpr double kSteepest_mm_per_m = 10.0;  // chosen: a dipped joint; more between two rows is a step

/// Adds the problems of a table that could be read as numbers.
class IrregularityCheck {
 public:
  IrregularityCheck(const CsvTable& table, const std::string& file, double start_m, double end_m, Problems& problems)
      : table_(table), file_(file), start_m_(start_m), end_m_(end_m), problems_(problems) {}

  void check() {
    constexpr std::size_t kFewest = 3;  // the first and the last are 0
    if (table_.rows.size() < kFewest) problems_.add(file_, "chainage_km", "must have three rows at least");
    for (std::size_t i = 0; i < table_.rows.size(); ++i) {
      checkPlace(i);
      for (std::size_t column = kLateral; column <= kGauge; ++column) checkValue(i, column);
    }
  }

 private:
  double place_m(std::size_t i) const { return cleanChainage(table_.rows[i][kChainage] * kMetresPerKilometre); }

  void checkPlace(std::size_t i) {
    const double s_m = place_m(i);
    if (s_m < start_m_ || s_m > end_m_) {
      refuse(i, kChainage,
             "must be on the track, " + messageKilometres(start_m_) + " to " + messageKilometres(end_m_) + " km");
    }
    if (i == 0) return;
    const double step_m = s_m - place_m(i - 1);
    const std::string before = formatNumber(table_.rows[i - 1][kChainage]);
    constexpr double kRounding_m = 1e-6;  // as cleanChainage
    if (step_m <= 0.0) {
      refuse(i, kChainage, "must be > that of the row before, " + before);
    } else if (step_m < kLeastSpacing_m - kRounding_m || step_m > kLargestSpacing_m + kRounding_m) {
      refuse(i, kChainage, "must be 0.1 m to 5 m behind the row before, " + before);
    }
  }

  void checkValue(std::size_t i, std::size_t column) {
    const double value = table_.rows[i][column];
    const double low = kLowest_mm[column - kLateral], high = kHighest_mm[column - kLateral];
    if (value < low || value > high) {
      refuse(i, column, "must be a number >= " + formatNumber(low) + " and <= " + formatNumber(high));
    } else if ((i == 0 || i + 1 == table_.rows.size()) && value != 0.0) {
      refuse(i, column, "must be 0 in the first and in the last row, where the rails lie as designed");
    } else if (i > 0 && std::abs(slope(i, column)) > kSteepest_mm_per_m) {
      refuse(i, column, "a step: it changes by " + messageNumber(slope(i, column)) + " mm a metre, must be 10 at most");
    } else if (i > 1 && std::abs(slope(i, column) - slope(i - 1, column)) > kSteepest_mm_per_m) {
      refuse(i - 1, column,
             "a kink: its slope changes by " + messageNumber(slope(i, column) - slope(i - 1, column)) +
                 " mm a metre here, must be 10 at most");
    }
  }

  /// From the row before, 0 where the places are at fault.
  double slope(std::size_t i, std::size_t column) const {
    const double step_m = place_m(i) - place_m(i - 1);
    return step_m > 0.0 ? (table_.rows[i][column] - table_.rows[i - 1][column]) / step_m : 0.0;
  }

  void refuse(std::size_t i, std::size_t column, const std::string& rule) {
    problems_.add(file_, "line " + std::to_string(table_.line_of_row[i]) + ": " + kColumns[column],
                  formatNumber(table_.rows[i][column]), rule);
  }

  const CsvTable& table_;
  const std::string& file_;
  const double start_m_, end_m_;
  Problems& problems_;
};

}  // namespace

TrackIrregularity TrackIrregularity::read(const std::string& text, const std::string& file, double start_m,
                                          double end_m, Problems& problems) {
  const std::size_t before = problems.count();
  const CsvTable table = readCsv(text, file, kColumns, problems);
  if (problems.count() == before) IrregularityCheck(table, file, start_m, end_m, problems).check();
  TrackIrregularity irregularity;
  if (problems.count() != before) return irregularity;
  for (const std::vector<double>& row : table.rows) {
    Knot knot{cleanChainage(row[kChainage] * kMetresPerKilometre), {}, {}};
    for (std::size_t k = 0; k < kQuantities; ++k) knot.value_m[k] = row[kLateral + k] / kMillimetresPerMetre;
    irregularity.knots_.push_back(knot);
  }
  irregularity.bendSplines();
  return irregularity;
}

/// Second derivatives of the cubic splines with slope 0 at both ends, by Thomas's algorithm:
///   a M_i-1 + 2 (a + b) M_i + b M_i+1 = 6 (slope behind i - slope before it), a and b the distances before and behind
void TrackIrregularity::bendSplines() {
  const std::size_t n = knots_.size();
  const auto length = [this](std::size_t i) { return knots_[i + 1].s_m - knots_[i].s_m; };
  for (std::size_t k = 0; k < kQuantities; ++k) {
    const auto slope = [&](std::size_t i) { return (knots_[i + 1].value_m[k] - knots_[i].value_m[k]) / length(i); };
    std::vector<double> upper(n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
      const double a = i > 0 ? length(i - 1) : 0.0, b = i + 1 < n ? length(i) : 0.0;
      const double right = 6.0 * ((i + 1 < n ? slope(i) : 0.0) - (i > 0 ? slope(i - 1) : 0.0));
      const double pivot = 2.0 * (a + b) - (i > 0 ? a * upper[i - 1] : 0.0);
      upper[i] = b / pivot;
      knots_[i].bend_1pm[k] = (right - (i > 0 ? a * knots_[i - 1].bend_1pm[k] : 0.0)) / pivot;
    }
    for (std::size_t i = n - 1; i-- > 0;) knots_[i].bend_1pm[k] -= upper[i] * knots_[i + 1].bend_1pm[k];
  }
}

RailOffsets TrackIrregularity::at(double s_m) const {
  if (!covers(s_m)) return {};
  const auto after =
      std::upper_bound(knots_.begin(), knots_.end(), s_m, [](double s, const Knot& knot) { return s < knot.s_m; });
  const Knot &from = *(after - 1), &to = *after;
  const double h = to.s_m - from.s_m, u = (s_m - from.s_m) / h, w = 1.0 - u;
  double value[kQuantities], slope[kQuantities];
  for (std::size_t k = 0; k < kQuantities; ++k) {
    const double dd0 = from.bend_1pm[k], dd1 = to.bend_1pm[k];
    value[k] = w * from.value_m[k] + u * to.value_m[k] + h * h / 6.0 * ((w * w * w - w) * dd0 + (u * u * u - u) * dd1);
    slope[k] =
        (to.value_m[k] - from.value_m[k]) / h + h / 6.0 * ((1.0 - 3.0 * w * w) * dd0 + (3.0 * u * u - 1.0) * dd1);
  }
  const auto rail = [&](double side) -> RailOffset {  // (T11)
    return {value[0] + 0.5 * side * value[3], value[1] + 0.5 * side * value[2], slope[0] + 0.5 * side * slope[3],
            slope[1] + 0.5 * side * slope[2]};
  };
  return {rail(1.0), rail(-1.0)};
}

}  // namespace rail
