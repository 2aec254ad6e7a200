#pragma once

#include <vector>

#include "rail_core/track.hpp"
#include "train_viz/shapes.hpp"

namespace viz {

/// The line as it is drawn once a run: in true plan and profile, with its curves, grades and cant.
struct TrackShape {
  std::vector<Eigen::Vector3d> left_rail, right_rail;  ///< tops of the rails, kCantBaseline_m apart
  std::vector<Eigen::Vector3d> centre;                 ///< on the bed, below the rail tops
  Triangles bed;                                       ///< ballast
  std::vector<Caption> posts;  ///< chainages right of the line: "3.4", and large "3 km" high above it
};

/// Chainages between which the line may be drawn straight: no place of it is further than `tolerance_m` off the chord.
std::vector<double> computeChords(const rail::Track& track, const rail::WorldTrack& world, double tolerance_m);

TrackShape computeTrackShape(const rail::Track& track, const rail::WorldTrack& world);

}  // namespace viz
