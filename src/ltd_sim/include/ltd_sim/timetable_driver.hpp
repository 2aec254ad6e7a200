#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ltd_sim/driver_command.hpp"
#include "ltd_sim/driver_controls.hpp"
#include "ltd_sim/timetable_line.hpp"
#include "ltd_sim/train_ability.hpp"
#include "rail_core/track.hpp"
#include "rail_core/yaml_reader.hpp"

namespace ltd {

/// A driver who keeps speed limits and a timetable, looking ahead. Constant. The laws are in docs/drivers.md.
///
/// YAML `driver` with kind: timetable:
///   points: [{location_km: 12, time_s: 900}, {location_km: 20, time_s: 1500, stop: true, dwell_s: 60}, ...]
///   service_deceleration_mps2: 0.2     # a of the braking curves
///   brake_release: direct              # or graduated
/// and, if the chosen values do not suit: release_above_kmph (25), limit_margin_kmph (2), late_tolerance_s (10),
/// planning_period_s (1), notch_hold_s (3), reaction_s (4).
class TimetableDriver {
 public:
  /// What he remembers. Copyable.
  struct State {
    bool started = false;
    rail::Nanoseconds next_control = 0;
    rail::Nanoseconds next_plan = 0;
    std::size_t point = 0;       ///< the next one
    bool planned = false;        ///< towards that point
    double cruise_mps = 0.0;     ///< (V6)
    double integral_mps2 = 0.0;  ///< of the PI controller
    bool waiting = false;        ///< at a stop
    bool leaving = false;        ///< held by the independent brake until the traction pulls
    rail::Nanoseconds departure = 0;
    rail::Nanoseconds tail_free = 0;  ///< by his reckoning all brakes are off from then on, once the pipe is charged
    DriverControls::State controls;
    std::vector<std::string> notes;  ///< late arrivals and the like, in order
  };

  /// Reads the map's keys; the caller finishes the reader.
  static TimetableDriver read(rail::YamlReader& reader, const rail::Track& track, const TrainAbility& ability);

  /// Decides when it is due, every 0.2 s; in between the command stays.
  void command(const DriverView& view, State& state, DriverCommand& lead) const;

  /// True until the train has come to the last point: if it stands, it is to move again.
  bool goesOn(const State& state) const { return state.point + (state.waiting ? 1 : 0) < points_.size(); }

 private:
  static constexpr double kStanding_mps = 0.05;  ///< slower is at a stand; chosen: nobody sees such a train move

  struct Point {
    double location_m = 0.0;
    std::optional<double> time_s;
    bool stop = false;
    std::optional<double> dwell_s;   ///< none: the train stays
    double deceleration_mps2 = 0.0;  ///< of the curve to a stop
    double holding_Pa = 0.0;         ///< reduction of the pipe with which the train stands there
  };
  /// What he keeps to while he looks ahead.
  struct Course {
    double locomotives_mps2 = 0.0;  ///< acceleration that they come to
    double ramp_s = 0.0;            ///< within that time
    double air_share = 0.0;         ///< of full service, asked for
    double air_delay_s = 0.0;       ///< before the shoes begin to follow
  };
  /// Where that brings him.
  struct Ahead {
    double s_m = 0.0, speed_mps = 0.0;
    double air_mps2 = 0.0;     ///< what the shoes do there
    double excess_mps = -1e9;  ///< over the speed for which he brakes, the largest from the time asked for on
  };
  static Point readPoint(rail::YamlReader reader);
  void readPoints(rail::YamlReader& reader, const rail::Track& track);
  void readHabits(rail::YamlReader& reader);
  void readLine(rail::YamlReader& reader, const rail::Track& track);
  void readStops(rail::YamlReader& reader, const rail::Track& track);

  void start(const DriverView& view, State& state) const;
  void passPoints(const DriverView& view, State& state) const;
  void leavePoint(const DriverView& view, State& state) const;
  void noteArrival(const Point& point, const DriverView& view, State& state) const;
  void plan(const DriverView& view, State& state) const;
  void drive(const DriverView& view, State& state, DriverCommand& lead) const;
  double wantedTraction(const DriverView& view, State& state, const DriverCommand& lead) const;
  void integrate(double error_mps, State& state, const DriverCommand& lead) const;
  void hold(const DriverView& view, State& state, DriverCommand& lead) const;
  double permittedSpeed(double s_m, const State& state) const;
  double slopeAt(double s_m, const State& state) const;

  // timetable_braking.cpp
  double brakeReference(double s_m, const State& state) const;
  double wantedBrake(const Ahead& ahead, const DriverView& view, const State& state) const;
  double dynamicBrake(double v_mps) const;
  double feltShare(const DriverView& view) const;
  double feltPull(const DriverView& view) const;
  Course presentCourse(const DriverView& view, const State& state, const DriverCommand& lead) const;
  Course fullDynamicBrake(const DriverView& view, Course course) const;
  Ahead lookAhead(const DriverView& view, const State& state, const Course& course, double horizon_s,
                  double from_s) const;
  DriverControls::Trim wantedDynamicBrake(const DriverView& view, const State& state, const DriverCommand& lead) const;
  void moveAir(const DriverView& view, State& state, const DriverCommand& lead) const;
  double moreAir(const DriverView& view, const State& state, const Course& course) const;
  double lessAir(const DriverView& view, const State& state, const Course& course) const;
  double leastAbove(double reduction_Pa) const;
  double easedReduction(const Ahead& then, const DriverView& view, const State& state) const;
  double directRelease(const Ahead& then, const DriverView& view, const State& state) const;
  void setReduction(double reduction_Pa, const DriverView& view, State& state) const;
  const Point* nextPoint(const State& state) const {
    return state.point < points_.size() ? &points_[state.point] : nullptr;
  }

  TrainAbility ability_;
  TimetableLine line_;
  DriverControls controls_;
  std::vector<Point> points_;
  bool graduated_release_ = false;
  double release_above_mps_ = 0.0;  ///< direct-release brakes stay on below, until the train stands
  double deceleration_mps2_ = 0.0;
  double margin_mps_ = 0.0;
  double late_tolerance_s_ = 0.0;
  double reaction_s_ = 0.0;
  rail::Nanoseconds planning_period_ = 0;
};

}  // namespace ltd
