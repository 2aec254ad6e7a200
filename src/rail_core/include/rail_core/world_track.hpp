#pragma once

#include <vector>

#include "rail_core/track.hpp"

namespace rail {

/// The track's frame T at one place, in the world frame W: origin at the track's start on the plane of the rail tops,
/// x along the track there, z up (REP-103).
struct TrackPose {
  double x_m = 0.0, y_m = 0.0, z_m = 0.0;
  double heading_rad = 0.0;  ///< about z, + to the left
  double pitch_rad = 0.0;    ///< about y: < 0 uphill
  double roll_rad = 0.0;     ///< about x, from cant: < 0 in a canted curve to the left
};

/// The line in space, for people to look at: nothing that is computed depends on it. Constant.
class WorldTrack {
 public:
  /// @param track  must outlive this
  explicit WorldTrack(const Track& track);

  /// Beyond the track's ends it goes on as it ends.
  TrackPose at(double s_m) const;

 private:
  struct Node {
    double x_m, y_m, heading_rad;
  };
  double nodeLocation(std::size_t i) const { return track_.start_m() + static_cast<double>(i) * kSpacing_m; }
  Node advance(const Node& from, double from_m, double length_m) const;

  static constexpr double kSpacing_m = 5.0;  // chosen: in a curve of 50 m places are right to 1e-6 m
  const Track& track_;
  std::vector<Node> nodes_;  ///< every kSpacing_m from the start
};

}  // namespace rail
