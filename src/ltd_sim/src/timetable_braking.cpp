// The part of TimetableDriver that brakes. He reckons ahead what his own commands will do: shoes follow the pipe late,
// so air is decided for the time at which it presses, and the dynamic brake trims what is left.

#include <algorithm>
#include <cmath>

#include "ltd_sim/timetable_driver.hpp"

namespace ltd {

namespace {

constexpr double kBrakeBand_mps = 0.75;  // chosen: he brakes for the timetable's sake only this much above cruising
constexpr double kBrakeP_1ps = 0.05;     // chosen: what is left of an error after it was foreseen is taken off in 20 s
constexpr double kLookStep_s = 0.5;      // chosen: short against the filling of cylinders
constexpr double kLook_s = 15.0;         // chosen: how far ahead the dynamic brake is trimmed on a grade
constexpr double kTrimBand_mps = 1.0;    // chosen: downhill the speed may fall by that before the brake is eased
constexpr double kCurveBand_mps = 0.25;  // chosen: likewise on the curve down to a limit or a stop
constexpr double kSlowBand_mps = 0.5;    // chosen: as slow as this the air alone must make the train before it is eased
constexpr double kReleaseBand_mps = 3.0;  // chosen: 11 km/h, or direct brakes would be applied and released in turn
constexpr double kEasedShare = 0.95;   // chosen: as soon as the dynamic brake can do it with this share, air is eased
constexpr double kAirShare = 0.8;      // chosen: air is set so that the dynamic brake can trim both ways
constexpr double kHysteresis = 0.3;    // chosen, of a step of the pipe
constexpr double kSafe_s = 10.0;       // chosen: so long after a release the speed must still be right
constexpr double kAirSettled_s = 5.0;  // chosen: after that what is felt counts, not what was reckoned
constexpr double kNotchSettled = 3.0;  // chosen: likewise of a notch, in times of reaction
constexpr double kFirstNotch = 2.0;    // chosen: of these until he has begun and a first notch acts
const double kNotchTime_s = rail::toSeconds(DriverControls::kQuickHold);  // to a far one
constexpr int kEasing = 5;           // chosen: air is eased after five times the hold
constexpr double kHeld_Pa = 0.05e5;  // chosen: so much above the reduction that lets brakes go

}  // namespace

/// The speed above which he brakes.
double TimetableDriver::brakeReference(double s_m, const State& state) const {
  return std::min(permittedSpeed(s_m, state), state.cruise_mps + kBrakeBand_mps);
}

double TimetableDriver::dynamicBrake(double v_mps) const {
  return ability_.brake_notches > 0 ? ability_.dynamic_brake_N(ability_.brake_notches, v_mps) / ability_.mass_kg : 0.0;
}

/// Deceleration that all brakes together must give there, >= 0.                                              (V7)
double TimetableDriver::wantedBrake(const Ahead& ahead, const DriverView& view, const State& state) const {
  const double permitted = permittedSpeed(ahead.s_m, state);
  const double reference = std::min(permitted, state.cruise_mps + kBrakeBand_mps);
  const double a_ref = reference < permitted ? 0.0 : slopeAt(ahead.s_m, state);
  const double known =
      (view.grade_N + view.resistance_N) / ability_.mass_kg + line_.loss(view.location_m) - line_.loss(ahead.s_m);
  return std::max(0.0, known - a_ref - kBrakeP_1ps * (reference - ahead.speed_mps));
}

/// Share of full service that presses now, by the shoes of all vehicles, as full service is counted.
double TimetableDriver::feltShare(const DriverView& view) const {
  const double full = line_.fullService(view.speed_mps);
  return full > 0.0 ? std::fabs(view.air_brake_N + view.loco_shoes_N) / ability_.mass_kg / full : 0.0;
}

/// Acceleration by the locomotives now, without their shoes: those are in the share.
double TimetableDriver::feltPull(const DriverView& view) const {
  return (view.traction_N - view.loco_shoes_N) / ability_.mass_kg;
}

/// What his last commands come to. What has had its time is taken as it is felt.
TimetableDriver::Course TimetableDriver::presentCourse(const DriverView& view, const State& state,
                                                       const DriverCommand& lead) const {
  const DriverControls::State& controls = state.controls;
  const BrakeResponse& response = ability_.brake_response;
  Course course;
  course.ramp_s = reaction_s_;
  course.locomotives_mps2 = lead.notch > 0 ? 0.0 : feltPull(view);  // before braking he shuts off
  const double since_notch_s = rail::toSeconds(view.t - controls.brake_notch_changed);
  if (lead.notch == 0 && since_notch_s < kNotchSettled * reaction_s_)
    course.locomotives_mps2 =
        lead.brake_notch > 0 ? -ability_.dynamic_brake_N(lead.brake_notch, view.speed_mps) / ability_.mass_kg : 0.0;
  const double felt = feltShare(view);
  const double asked = controls.reduction_Pa / ability_.full_service_reduction_Pa;
  const double since_air_s = rail::toSeconds(view.t - controls.air_changed);
  const double delay_s = asked > felt ? response.delay_s : response.release_delay_s;
  const double change_s = std::fabs(asked - felt) / (asked > felt ? response.fill_per_s : response.release_per_s);
  const bool under_way = since_air_s < delay_s + change_s + kAirSettled_s;
  course.air_share = under_way ? asked : felt;
  course.air_delay_s = std::max(0.0, delay_s - since_air_s);
  return course;
}

/// The same with all that the dynamic brake has.
TimetableDriver::Course TimetableDriver::fullDynamicBrake(const DriverView& view, Course course) const {
  course.locomotives_mps2 = std::min(course.locomotives_mps2, -dynamicBrake(view.speed_mps));
  course.ramp_s = kFirstNotch * reaction_s_ + kNotchTime_s * ability_.brake_notches;
  return course;
}

/// Reckons speed and place `horizon_s` from now. Resistance is taken as it is now.                           (V9)
TimetableDriver::Ahead TimetableDriver::lookAhead(const DriverView& view, const State& state, const Course& course,
                                                  double horizon_s, double from_s) const {
  const BrakeResponse& response = ability_.brake_response;
  const double pull = feltPull(view);
  const double known = (view.grade_N + view.resistance_N) / ability_.mass_kg + line_.loss(view.location_m);
  Ahead ahead;
  ahead.s_m = view.location_m;
  ahead.speed_mps = view.speed_mps;
  double share = feltShare(view);
  for (double t = kLookStep_s; t <= horizon_s + 0.5 * kLookStep_s; t += kLookStep_s) {
    const double done = std::min(1.0, (t - 0.5 * kLookStep_s) / course.ramp_s);
    if (t > course.air_delay_s)
      share = std::clamp(course.air_share, share - kLookStep_s * response.release_per_s,
                         share + kLookStep_s * response.fill_per_s);
    ahead.air_mps2 = share * line_.fullService(ahead.speed_mps);
    const double a = known - line_.loss(ahead.s_m) + pull + done * (course.locomotives_mps2 - pull) - ahead.air_mps2;
    const double v = std::max(0.0, ahead.speed_mps + kLookStep_s * a);
    ahead.s_m += 0.5 * kLookStep_s * (ahead.speed_mps + v);
    ahead.speed_mps = v;
    if (t >= from_s - 0.5 * kLookStep_s)
      ahead.excess_mps = std::max(ahead.excess_mps, v - brakeReference(ahead.s_m, state));
  }
  return ahead;
}

/// The dynamic brake holds what grade and resistance leave, and is touched only if the speed would leave its band.
DriverControls::Trim TimetableDriver::wantedDynamicBrake(const DriverView& view, const State& state,
                                                         const DriverCommand& lead) const {
  const Course course = presentCourse(view, state, lead);
  const double near_s = reaction_s_ + 0.5 * kNotchTime_s * ability_.brake_notches;
  const double far_s = std::max(kLook_s, near_s);
  const Ahead near = lookAhead(view, state, course, near_s, near_s);
  const Ahead far = lookAhead(view, state, course, far_s, far_s);
  const bool level = slopeAt(far.s_m, state) == 0.0;  // not yet down to a lower limit
  DriverControls::Trim trim;
  trim.up = near.excess_mps > 0.0 || (level && far.excess_mps > 0.0);
  const Ahead& at = near.excess_mps > 0.0 || !level ? near : far;
  trim.down = !trim.up && at.speed_mps < brakeReference(at.s_m, state) - (level ? kTrimBand_mps : kCurveBand_mps);
  trim.force_N = ability_.mass_kg * (wantedBrake(at, view, state) - at.air_mps2);
  return trim;
}

void TimetableDriver::moveAir(const DriverView& view, State& state, const DriverCommand& lead) const {
  const DriverControls::State& controls = state.controls;
  if (!ability_.full_service_N || view.t - controls.air_changed < controls_.settings.air_hold) return;
  if (view.speed_mps < kStanding_mps) {
    if (permittedSpeed(view.location_m, state) > 0.0) setReduction(0.0, view, state);
    return;
  }
  const Course course = presentCourse(view, state, lead);
  const double more_Pa = moreAir(view, state, course);
  setReduction(more_Pa > controls.reduction_Pa ? more_Pa : lessAir(view, state, course), view, state);
}

/// More if, even with the whole dynamic brake, the train would be too fast once the air presses.
double TimetableDriver::moreAir(const DriverView& view, const State& state, const Course& course) const {
  const double now_Pa = state.controls.reduction_Pa, share = now_Pa / ability_.full_service_reduction_Pa;
  const double full = line_.fullService(view.speed_mps);
  const double known = (view.grade_N + view.resistance_N) / ability_.mass_kg;
  const double curve = (deceleration_mps2_ + known - dynamicBrake(view.speed_mps)) / full;
  const double least = share > 0.0 ? share : DriverControls::kFirstReduction_Pa / ability_.full_service_reduction_Pa;
  const double delay_s = std::max(
      reaction_s_, ability_.brake_response.equivalentDelay(share, std::clamp(curve, std::min(least, 1.0), 1.0)));
  const Ahead ahead = lookAhead(view, state, fullDynamicBrake(view, course), delay_s, delay_s);
  if (ahead.excess_mps <= 0.0) return now_Pa;
  const double wanted = wantedBrake(ahead, view, state), there = line_.fullService(ahead.speed_mps);
  const double dynamic = dynamicBrake(ahead.speed_mps);
  const double step = DriverControls::kReductionStep_Pa / ability_.full_service_reduction_Pa;
  if ((wanted - dynamic) / there <= share + kHysteresis * step) return now_Pa;
  return std::max(now_Pa, DriverControls::reductionFor((wanted - kAirShare * dynamic) / there, ability_));
}

/// Less as soon as the dynamic brake can do it, as far as the train would not become too fast afterwards.
double TimetableDriver::lessAir(const DriverView& view, const State& state, const Course& course) const {
  const DriverControls::State& controls = state.controls;
  const double now_Pa = controls.reduction_Pa, full_Pa = ability_.full_service_reduction_Pa;
  if (now_Pa <= 0.0) return 0.0;
  const double delay_s = std::max(reaction_s_, ability_.brake_response.equivalentDelay(now_Pa / full_Pa, 0.0));
  Course idle = course;
  idle.locomotives_mps2 = 0.0;
  const Ahead slow = lookAhead(view, state, idle, delay_s, delay_s);
  const bool first = now_Pa == DriverControls::kFirstReduction_Pa;  // it may be more than he needs
  const bool down = slopeAt(view.location_m, state) < 0.0 || slopeAt(slow.s_m, state) < 0.0;
  const bool soon = graduated_release_ && (first || down || controls.last_air_move < 0);
  if (view.t - controls.air_changed < (soon ? 1 : kEasing) * controls_.settings.air_hold) return now_Pa;
  double less_Pa = graduated_release_ ? easedReduction(slow, view, state) : directRelease(slow, view, state);
  Course eased = fullDynamicBrake(view, course);
  eased.air_delay_s = ability_.brake_response.release_delay_s;
  for (; less_Pa < now_Pa; less_Pa = leastAbove(less_Pa)) {
    eased.air_share = less_Pa / full_Pa;
    if (lookAhead(view, state, eased, delay_s + kSafe_s, 0.0).excess_mps <= 0.0) return less_Pa;
    if (!graduated_release_) break;
  }
  return now_Pa;
}

/// The next larger reduction that brakes hold with graduated release.
double TimetableDriver::leastAbove(double reduction_Pa) const {
  return std::max(reduction_Pa + DriverControls::kReductionStep_Pa, ability_.full_release_reduction_Pa + kHeld_Pa);
}

/// What the dynamic brake leaves to the air where the train is then, the speed being right.
double TimetableDriver::easedReduction(const Ahead& then, const DriverView& view, const State& state) const {
  Ahead right = then;
  right.speed_mps = brakeReference(then.s_m, state);
  const double dynamic = kEasedShare * dynamicBrake(right.speed_mps), wanted = wantedBrake(right, view, state);
  if (wanted <= dynamic) return 0.0;
  const double share = (wanted - dynamic) / line_.fullService(right.speed_mps);
  const double steps = std::ceil(share * ability_.full_service_reduction_Pa / DriverControls::kReductionStep_Pa);
  return std::max(DriverControls::kReductionStep_Pa * steps, ability_.full_release_reduction_Pa + kHeld_Pa);
}

/// Direct-release brakes come off altogether or not at all: once the train would be too slow.
double TimetableDriver::directRelease(const Ahead& then, const DriverView& view, const State& state) const {
  const bool rolls = view.grade_N + view.resistance_N > 0.0;  // it would be fast again at once
  const double slack = brakeReference(then.s_m, state) - then.speed_mps;
  const bool slow = slack >= (rolls ? kReleaseBand_mps : kSlowBand_mps);
  return slow && view.speed_mps >= release_above_mps_ ? 0.0 : state.controls.reduction_Pa;
}

/// Asks the pipe for another pressure, and reckons when the last brake will be off.
void TimetableDriver::setReduction(double reduction_Pa, const DriverView& view, State& state) const {
  DriverControls::State& controls = state.controls;
  const double before_Pa = controls.reduction_Pa;
  if (reduction_Pa == before_Pa) return;
  const BrakeResponse& response = ability_.brake_response;
  const double first_Pa = ability_.first_reduction_Pa, full_Pa = ability_.full_service_reduction_Pa;
  const double of_full = std::clamp((before_Pa - first_Pa) / std::max(full_Pa - first_Pa, 1.0), 0.0, 1.0);
  const double free_s = response.free_from_first_s + of_full * (response.free_from_full_s - response.free_from_first_s);
  if (reduction_Pa == 0.0) state.tail_free = view.t + static_cast<rail::Nanoseconds>(std::llround(free_s * 1e9));
  controls.last_air_move = reduction_Pa > before_Pa ? 1 : -1;
  controls.reduction_Pa = reduction_Pa;
  controls.air_changed = view.t;
}

}  // namespace ltd
