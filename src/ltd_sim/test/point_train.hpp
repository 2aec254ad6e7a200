#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "driver_reading.hpp"
#include "rail_core/constants.hpp"

/// A train of one mass for the tests of drivers: 2800 t, three locomotives of the paper with a dynamic brake. Chosen
/// numbers of a usual size; every force follows its command late.
namespace drivers {

constexpr double kMass_kg = 2.8e6;
constexpr double kAhead_m = 11.0, kBehind_m = 360.0;

inline double tractionForce(double strength, int notch, double v) {
  const double share = notch / 8.0;
  return strength * std::min(share * 1.68e6, share * share * 12.3e6 / std::max(v, 0.1));
}
inline double dynamicForce(int notch, double v) {  // fades below 3 m/s
  return notch / 8.0 * std::min({0.6e6, 9.0e6 / std::max(v, 0.1), 0.2e6 * v});
}
inline double fullService(double) { return 0.6 * kMass_kg; }
inline double davis(double v) { return kMass_kg * (0.010 + 2.0e-4 * v + 3.0e-5 * v * v); }

inline ltd::TrainAbility ability(double traction_strength = 1.0) {
  ltd::TrainAbility ability;
  ability.mass_kg = kMass_kg;
  ability.weight_N = kMass_kg * rail::kGravity_mps2;
  ability.ahead_m = kAhead_m;
  ability.behind_m = kBehind_m;
  ability.notches = ability.brake_notches = 8;
  ability.traction_N = [=](int notch, double v) { return tractionForce(traction_strength, notch, v); };
  ability.dynamic_brake_N = dynamicForce;
  ability.full_service_N = fullService;
  ability.resistance_N = davis;
  ability.brake_response = {3.0, 0.2, 3.0, 0.2, 10.0, 15.0};  // of the 5 s in which the shoes follow below
  return ability;
}

/// What is seen of a run.
struct Seen {
  double largest_excess_mps = -1e9;  ///< over the lowest limit under the train
  int notch_changes = 0, brake_notch_changes = 0, air_changes = 0, reversals = 0;
  double smallest_pipe_Pa = 5.0e5;
  int largest_brake_notch = 0;
  double smallest_mps = 1e9, largest_mps = 0.0;
  std::map<int, double> time_at_km10;  ///< first time at a place in whole tenths of a kilometre
};

/// The train on its track with its driver, from `location_m` on.
class PointTrain {
 public:
  PointTrain(const ltd::Driver& driver, const rail::Track& track, double location_m, double speed_mps,
             double traction_strength = 1.0)
      : driver_(driver), track_(track), s(location_m), v(speed_mps), strength_(traction_strength) {}

  void run(double until_s, const std::function<bool(const PointTrain&)>& done = {}) {
    while (rail::toSeconds(t) < until_s && !(done && done(*this))) step();
  }

  void step() {
    constexpr double H = 0.02;
    const ltd::DriverCommand before = state.lead;
    driver_.command(view(), state);
    const ltd::DriverCommand now = driver_.lead(state);
    note(before, now);
    const double target_N = now.notch > 0 ? tractionForce(strength_, now.notch, v) : -dynamicForce(now.brake_notch, v);
    const double rate = 120e3 * H;
    force_N += std::clamp(target_N - force_N, -rate, rate);
    const double reduction = std::min((ltd::kChargedPipe_Pa - now.pipe_pressure_Pa) / 1.5e5, 1.0);
    air_N += (reduction * fullService(v) + now.independent_brake * 0.2e6 - air_N) * H / air_lag_s;
    const double pull = force_N + grade();
    const double drag = davis(v) + air_N;
    const double F = v > 0.0 || std::fabs(pull) > drag ? pull - drag : 0.0;
    v = std::max(0.0, v + H * F / kMass_kg);
    s += H * v;
    t += 20000000;
  }

  ltd::DriverView view() const {
    ltd::DriverView view = viewAt(t, s);
    view.speed_mps = v;
    view.grade_N = grade();
    view.resistance_N = v > 0.0 ? -davis(v) : 0.0;
    view.loco_shoes_N = v > 0.0 ? -loco_shoes_share * air_N : 0.0;
    view.air_brake_N = v > 0.0 ? -(1.0 - loco_shoes_share) * air_N : 0.0;
    view.traction_N = force_N + view.loco_shoes_N;
    view.speed_limit_mps = limit();
    view.pipe_pressure_Pa = driver_.lead(state).pipe_pressure_Pa;
    return view;
  }

  double limit() const {
    double lowest = 1e9;
    for (double x = s - kBehind_m; x <= s + kAhead_m; x += 1.0) lowest = std::min(lowest, track_.at(x).speed_limit_mps);
    return lowest;
  }

  double seconds() const { return rail::toSeconds(t); }

  ltd::Driver::State state;
  Seen seen;
  rail::Nanoseconds t = 0;
  double air_lag_s = 5.0;         ///< to fill cylinders
  double loco_shoes_share = 0.0;  ///< so much of the air brake is the locomotives' shoes

 private:
  double grade() const {
    const double length_m = kAhead_m + kBehind_m;
    const double rise_m = track_.at(s + kAhead_m).height_m - track_.at(s - kBehind_m).height_m;
    return -kMass_kg * rail::kGravity_mps2 * rise_m / length_m;
  }
  void note(const ltd::DriverCommand& before, const ltd::DriverCommand& now) {
    const int move = now.notch - before.notch;
    seen.notch_changes += move != 0;
    if (move != 0) seen.reversals += move * last_move_ < 0, last_move_ = move;
    seen.brake_notch_changes += now.brake_notch != before.brake_notch;
    seen.air_changes += now.pipe_pressure_Pa != before.pipe_pressure_Pa;
    seen.smallest_pipe_Pa = std::min(seen.smallest_pipe_Pa, now.pipe_pressure_Pa);
    seen.largest_brake_notch = std::max(seen.largest_brake_notch, now.brake_notch);
    if (t % rail::kNanosecondsPerSecond == 0) seen.largest_excess_mps = std::max(seen.largest_excess_mps, v - limit());
    seen.smallest_mps = std::min(seen.smallest_mps, v);
    seen.largest_mps = std::max(seen.largest_mps, v);
    seen.time_at_km10.emplace(static_cast<int>(std::floor(s / 100.0)), seconds());
  }

  const ltd::Driver& driver_;
  const rail::Track& track_;

 public:
  double s, v;
  double force_N = 0.0, air_N = 0.0;

 private:
  double strength_;
  int last_move_ = 0;
};

inline rail::Track line(const std::string& grades, const std::string& limits) {
  return fixtures::readMap("{name: test line, start_km: 0, end_km: 40, grades: [" + grades +
                               "], curves: [], speed_limits: [" + limits + "]}",
                           rail::Track::read);
}

/// A timetable's driver with a = 0.2 m/s2 and direct release. @param more  keys, each in its line
inline ltd::Driver timetable(const std::string& points, const rail::Track& track, const ltd::TrainAbility& can,
                             const std::string& more = "") {
  const std::string text = "kind: timetable\npoints: [" + points + "]\n" +
                           (fixtures::contains(more, "service_dec") ? "" : "service_deceleration_mps2: 0.2\n") +
                           (fixtures::contains(more, "brake_release") ? "" : "brake_release: direct\n") + more +
                           "groups: {lead: {follows: lead}}\n";
  return fixtures::readMap(
      text, [&](rail::YamlReader reader) { return ltd::Driver::read(reader, {"lead"}, {8}, {8}, kStep, track, can); });
}

}  // namespace drivers
