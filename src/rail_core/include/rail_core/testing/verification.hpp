#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace rail {

/// A figure that must come out, as docs/validation.md shows it.
struct Verification {
  std::string number;  ///< of the case, 1 to 13
  std::string what;
  std::string source;  ///< of the expected figure
  std::string unit;
  double expected = 0.0;
  double computed = 0.0;
  double tolerance = 0.0;  ///< largest |computed - expected|
  std::string reason;      ///< of the tolerance
};

/// Fails the test if the figure is off, and notes it in the test's XML, from which scripts/validation.py makes
/// docs/validation.md. For tests only.
inline void verify(const Verification& v) {
  EXPECT_NEAR(v.computed, v.expected, v.tolerance) << "case " << v.number << ": " << v.what << " [" << v.unit << "]";
  static int count = 0;
  char numbers[128];
  std::snprintf(numbers, sizeof numbers, "%.17g|%.17g|%.17g", v.expected, v.computed, v.tolerance);
  ::testing::Test::RecordProperty(
      "verification_" + std::to_string(++count),
      v.number + "|" + v.what + "|" + v.source + "|" + v.unit + "|" + numbers + "|" + v.reason);
}

}  // namespace rail
