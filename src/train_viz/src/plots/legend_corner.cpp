#include "legend_corner.hpp"

#include <algorithm>
#include <array>

namespace viz {

namespace {

constexpr double kWidth = 0.4,
                 kHeight = 0.5;  // of the frame; chosen: a legend of four lines in a sheet of 480 x 240 pixels

struct Range {
  double low = 0.0, high = 0.0;
  void hold(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double shareOf(double value) const { return high > low ? (value - low) / (high - low) : 0.0; }
};

struct Frame {
  Range along, left, right;
};

Frame frameOf(const PlotData& plot) {
  Frame frame;
  bool first = true;
  for (const Curve& curve : plot.curves) {
    for (const Point& point : curve.points) {
      if (first) frame.along = {point.x, point.x};
      first = false;
      frame.along.hold(point.x);
      (curve.right_axis ? frame.right : frame.left).hold(point.y);
    }
  }
  return frame;
}

}  // namespace

LegendCorner emptiestCorner(const PlotData& plot) {
  const Frame frame = frameOf(plot);
  constexpr LegendCorner kCorners[] = {LegendCorner::kTopLeft, LegendCorner::kTopRight, LegendCorner::kBottomRight,
                                       LegendCorner::kBottomLeft};
  std::array<std::size_t, 4> hidden = {};
  for (const Curve& curve : plot.curves) {
    for (const Point& point : curve.points) {
      const double x = frame.along.shareOf(point.x);
      const double y = (curve.right_axis ? frame.right : frame.left).shareOf(point.y);
      if (std::min(x, 1.0 - x) > kWidth || std::min(y, 1.0 - y) > kHeight) continue;
      const bool right = x > 0.5, top = y > 0.5;
      ++hidden[top ? (right ? 1 : 0) : (right ? 2 : 3)];
    }
  }
  const auto own =
      static_cast<std::size_t>(std::find(std::begin(kCorners), std::end(kCorners), plot.legend) - kCorners);
  const auto least = static_cast<std::size_t>(std::min_element(hidden.begin(), hidden.end()) - hidden.begin());
  return hidden[own] == hidden[least] ? plot.legend : kCorners[least];
}

}  // namespace viz
