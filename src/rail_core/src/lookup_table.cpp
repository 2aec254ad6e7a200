#include "rail_core/lookup_table.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "rail_core/number_text.hpp"

namespace rail {
namespace {

/// Where x lies in a rising axis: between `low` and `low + 1`, at `fraction` of the way; beyond an end it is that end.
struct Position {
  std::size_t low, high;
  double fraction;
};

Position locate(const std::vector<double>& axis, double x) {
  const auto above = std::upper_bound(axis.begin(), axis.end(), x);
  if (above == axis.begin()) return {0, 0, 0.0};
  const auto low = static_cast<std::size_t>(above - axis.begin()) - 1;
  if (above == axis.end()) return {low, low, 0.0};
  return {low, low + 1, (x - axis[low]) / (axis[low + 1] - axis[low])};
}

double between(double a, double b, double fraction) { return a + (b - a) * fraction; }

bool allFinite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

void requireAxis(const std::vector<double>& axis, const char* table) {
  if (axis.empty()) throw std::invalid_argument(std::string(table) + ": empty");
  const std::string rule = risingRule(axis);
  if (!rule.empty()) throw std::invalid_argument(std::string(table) + ": " + rule);
  if (!allFinite(axis)) throw std::invalid_argument(std::string(table) + ": not finite");
}

}  // namespace

LookupTable::LookupTable(std::vector<double> x, std::vector<double> y) : x_(std::move(x)), y_(std::move(y)) {
  requireAxis(x_, "LookupTable");
  if (y_.size() != x_.size()) throw std::invalid_argument("LookupTable: x and y differ in size");
  if (!allFinite(y_)) throw std::invalid_argument("LookupTable: not finite");
}

double LookupTable::operator()(double x) const {
  if (std::isnan(x)) return x;  // an end value would hide it
  const Position at = locate(x_, x);
  return between(y_[at.low], y_[at.high], at.fraction);
}

std::string risingRule(const std::vector<double>& x) {
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (x[i] > x[i - 1]) continue;  // written so that NaN fails
    return "must rise: " + formatNumber(x[i]) + " after " + formatNumber(x[i - 1]) + ", entry " + std::to_string(i);
  }
  return "";
}

}  // namespace rail
