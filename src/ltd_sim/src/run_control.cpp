#include "ltd_sim/run_control.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "kilometres.hpp"
#include "rail_core/constants.hpp"
#include "rail_core/message_number.hpp"

namespace ltd {

namespace {

constexpr double kLargestCount = 1e15;  // of steps and nanoseconds times 1e3: far beyond any run, and exact in a double

constexpr double kLongestLag_s = 0.1;  // of wall time that a paced run may catch up: what was waited for is not

std::string seconds(double s) { return rail::fixedNumber(s, 3) + " s"; }

}  // namespace

RunControl::Reply RunControl::request(const std::string& command, double value, const Situation& now, double wall_s) {
  if (stop_) return {false, "the run is being stopped"};
  if (command == "STOP") {
    stop_ = true;
    return {true, "the run stops at the end of the step under way"};
  }
  if (command == "HOLD") {
    mode_ = Mode::kHold;
    return {true, "holds at the end of the step under way"};
  }
  if (command == "PACE") {
    if (!std::isfinite(value) || value < 0.0) return {false, "PACE: value must be times real time >= 0 (0: no limit)"};
    pace_ = value;
    restartPace(now, wall_s);
    return {true, value > 0.0 ? "runs at " + rail::messageNumber(value) + " times real time at most"
                              : "runs as fast as it goes"};
  }
  const Reply reply = setTarget(command, value, now);
  if (reply.accepted) restartPace(now, wall_s);
  return reply;
}

RunControl::Reply RunControl::setTarget(const std::string& command, double value, const Situation& now) {
  if (command == "RUN") {
    mode_ = Mode::kRun;
    return {true, "runs to the scenario's end"};
  }
  if (command == "STEP") {
    if (!(value >= 1.0 && value <= kLargestCount) || value != std::floor(value))
      return {false, "STEP: value must be a whole number of macro steps >= 1"};
    mode_ = Mode::kUntilStep;
    until_step_ = now.step + static_cast<std::uint64_t>(value);
    return {true, "runs to the end of step " + std::to_string(until_step_ - 1) + ", then holds"};
  }
  if (command == "RUN_UNTIL_TIME") {
    if (!(value > rail::toSeconds(now.time) && value * 1e9 <= kLargestCount * 1e3))
      return {false, "RUN_UNTIL_TIME: value must be a time [s] after now, " + seconds(rail::toSeconds(now.time))};
    if (value > rail::toSeconds(now.end_time))
      return {false, "RUN_UNTIL_TIME: value is after the scenario's end, " + seconds(rail::toSeconds(now.end_time))};
    mode_ = Mode::kUntilTime;
    until_time_ = static_cast<rail::Nanoseconds>(std::llround(value * 1e9));
    return {true, "runs until " + rail::exactNumber(value) + " s, then holds"};
  }
  if (command == "RUN_UNTIL_PLACE") {
    const double location_m = value * rail::kMetresPerKilometre;
    if (!std::isfinite(value) || location_m <= now.location_m)
      return {false, "RUN_UNTIL_PLACE: value must be a place [km] ahead of the leading locomotive at " +
                         kilometres(now.location_m)};
    if (location_m > now.end_location_m)
      return {false, "RUN_UNTIL_PLACE: value is beyond the scenario's end, " + kilometres(now.end_location_m)};
    mode_ = Mode::kUntilPlace;
    until_place_m_ = location_m;
    return {true, "runs until the leading locomotive is at " + rail::exactNumber(value) + " km, then holds"};
  }
  return {false, "unknown command '" + command +
                     "': must be one of HOLD, RUN, STEP, RUN_UNTIL_TIME, RUN_UNTIL_PLACE, PACE, STOP"};
}

bool RunControl::mayBegin(const Situation& now, double wall_s) {
  const bool reached = (mode_ == Mode::kUntilStep && now.step >= until_step_) ||
                       (mode_ == Mode::kUntilTime && now.time >= until_time_) ||
                       (mode_ == Mode::kUntilPlace && now.location_m >= until_place_m_);
  if (reached) mode_ = Mode::kHold;
  if (mode_ == Mode::kHold || stop_ || paceWait(now, wall_s) > 0.0) return false;
  if (pace_ > 0.0 && wall_s - due_s(now) > kLongestLag_s) restartPace(now, wall_s);
  return true;
}

double RunControl::due_s(const Situation& now) const {
  return pace_wall_s_ + rail::toSeconds(now.time - pace_time_) / pace_;
}

double RunControl::paceWait(const Situation& now, double wall_s) const {
  if (pace_ <= 0.0 || mode_ == Mode::kHold) return 0.0;
  return std::max(0.0, due_s(now) - wall_s);
}

void RunControl::restartPace(const Situation& now, double wall_s) {
  pace_time_ = now.time;
  pace_wall_s_ = wall_s;
}

}  // namespace ltd
