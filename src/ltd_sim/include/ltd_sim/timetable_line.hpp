#pragma once

#include <cstddef>
#include <vector>

#include "ltd_sim/train_ability.hpp"
#include "rail_core/track.hpp"

namespace ltd {

/// The line as a driver knows it who looks ahead: what he may run at every place, and how long a stretch takes.
/// Constant. Places are those of the leading locomotive's CoG.
///
/// The line is cut into cells of 10 m (chosen: short against braking distances, long enough that planning is cheap). A
/// cell's limit is the lowest under the train from its head to its tail while the locomotive is anywhere in the cell,
/// so a limit holds until the tail has left it and is kept up to 10 m longer than it need be. Grade and curvature of a
/// cell are means over the train's length.
class TimetableLine {
 public:
  TimetableLine() = default;
  /// @param deceleration_mps2  a of the braking curves, at most
  /// @param margin_mps  so much below the limits
  TimetableLine(const rail::Track& track, const TrainAbility& ability, double deceleration_mps2, double margin_mps);

  /// Highest speed at s from which all lower limits ahead are reached by a_s:                                (V4)
  ///   v_p(s)^2 = min(v_lim(s)^2, v_p(s + d)^2 + 2 a_s d)
  ///   a_s = min(a, 0.85 (F_full(v)/m + loss(s)), sqrt(2 rho (v - v_lim ahead))),   rho = release F_full/m
  double permittedSpeed(double s_m) const;

  /// a_s of the curve to a stop: the smallest on the way to it from the line's largest speed [m/s2].
  double decelerationTo(double stop_m) const;

  /// Deceleration by grade and curves with the leading locomotive at s, mean over the train.
  double loss(double s_m) const { return cells_[cellAt(s_m)].loss_mps2; }
  /// Deceleration by the air brake in full service.
  double fullService(double v_mps) const { return between(full_mps2_, v_mps); }

  /// Time from `from_m` at v to `to_m` with full traction up to the cruising speed or what is permitted.       (V6)
  ///   v_i+1^2 = min(v_i^2 + 2 (F_t(v_i) - F_R(v_i) - F_G)/m d, v_c^2, v_p^2),   t = sum of 2 d/(v_i + v_i+1)
  /// @param stop_mps2  the train stops at `to_m` by this, and the braking curve to it holds as well; 0: it does not
  double runningTime(double from_m, double v_mps, double to_m, double stop_mps2, double cruise_mps) const;

  double smallestSpeed() const { return smallest_speed_mps_; }  ///< lowest limit, margin taken off
  double largestSpeed() const { return largest_speed_mps_; }

 private:
  struct Cell {
    double limit_mps;          ///< margin taken off
    double permitted_mps;      ///< at the cell's start
    double loss_mps2;          ///< deceleration by grade and curves
    double deceleration_mps2;  ///< of the braking curve through it; 0: none
  };
  void buildLimits(const rail::Track& track, const TrainAbility& ability, double margin_mps);
  void buildLosses(const rail::Track& track, const TrainAbility& ability);
  void buildForces(const TrainAbility& ability);
  void buildCurves();
  std::size_t cellAt(double s_m) const;
  double deceleration(std::size_t cell, double v_mps) const;
  double between(const std::vector<double>& table, double v_mps) const;

  double start_m_ = 0.0;
  double deceleration_mps2_ = 0.0;
  double release_per_s_ = 0.0;  ///< of the air brake
  double smallest_speed_mps_ = 0.0, largest_speed_mps_ = 0.0;
  std::vector<Cell> cells_;
  std::vector<double> pull_mps2_;  ///< acceleration by full traction against resistance, every kTableStep_mps
  std::vector<double> full_mps2_;  ///< deceleration by the air brake in full service, likewise
};

}  // namespace ltd
