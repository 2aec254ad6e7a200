#pragma once

#include <vector>

#include "train_viz/shapes.hpp"
#include "train_viz/train_outline.hpp"

namespace viz {

/// The train as it is drawn at one instant.
struct TrainShape {
  std::vector<Carrier> carriers{1};     ///< `train`, then those of the locomotives
  std::size_t chosen = 0;               ///< carrier of the chosen locomotive; 0 if the train has no such locomotive
  std::vector<Box> bodies;              ///< per vehicle
  std::vector<Triangles> roofs;         ///< of the bodies, per carrier
  std::vector<Box> bogies;              ///< two per vehicle, from the head; not of the chosen locomotive
  std::vector<Box> couplers;            ///< per coupler: from body to body, in the colour of its force
  std::vector<Box> chosen_bogies;       ///< of the chosen locomotive, to be looked through
  std::vector<Cylinder> chosen_wheels;  ///< likewise, and the axles between them
  Triangles force_diagram;              ///< coupler forces along the line: draft to its left, buff to its right
};

/// Puts every vehicle on the line: its bogies over their places, with the heading of the tangent there, and its body on
/// the chord from bogie to bogie. Bodies are true in length (over couplers less kBodyGap_m), width and height are
/// chosen. A locomotive's body and bogies are carried by its own frame, all else by `train`.
/// @param chosen             locomotive whose bogies are shown in detail, from 1
/// @param vehicle_location_m chainages of the CoGs, as many as the outline has vehicles
/// @param coupler_force_N    + draft, - buff; one less
TrainShape computeTrainShape(const TrainOutline& outline, const rail::WorldTrack& world, int chosen,
                             const std::vector<double>& vehicle_location_m, const std::vector<double>& coupler_force_N);

inline constexpr double kBodyGap_m = 1.0;            ///< chosen: between two bodies, the couplers' room
inline constexpr double kCouplerHeight_m = 0.885;    ///< that of the paper's locomotive
inline constexpr double kDiagram_m_per_N = 20.0e-6;  ///< chosen: 20 m beside the line for 1 MN

}  // namespace viz
