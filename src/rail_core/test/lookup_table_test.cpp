#include "rail_core/lookup_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace rail {
namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kInfinity = std::numeric_limits<double>::infinity();

TEST(LookupTableTest, ImpossibleTablesAreRefused) {
  EXPECT_THROW(LookupTable({}, {}), std::invalid_argument);
  EXPECT_THROW(LookupTable({0.0, 1.0}, {0.0}), std::invalid_argument);
  EXPECT_THROW(LookupTable({0.0, 0.0}, {0.0, 1.0}), std::invalid_argument);
  EXPECT_THROW(LookupTable({0.0, kNan}, {0.0, 1.0}), std::invalid_argument);
  EXPECT_THROW(LookupTable({0.0, kInfinity}, {0.0, 1.0}), std::invalid_argument);
  EXPECT_THROW(LookupTable({0.0, 1.0}, {0.0, kNan}), std::invalid_argument);
}

TEST(LookupTableTest, GivesTheEntriesExactlyAndIsLinearBetween) {
  const LookupTable table({0.1, 0.4, 2.0}, {7.3, -1.1, 5.0});
  EXPECT_EQ(table(0.1), 7.3);
  EXPECT_EQ(table(0.4), -1.1);
  EXPECT_EQ(table(2.0), 5.0);
  EXPECT_DOUBLE_EQ(table(0.8), -1.1 + 6.1 / 4.0);
}

TEST(LookupTableTest, IsConstantBeyondBothEnds) {
  const LookupTable table({1.0, 2.0}, {3.0, 4.0});
  EXPECT_EQ(table(-kInfinity), 3.0);
  EXPECT_EQ(table(0.999), 3.0);
  EXPECT_EQ(table(1e300), 4.0);
}

TEST(LookupTableTest, OneEntryIsAConstant) { EXPECT_EQ(LookupTable({5.0}, {2.0})(-3.0), 2.0); }

TEST(LookupTableTest, NanIsNotHiddenByAnEndValue) {
  EXPECT_TRUE(std::isnan(LookupTable({1.0, 2.0}, {3.0, 4.0})(kNan)));
}

TEST(RisingRuleTest, NamesTheFirstNumberThatDoesNotRise) {
  EXPECT_EQ(risingRule({1.0, 2.0, 3.5, 3.6, 3.2, 1.0}), "must rise: 3.2 after 3.6, entry 4");
  EXPECT_EQ(risingRule({1.0, 1.0}), "must rise: 1 after 1, entry 1");
  EXPECT_EQ(risingRule({1.0, kNan, 2.0}), "must rise: nan after 1, entry 1");
  EXPECT_EQ(risingRule({-1.0, 0.0, 1e-300}), "");
  EXPECT_EQ(risingRule({}), "");
}

}  // namespace
}  // namespace rail
