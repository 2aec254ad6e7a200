#include "loco_dynamics/contact/kalker.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "contact_fixtures.hpp"

namespace {

using loco::computeKalkerCoefficients;
using loco::KalkerCoefficients;

TEST(KalkerTest, AgreesWithEveryRowOfTheTable) {
  for (const auto& row : fixtures::readRows(std::string(TEST_DATA_DIR) + "/reference/kalker.csv")) {
    const double g = fixtures::numberAt(row, "g");
    const KalkerCoefficients c =
        computeKalkerCoefficients(row.at("ratio") == "a>b" ? 1.0 / g : g, fixtures::numberAt(row, "nu"));
    // 1/(1/g) may miss a row of the table by round-off
    EXPECT_NEAR(c.c11, fixtures::numberAt(row, "C11"), 1e-12 * c.c11);
    EXPECT_NEAR(c.c22, fixtures::numberAt(row, "C22"), 1e-12 * c.c22);
    EXPECT_NEAR(c.c23, fixtures::numberAt(row, "C23"), 1e-12 * c.c23);
  }
}

TEST(KalkerTest, PaperContactHasC11Of3Point915) {
  EXPECT_NEAR(computeKalkerCoefficients(6.612 / 9.525, 0.28).c11, 3.915, 0.0005);  // the last digit given
}

TEST(KalkerTest, IsContinuousWhereTheTableEndsAndAtTheCircle) {
  for (const double nu : {0.0, 0.28, 0.5}) {
    for (const double ratio : {0.1, 10.0, 1.0}) {
      const KalkerCoefficients below = computeKalkerCoefficients(ratio * (1.0 - 1e-9), nu);
      const KalkerCoefficients above = computeKalkerCoefficients(ratio * (1.0 + 1e-9), nu);
      EXPECT_NEAR(below.c11, above.c11, 1e-7 * above.c11);  // slopes are of the order of the values
      EXPECT_NEAR(below.c22, above.c22, 1e-7 * above.c22);
      EXPECT_NEAR(below.c23, above.c23, 1e-7 * above.c23);
    }
  }
}

TEST(KalkerTest, TendsToTheAsymptotesOfNarrowAndLongPatches) {
  const double pi = 3.14159265358979323846, nu = 0.28, g = 1e-4;
  const KalkerCoefficients narrow = computeKalkerCoefficients(g, nu);
  // 0.1 %: the table's part has shrunk with g/0.1
  EXPECT_NEAR(narrow.c11, pi * pi / (4.0 * (1.0 - nu)), 1e-3 * narrow.c11);
  EXPECT_NEAR(narrow.c22, pi * pi / 4.0, 1e-3 * narrow.c22);
  EXPECT_NEAR(narrow.c23, pi * std::sqrt(g) / (3.0 * (1.0 - nu)) * (1.0 + nu * (std::log(16.0 / g) - 5.0)),
              1e-3 * narrow.c23);
  const double L = std::log(16.0 / (g * g));
  const KalkerCoefficients wide = computeKalkerCoefficients(1.0 / g, nu);
  EXPECT_NEAR(wide.c11, 2.0 * pi / ((L - 2.0 * nu) * g) * (1.0 + (3.0 - std::log(4.0)) / (L - 2.0 * nu)),
              1e-3 * wide.c11);
  EXPECT_NEAR(wide.c23, 2.0 * pi / (3.0 * std::pow(g, 1.5)) / ((1.0 - nu) * L - 2.0 + 4.0 * nu), 1e-3 * wide.c23);
}

TEST(KalkerTest, InterpolatesLinearlyInGAndBy1OverCInNu) {
  const KalkerCoefficients c = computeKalkerCoefficients(0.65, 0.28);  // a < b, half-way between 0.6 and 0.7
  const double c0 = 0.5 * (2.98 + 3.09), c1 = 0.5 * (3.72 + 3.81), c2 = 0.5 * (4.91 + 4.97);
  const double x = 0.28;
  const double inverse = (x - 0.25) * (x - 0.5) / (0.25 * 0.5) / c0 + x * (x - 0.5) / (0.25 * -0.25) / c1 +
                         x * (x - 0.25) / (0.5 * 0.25) / c2;
  EXPECT_NEAR(c.c11, 1.0 / inverse, 1e-12);  // round-off
}

}  // namespace
