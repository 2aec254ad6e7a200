#include "decimated_series.hpp"

#include <cmath>

namespace viz {

DecimatedSeries::Bucket DecimatedSeries::merge(const Bucket& earlier, const Bucket& later) {
  Bucket merged = earlier;
  if (later.low.y < merged.low.y) {
    merged.low = later.low;
    merged.low_at = later.low_at;
  }
  if (later.high.y > merged.high.y) {
    merged.high = later.high;
    merged.high_at = later.high_at;
  }
  return merged;
}

void DecimatedSeries::halve() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < buckets_.size(); i += 2) {
    buckets_[kept++] = i + 1 < buckets_.size() ? merge(buckets_[i], buckets_[i + 1]) : buckets_[i];
  }
  buckets_.resize(kept);
  stride_ *= 2;
}

void DecimatedSeries::add(Point sample) {
  if (!std::isfinite(sample.x) || !std::isfinite(sample.y)) return;
  const Bucket alone{sample, sample, samples_, samples_};
  if (samples_ % stride_ == 0 && buckets_.size() == most_buckets_) halve();
  // after halving an odd number of buckets the last one is still open
  if (samples_ / stride_ < buckets_.size()) {
    buckets_.back() = merge(buckets_.back(), alone);
  } else {
    buckets_.push_back(alone);
  }
  ++samples_;
  newest_ = sample;
}

void DecimatedSeries::clear() {
  buckets_.clear();
  stride_ = 1;
  samples_ = 0;
}

std::vector<Point> DecimatedSeries::points() const {
  std::vector<Point> points;
  points.reserve(2 * buckets_.size() + 1);
  std::size_t last = 0;
  for (const Bucket& b : buckets_) {
    const bool low_first = b.low_at <= b.high_at;
    points.push_back(low_first ? b.low : b.high);
    if (b.low_at != b.high_at) points.push_back(low_first ? b.high : b.low);
    last = low_first ? b.high_at : b.low_at;
  }
  if (samples_ > 0 && last + 1 < samples_) points.push_back(newest_);
  return points;
}

}  // namespace viz
