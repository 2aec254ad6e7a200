#include "rail_core/world_track.hpp"

#include <algorithm>
#include <cmath>

namespace rail {

WorldTrack::WorldTrack(const Track& track) : track_(track) {
  const auto count = static_cast<std::size_t>((track.end_m() - track.start_m()) / kSpacing_m) + 1;
  nodes_.push_back({0.0, 0.0, 0.0});
  while (nodes_.size() < count) nodes_.push_back(advance(nodes_.back(), nodeLocation(nodes_.size() - 1), kSpacing_m));
}

/// Gauss's rule with three points for the integrals of cos and sin of the heading.
WorldTrack::Node WorldTrack::advance(const Node& from, double from_m, double length_m) const {
  static const double offset = std::sqrt(0.15);
  const double points[] = {0.5 - offset, 0.5, 0.5 + offset};
  const double weights[] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
  Node to = from;
  std::size_t hint = 0;
  for (int i = 0; i < 3; ++i) {
    const double heading = from.heading_rad + track_.stretch(from_m, from_m + points[i] * length_m, hint).heading_rad;
    to.x_m += weights[i] * length_m * std::cos(heading);
    to.y_m += weights[i] * length_m * std::sin(heading);
  }
  to.heading_rad += track_.stretch(from_m, from_m + length_m, hint).heading_rad;
  return to;
}

TrackPose WorldTrack::at(double s_m) const {
  const double position = std::floor((s_m - track_.start_m()) / kSpacing_m);
  const auto i = static_cast<std::size_t>(std::clamp(position, 0.0, static_cast<double>(nodes_.size() - 1)));
  const Node node = advance(nodes_[i], nodeLocation(i), s_m - nodeLocation(i));
  const TrackPoint point = track_.at(s_m);
  std::size_t hint = 0;
  TrackPose pose;
  pose.x_m = node.x_m;
  pose.y_m = node.y_m;
  pose.z_m = point.height_m;
  pose.heading_rad = node.heading_rad;
  pose.pitch_rad = -std::atan(point.grade);
  pose.roll_rad = track_.cant(s_m, kCantWindow_m, hint).computeRoll_rad();
  return pose;
}

}  // namespace rail
