#include "plots/decimated_series.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace viz {
namespace {

TEST(DecimatedSeriesTest, LeavesOutWhatIsNoNumber) {
  DecimatedSeries series;
  series.add({1.0, std::nan("")});
  series.add({std::numeric_limits<double>::infinity(), 1.0});
  EXPECT_TRUE(series.empty());
  EXPECT_TRUE(series.points().empty());
}

TEST(DecimatedSeriesTest, KeepsEverySampleWhileThereIsRoom) {
  DecimatedSeries series(10);
  for (int i = 0; i < 10; ++i) series.add({double(i), double(i * i)});
  const auto points = series.points();
  ASSERT_EQ(points.size(), 10u);
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(points[std::size_t(i)].x, i);
    EXPECT_EQ(points[std::size_t(i)].y, i * i);
  }
  EXPECT_EQ(series.stride(), 1u);
}

/// A million samples in the memory of 2 * buckets + 1, for even and odd numbers of buckets.
TEST(DecimatedSeriesTest, IsBoundedAndLosesNoPeak) {
  for (const std::size_t buckets : {2u, 7u, 100u}) {
    DecimatedSeries series(buckets);
    for (int i = 0; i < 1000000; ++i) {
      const double y = i == 345678 ? 5.0 : i == 777777 ? -4.0 : std::sin(1e-3 * i);
      series.add({double(i), y});
      if (i % 9973 == 0) {
        ASSERT_LE(series.points().size(), 2 * buckets + 1);
      }
    }
    const auto points = series.points();
    EXPECT_LE(points.size(), 2 * buckets + 1);
    EXPECT_GE(points.size(), buckets / 2);
    const auto by_value = [](const Point& a, const Point& b) { return a.y < b.y; };
    EXPECT_EQ(std::min_element(points.begin(), points.end(), by_value)->x, 777777);
    EXPECT_EQ(std::max_element(points.begin(), points.end(), by_value)->x, 345678);
    EXPECT_TRUE(std::is_sorted(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.x < b.x; }));
    EXPECT_EQ(points.back().x, 999999);
  }
}

TEST(DecimatedSeriesTest, EveryBucketHasItsStride) {
  DecimatedSeries series(4);
  for (int i = 0; i < 16; ++i) series.add({double(i), double(i % 4)});
  EXPECT_EQ(series.stride(), 4u);
  const auto points = series.points();  // 0 and 3 of each four
  ASSERT_EQ(points.size(), 8u);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(points[i].y, i % 2 == 0 ? 0.0 : 3.0);
}

TEST(DecimatedSeriesTest, StartsAfreshWhenCleared) {
  DecimatedSeries series(4);
  for (int i = 0; i < 100; ++i) series.add({double(i), 1.0});
  series.clear();
  EXPECT_TRUE(series.empty());
  series.add({-1.0, 2.0});
  ASSERT_EQ(series.points().size(), 1u);
  EXPECT_EQ(series.stride(), 1u);
}

}  // namespace
}  // namespace viz
