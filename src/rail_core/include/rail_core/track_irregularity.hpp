#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "rail_core/problems.hpp"

namespace rail {

/// Where one rail lies against its designed place, and how that changes along the track.
struct RailOffset {
  double y_m = 0.0;      ///< + to the left
  double z_m = 0.0;      ///< + up
  double y_slope = 0.0;  ///< d(y)/ds
  double z_slope = 0.0;  ///< d(z)/ds
};
struct RailOffsets {
  RailOffset left, right;
};

/// What a track recording car finds: deviations of the rails from the designed line. Constant.                 (T11)
///   y = lateral +- gauge widening / 2,   z = vertical +- cross level / 2      (upper sign: left rail)
/// The quantities are EN 13848-1's alignment and longitudinal level, here of the track's centre line, cross level and
/// gauge; between the rows each is a cubic spline, with slope 0 at both ends, so that slope and curvature have no step.
/// Before the first row and behind the last one the rails lie as designed.
///
/// CSV with the columns chainage_km, lateral_mm (+ left), vertical_mm (+ up), cross_level_mm (left rail over the
/// right), gauge_widening_mm (+ wider). Refused: chainage that does not rise, rows closer than 0.1 m or more than 5 m
/// apart or beyond the track, a first or last row that is not 0, values out of range, a quantity that changes by more
/// than 10 mm a metre, or whose slope does so by more than that from one pair of rows to the next. Not modelled: rails
/// that turn about their length with the cross level, wavelengths below the distance of the rows.
class TrackIrregularity {
 public:
  /// Rails as designed everywhere.
  TrackIrregularity() = default;
  /// Reads the table and reports everything wrong in it; empty if a problem was added.
  static TrackIrregularity read(const std::string& text, const std::string& file, double start_m, double end_m,
                                Problems& problems);

  bool empty() const { return knots_.empty(); }
  /// Whether s lies between the first and the last row.
  bool covers(double s_m) const { return !knots_.empty() && s_m > knots_.front().s_m && s_m < knots_.back().s_m; }
  /// The rails at s [m], by binary search. Does not allocate.
  RailOffsets at(double s_m) const;

 private:
  static constexpr std::size_t kQuantities = 4;  ///< lateral, vertical, cross level, gauge widening
  struct Knot {
    double s_m;
    double value_m[kQuantities];
    double bend_1pm[kQuantities];  ///< second derivative
  };
  void bendSplines();
  std::vector<Knot> knots_;
};

}  // namespace rail
