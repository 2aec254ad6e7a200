#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "rail_core/track_irregularity.hpp"
#include "rail_core/yaml_reader.hpp"

namespace rail {

struct TrackProfile;

/// What the track is at one place. Signs: grade > 0 uphill in running direction, curvature > 0 to the left, cant > 0
/// outer rail up (so it is never negative).
struct TrackPoint {
  double grade = 0.0;            ///< dz/ds [-], rise per distance along the track
  double curvature_1pm = 0.0;    ///< 1/R [1/m]
  double cant_m = 0.0;           ///< height of the outer rail over the inner [m]
  double speed_limit_mps = 0.0;  ///< [m/s]
  double height_m = 0.0;         ///< integral of the grade from the track's start [m]
};

/// The track at one place in the frame of another, in plan.                                              (T10)
///   heading = integral of kappa from `from` to `to`,   lateral = integral of the heading, for small headings
struct TrackStretch {
  double heading_rad = 0.0;  ///< of the tangent there against that here, + to the left
  double lateral_m = 0.0;    ///< of the centre line there from the tangent here, + to the left
};

inline constexpr double kCantBaseline_m = 1.5;  ///< between the rails' contacts, over which cant is measured (EN 13803)
inline constexpr double kCantWindow_m = 3.0;    ///< chosen: over a shorter one run-offs would be impulses

/// Cant with its run-offs rounded off.                                                                    (T10)
struct TrackCant {
  double left_m = 0.0;   ///< height of the left rail over the right: < 0 in a canted curve to the left
  double slope = 0.0;    ///< d(left_m)/ds [-]
  double outer_m = 0.0;  ///< height of the outer rail over the inner, >= 0; its own mean, so it bends gradually as well
  double outer_slope = 0.0;  ///< d(outer_m)/ds [-]; not |slope| where the outer rail changes sides within the window

  /// Angle of the line across the rail tops about x, + left rail up: its sine is left_m over the baseline.
  double computeRoll_rad() const;
  double computeRollSlope_1pm() const;  ///< d(roll)/ds
};

/// The line in plan and profile, by chainage s [m] in running direction. Constant after reading.
///
/// Between its break points grade, curvature and cant are linear in s (so a linear ramp of curvature is a clothoid),
/// the speed limit is constant; all may jump at a break point, the value at the point itself is that of the piece
/// ahead.
///
/// YAML, either as lists:
///   name: ..., start_km: 0, end_km: 10
///   grades: [{from_km: 0, grade_permille: 0}, ...]        # each holds until the next; the first from start_km
///   curves: [{start_km: 3.3, radius_m: 300, direction: left, transition_in_m: 50, circular_m: 200,
///             transition_out_m: 50, cant_mm: 0}]          # in order, not overlapping, inside the track
///   speed_limits: [{from_km: 0, limit_kmph: 80}, ...]
/// or as a table (`table_file: line.csv` with columns chainage_km, grade_permille, radius_m, cant_mm, speed_limit_kmph;
/// radius signed, left +, 0 = straight):
///   name: ..., table_file: line.csv
///   between_rows: {grade: constant|linear, curvature: constant|linear}   # cant goes with curvature
/// where `constant` holds a row's value until the next row and `linear` joins the rows; the speed limit always holds.
/// Both may have `irregularity_file: rails.csv`, see TrackIrregularity.
/// The track reaches from the first row to the last. Two rows at one chainage make a jump; a chainage that goes back is
/// refused. Also refused: |radius| < 50 m, |grade| > 100 permille, cant outside 0..300 mm, a limit <= 0, curves that
/// overlap or reach beyond the track.
class Track {
 public:
  /// Reads the map and reports everything wrong in it; the result may only be used if no problem was added.
  static Track read(YamlReader reader);

  /// The track at s [m]. `hint` is the caller's memory of the piece found last (start with 0; one per vehicle), which
  /// makes the search O(1) for a moving vehicle. Outside the track the end values hold, with height going on at the
  /// end's grade. Does not allocate.
  TrackPoint at(double s_m, std::size_t& hint) const;

  /// The same without a memory, by binary search: for plots and tests.
  TrackPoint at(double s_m) const;

  /// Where the track goes from one place to another, before or behind it: exact on every piece. `hint` as above, for
  /// the place `from_m`. Does not allocate.
  TrackStretch stretch(double from_m, double to_m, std::size_t& hint) const;

  /// Cant as the mean over a window about s: a linear ramp bends gradually over the window's length, and what runs over
  /// it feels no impulse. Which rail is the outer one says the curvature; a piece that is straight goes with the curve
  /// ahead, or behind if there is none ahead. `hint` as above.
  /// @param window_m  > 0
  TrackCant cant(double s_m, double window_m, std::size_t& hint) const;

  /// False if no place has cant.
  bool canted() const { return canted_; }

  /// How the rails deviate from all this; at() and the others do not know of it.
  const TrackIrregularity& irregularity() const { return irregularity_; }

  const std::string& name() const { return name_; }
  double start_m() const { return start_m_; }
  double end_m() const { return end_m_; }
  double largestGrade() const;
  double smallestGrade() const;
  double largestCurvature() const;  ///< magnitude of that of the tightest curve; 0 if all is straight

 private:
  /// From its s on, to that of the next piece. The last piece starts at the track's end and has no end.
  struct Piece {
    double s_m;
    double grade, grade_slope_1pm;
    double curvature_1pm, curvature_slope_1pm2;
    double cant_m, cant_slope;
    double speed_limit_mps;
    double height_m;
    double left_cant_m, left_cant_slope;  ///< height of the left rail over the right
    double left_cant_integral_m2;         ///< from the track's start
    double cant_integral_m2;              ///< likewise, of the outer rail over the inner
  };
  void buildCant();
  void build(const TrackProfile& profile);
  std::size_t findPiece(double s_m, std::size_t hint) const;
  std::pair<double, double> gradeExtremes() const;

  std::string name_;
  double start_m_ = 0.0, end_m_ = 0.0;
  std::vector<Piece> pieces_;
  bool canted_ = false;
  TrackIrregularity irregularity_;
};

}  // namespace rail
