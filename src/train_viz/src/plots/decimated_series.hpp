#pragma once

#include <cstddef>
#include <vector>

namespace viz {

struct Point {
  double x = 0.0;
  double y = 0.0;
};

/// A curve of any length in bounded memory. Every bucket of `stride` samples keeps its lowest and its highest one, so
/// no peak is lost; when all buckets are used, neighbours are merged and the stride doubles.
class DecimatedSeries {
 public:
  /// @param buckets  at most this many, >= 2; chosen: more than a screen has columns
  explicit DecimatedSeries(std::size_t buckets = 2000) : most_buckets_(buckets) {}

  /// A sample that is no finite number is left out.
  void add(Point sample);
  void clear();

  /// What is kept, in the order of arrival, with the newest sample at the end; at most 2 buckets + 1.
  std::vector<Point> points() const;
  bool empty() const { return samples_ == 0; }
  Point newest() const { return newest_; }
  std::size_t stride() const { return stride_; }

 private:
  struct Bucket {
    Point low, high;
    std::size_t low_at = 0, high_at = 0;  ///< number of the sample
  };
  static Bucket merge(const Bucket& earlier, const Bucket& later);
  void halve();

  std::size_t most_buckets_;
  std::size_t stride_ = 1;   ///< samples a bucket
  std::size_t samples_ = 0;  ///< seen so far
  Point newest_;
  std::vector<Bucket> buckets_;
};

}  // namespace viz
