#include "rail_core/message_number.hpp"

#include <algorithm>
#include <cmath>
#include <ios>
#include <locale>
#include <sstream>

#include "rail_core/constants.hpp"
#include "rail_core/number_text.hpp"

namespace rail {
namespace {

constexpr int kDigits = 4;             // chosen: a person compares with fewer, and none of them is noise
constexpr double kExponentFrom = 1e9;  // chosen: longer rows of digits are not read but counted
constexpr double kExponentBelow = 1e-4;
constexpr int kKilometreDecimals = 4;  // chosen: nobody places a train to less than a tenth of a metre

/// "-0", "-0.00" and "-0e+00" without their sign.
std::string withoutNegativeZero(const std::string& text) {
  const bool zero = text.find_first_of("123456789in") == std::string::npos;  // inf and nan are no zeros
  return zero && text.front() == '-' ? text.substr(1) : text;
}

std::string written(double x, int decimals, bool exponent) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.precision(decimals);
  stream << (exponent ? std::scientific : std::fixed) << x;
  return stream.str();
}

/// Zeros at the end of the decimals left out, and the point if nothing is left behind it.
std::string trimmed(const std::string& text) {
  const std::size_t point = text.find('.');
  if (point == std::string::npos) return text;
  const std::size_t end = std::min(text.find('e'), text.size());
  std::size_t keep = text.find_last_not_of('0', end - 1) + 1;
  if (keep == point + 1) keep = point;
  return text.substr(0, keep) + text.substr(end);
}

/// x / unit as a whole number, rounded; what is off a whole number by rounding errors only is that number.
double wholeUnits(double x, double unit, Rounding rounding) {
  constexpr double kRoundingErrors = 1e-12;  // of what some operations leave; a shown digit is 1e-9 at least
  const double units = x / unit, nearest = std::round(units);
  if (rounding == Rounding::kNearest || std::abs(units - nearest) <= kRoundingErrors * std::abs(units)) return nearest;
  return rounding == Rounding::kDown ? std::floor(units) : std::ceil(units);
}

std::string rounded(double x, int decimals, Rounding rounding) {
  const double unit = std::pow(10.0, -decimals);
  return withoutNegativeZero(trimmed(written(wholeUnits(x, unit, rounding) * unit, decimals, false)));
}

}  // namespace

std::string messageNumber(double x, Rounding rounding) {
  if (!std::isfinite(x)) return std::isnan(x) ? "nan" : x > 0.0 ? "inf" : "-inf";
  const double size = std::abs(x);
  if (size == 0.0) return "0";
  const int magnitude = static_cast<int>(std::floor(std::log10(size)));
  if (size >= kExponentBelow && size < kExponentFrom) return rounded(x, std::max(kDigits - 1 - magnitude, 0), rounding);
  const double unit = std::pow(10.0, magnitude - kDigits + 1);
  return trimmed(written(wholeUnits(x, unit, rounding) * unit, kDigits - 1, true));
}

std::string exactNumber(double x) { return withoutNegativeZero(formatNumber(x)); }

std::string messageKilometres(double s_m, Rounding rounding) {
  return rounded(s_m / kMetresPerKilometre, kKilometreDecimals, rounding);
}

std::string fixedNumber(double x, int decimals) { return withoutNegativeZero(written(x, decimals, false)); }

}  // namespace rail
