#include "rail_core/number_text.hpp"

#include <charconv>
#include <cstddef>
#include <locale>
#include <sstream>
#include <system_error>

namespace rail {
namespace {

/// Index after the digits that start at `i`.
std::size_t skipDigits(const std::string& text, std::size_t i) {
  while (i < text.size() && text[i] >= '0' && text[i] <= '9') ++i;
  return i;
}

std::size_t skipSign(const std::string& text, std::size_t i) {
  return i < text.size() && (text[i] == '+' || text[i] == '-') ? i + 1 : i;
}

/// std::from_chars knows no plus sign.
const char* afterPlus(const std::string& text) { return text.data() + (text.front() == '+' ? 1 : 0); }

}  // namespace

bool isDecimal(const std::string& text) {
  const std::size_t first = skipSign(text, 0);
  std::size_t i = skipDigits(text, first);
  std::size_t digits = i - first;
  if (i < text.size() && text[i] == '.') {
    const std::size_t end = skipDigits(text, i + 1);
    digits += end - (i + 1);
    i = end;
  }
  if (digits == 0) return false;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    const std::size_t exponent = skipSign(text, i + 1);
    i = skipDigits(text, exponent);
    if (i == exponent) return false;
  }
  return i == text.size();
}

std::optional<double> parseNumber(const std::string& text) {
  if (!isDecimal(text)) return std::nullopt;
  double number = 0.0;
#if defined(__cpp_lib_to_chars) && __cpp_lib_to_chars >= 201611L
  const char* const end = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(afterPlus(text), end, number);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
#else  // GCC 9 of Ubuntu 20.04; a bare strtod would obey the locale that a Qt program sets
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  if (!(stream >> number) || stream.peek() != std::istringstream::traits_type::eof()) return std::nullopt;
#endif
  return number;
}

std::optional<std::int64_t> parseInteger(const std::string& text) {
  const std::size_t first = skipSign(text, 0);
  if (first == text.size() || skipDigits(text, first) != text.size()) return std::nullopt;
  std::int64_t number = 0;
  const char* const end = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(afterPlus(text), end, number);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return number;
}

std::string formatNumber(double number, int digits) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.precision(digits);
  stream << number;
  return stream.str();
}

}  // namespace rail
