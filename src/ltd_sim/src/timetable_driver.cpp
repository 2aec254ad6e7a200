#include "ltd_sim/timetable_driver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kilometres.hpp"
#include "rail_core/message_number.hpp"

namespace ltd {

namespace {

constexpr rail::Nanoseconds kControlPeriod = 200000000;  // chosen: a person's; notches are held much longer
constexpr double kP_1ps = 0.1;      // chosen: 1 m/s too slow asks for 0.1 m/s2, reached without overshoot
constexpr double kI_1ps2 = 0.0005;  // chosen: 20 times slower than P, for what the feed-forward does not know
constexpr double kLargestIntegral_mps2 = 0.02;  // chosen: 2 permille of grade
constexpr double kLargestStart_mps2 = 0.5;      // chosen: more than a freight train's traction gives
constexpr double kIndifferent_mps = 0.25;  // chosen: 1 km/h that he does not answer, or notches would follow each other
// Downhill he leaves to the grade what it gains within a minute, up to 14 km/h; both chosen.
constexpr double kRolls_mps = 4.0;
constexpr double kRolls_s = 60.0;
constexpr double kNearPoint_s = 30.0;       // chosen: so near to a point seconds are not worth a change of speed
constexpr double kSlowestCruise_mps = 3.0;  // chosen: slower than that he would rather be early
constexpr double kEasing = 0.9;            // chosen: he slows for the timetable's sake by the dynamic brake, not by air
constexpr double kStopTolerance_m = 20.0;  // chosen: nearer to the stop he does not move up
constexpr double kSlope_m = 1.0;           // chosen: distance over which a braking curve's slope is taken

}  // namespace

void TimetableDriver::command(const DriverView& view, State& state, DriverCommand& lead) const {
  if (state.started && view.t < state.next_control) return;
  if (!state.started) start(view, state);
  state.next_control = view.t + kControlPeriod;
  passPoints(view, state);
  if (state.waiting && view.t >= state.departure) {
    state.waiting = false;
    state.leaving = true;
    leavePoint(view, state);
  }
  if (view.t >= state.next_plan) {
    plan(view, state);
    state.next_plan = view.t + planning_period_;
  }
  if (state.waiting)
    hold(view, state, lead);
  else
    drive(view, state, lead);
}

/// What lies behind the start is not on the timetable, and the pipe's pressure tells whether the train is braked.
void TimetableDriver::start(const DriverView& view, State& state) const {
  while (nextPoint(state) && nextPoint(state)->location_m < view.location_m) ++state.point;
  const double reduction_Pa = std::max(0.0, kChargedPipe_Pa - view.pipe_pressure_Pa);
  state.controls.reduction_Pa = std::min(reduction_Pa, ability_.full_service_reduction_Pa);
  state.started = true;
}

void TimetableDriver::passPoints(const DriverView& view, State& state) const {
  while (const Point* const point = nextPoint(state)) {
    const double left_m = point->location_m - view.location_m;
    if (state.waiting || left_m > (point->stop ? kStopTolerance_m : 0.0)) return;
    if (point->stop && view.speed_mps > kStanding_mps) return;
    noteArrival(*point, view, state);
    if (!point->stop) {
      leavePoint(view, state);
      continue;
    }
    if (left_m < -kStopTolerance_m)
      state.notes.push_back("timetable: stop at " + kilometres(point->location_m) + " overrun by " +
                            rail::fixedNumber(-left_m, 0) + " m");
    state.waiting = true;
    state.departure = std::numeric_limits<rail::Nanoseconds>::max();
    if (point->dwell_s) state.departure = view.t + static_cast<rail::Nanoseconds>(std::llround(*point->dwell_s * 1e9));
  }
}

void TimetableDriver::leavePoint(const DriverView& view, State& state) const {
  ++state.point;
  state.planned = false;
  state.next_plan = view.t;
}

void TimetableDriver::noteArrival(const Point& point, const DriverView& view, State& state) const {
  if (!point.time_s) return;
  const double late_s = rail::toSeconds(view.t) - *point.time_s;
  if (late_s > late_tolerance_s_)
    state.notes.push_back("timetable: " + kilometres(point.location_m) + " reached " + rail::fixedNumber(late_s, 0) +
                          " s late");
}

/// The slowest cruising speed that still meets the next time; the line's fastest if none does or none is asked. (V6)
void TimetableDriver::plan(const DriverView& view, State& state) const {
  const double fastest = line_.largestSpeed();
  const Point* const point = nextPoint(state);
  const double left_s = point && point->time_s ? *point->time_s - rail::toSeconds(view.t) : -kNearPoint_s;
  if (state.planned && point && !point->stop && std::fabs(left_s) < kNearPoint_s) return;
  state.planned = true;
  state.cruise_mps = fastest;
  if (left_s <= 0.0) return;
  const double stop_mps2 = point->stop ? point->deceleration_mps2 : 0.0;
  const auto time = [&](double cruise_mps) {
    return line_.runningTime(view.location_m, view.speed_mps, point->location_m, stop_mps2, cruise_mps);
  };
  if (time(fastest) >= left_s) return;
  double low = std::min(std::max(kSlowestCruise_mps, kEasing * view.speed_mps), fastest), high = fastest;
  for (int i = 0; i < 12; ++i) {  // chosen: 12 halvings leave less than 0.01 m/s
    const double middle = 0.5 * (low + high);
    (time(middle) > left_s ? low : high) = middle;
  }
  state.cruise_mps = high;
}

double TimetableDriver::permittedSpeed(double s_m, const State& state) const {
  const double permitted = line_.permittedSpeed(s_m);
  const Point* const point = nextPoint(state);
  if (!point || !point->stop) return permitted;
  const double left_m = std::max(0.0, point->location_m - s_m);
  return std::min(permitted, std::sqrt(2.0 * point->deceleration_mps2 * left_m));  // (V5)
}

/// Acceleration along the permitted speed, <= 0.
double TimetableDriver::slopeAt(double s_m, const State& state) const {
  const double permitted = permittedSpeed(s_m, state), after = permittedSpeed(s_m + kSlope_m, state);
  if (permitted <= 0.0) return -deceleration_mps2_;
  return std::clamp((after * after - permitted * permitted) / (2.0 * kSlope_m), -deceleration_mps2_, 0.0);
}

void TimetableDriver::drive(const DriverView& view, State& state, DriverCommand& lead) const {
  moveAir(view, state, lead);
  DriverControls::Wanted wanted;
  wanted.dynamic = wantedDynamicBrake(view, state, lead);
  wanted.traction_N = wantedTraction(view, state, lead);
  controls_.apply(wanted, ability_, view, state.controls, lead);
  if (state.leaving && view.traction_N + view.grade_N > 0.0) state.leaving = false;
  lead.independent_brake = state.leaving ? 1.0 : 0.0;
}

/// At the rail. As long as brakes may still drag he pulls no more than the grade asks for.
double TimetableDriver::wantedTraction(const DriverView& view, State& state, const DriverCommand& lead) const {
  const double known_N = view.grade_N + view.resistance_N;
  double a = (known_N + view.traction_N + view.air_brake_N) / ability_.mass_kg;
  if (view.speed_mps < kStanding_mps) a = std::max(0.0, a);
  const double v = std::max(0.0, view.speed_mps + a * reaction_s_);  // when a command of now has its force
  const double s = view.location_m + 0.5 * (view.speed_mps + v) * reaction_s_;
  const double permitted = permittedSpeed(s, state), reference = std::min(permitted, state.cruise_mps);
  integrate(reference - view.speed_mps, state, lead);
  if (known_N > 0.0 && reference - v < std::min(kRolls_mps, kRolls_s * known_N / ability_.mass_kg)) return 0.0;
  const double a_ref = reference < permitted ? 0.0 : slopeAt(s, state);  // (V7)
  const double error = reference - v;
  const double a_p = kP_1ps * (error - std::clamp(error, -kIndifferent_mps, kIndifferent_mps));
  const double wanted_N = ability_.mass_kg * std::min(a_ref + a_p + state.integral_mps2, kLargestStart_mps2) - known_N;
  return view.t < state.tail_free ? std::min(wanted_N, std::max(0.0, -view.grade_N)) : wanted_N;
}

/// The integral knows what the feed-forward does not, while traction pulls near the reference; else it would wind up.
void TimetableDriver::integrate(double error_mps, State& state, const DriverCommand& lead) const {
  const bool pulls = lead.notch > 0 && std::fabs(error_mps) < 1.0;  // chosen: 4 km/h
  if (!pulls || std::fabs(error_mps) < kIndifferent_mps) return;
  state.integral_mps2 = std::clamp(state.integral_mps2 + kI_1ps2 * error_mps * rail::toSeconds(kControlPeriod),
                                   -kLargestIntegral_mps2, kLargestIntegral_mps2);
}

/// Stands, idle: the air brake with what holds the train there, and the locomotives' own.
void TimetableDriver::hold(const DriverView& view, State& state, DriverCommand& lead) const {
  const Point* const point = nextPoint(state);
  setReduction(std::max(state.controls.reduction_Pa, point ? point->holding_Pa : 0.0), view, state);
  controls_.apply({0.0, {0.0, false, true}}, ability_, view, state.controls, lead);
  lead.independent_brake = 1.0;
}

}  // namespace ltd
