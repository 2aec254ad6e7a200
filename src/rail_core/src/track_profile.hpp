#pragma once

#include <cstddef>
#include <vector>

#include "rail_core/yaml_reader.hpp"

namespace rail {

/// One quantity along the track: from s_m on it is value + slope (s - s_m), until the next segment.
struct Segment {
  double s_m;
  double value;
  double slope;
};

/// The track as its file describes it: each quantity with break points of its own, rising, the first at the track's
/// start, none beyond its end, the last of slope zero (its value holds beyond the end).
struct TrackProfile {
  double start_m = 0.0, end_m = 0.0;
  std::vector<Segment> grade;        ///< [-]
  std::vector<Segment> curvature;    ///< [1/m]
  std::vector<Segment> cant;         ///< [m]
  std::vector<Segment> speed_limit;  ///< [m/s], slopes are zero
};

/// Adds a segment behind the others. One of no length is replaced, and what only continues a constant is left out.
void appendSegment(std::vector<Segment>& segments, const Segment& next);

/// Chainage [m] of a decimal number of kilometres or of a sum of metres: rounding errors of the arithmetic are removed,
/// so that a curve's end and the next curve's start, computed in two ways, are the same number.
double cleanChainage(double s_m);

/// The profile from the lists grades, curves and speed_limits with start_km and end_km, or from a table. To be used
/// only if no problem was added and `reader` is present.
TrackProfile readTrackLists(YamlReader& reader);
TrackProfile readTrackTable(YamlReader& reader);

}  // namespace rail
