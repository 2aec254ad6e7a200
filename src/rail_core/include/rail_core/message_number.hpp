#pragma once

#include <string>

namespace rail {

// Numbers as messages show them, whatever the locale and never as a negative zero. What a user has typed is shown as he
// typed it, results in files have all digits: neither goes through here.

/// Which neighbour a number is rounded to. A limit is rounded to the side on which the shown number keeps the rule.
enum class Rounding { kNearest, kDown, kUp };

/// Four significant digits, and all of those before the point: 0.003154, 12.34, 4440724; zeros at the end are left out.
/// With an exponent from 1e9 on and below 1e-4.
std::string messageNumber(double x, Rounding rounding = Rounding::kNearest);

/// Up to 15 digits, for a number that the reader is to type as it stands: a value that must be met, or a divisor.
std::string exactNumber(double x);

/// A place or length in km, to a tenth of a metre: 3.4585.
std::string messageKilometres(double s_m, Rounding rounding = Rounding::kNearest);

/// Always with so many decimals, for lines that follow one another: "-0.0004" is "0.000" with three.
std::string fixedNumber(double x, int decimals);

}  // namespace rail
