#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace rail {

/// True for a plain decimal number: sign, digits, point, digits, exponent; no nan, inf, hexadecimal, blanks or units.
bool isDecimal(const std::string& text);

/// The nearest double, whatever the locale; nothing if `text` is not a plain decimal number or beyond a double's range.
std::optional<double> parseNumber(const std::string& text);

/// Nothing if `text` is more than sign and digits, or beyond 64 bits.
std::optional<std::int64_t> parseInteger(const std::string& text);

/// Up to so many digits, whatever the locale.
std::string formatNumber(double number, int digits = 15);

}  // namespace rail
