#include "ltd_sim/progress.hpp"

#include <algorithm>
#include <utility>

#include "rail_core/constants.hpp"
#include "rail_core/message_number.hpp"

namespace ltd {

namespace {
constexpr std::uint64_t kStepsBetweenLooks = 16;  // at the clock: a look costs more than it tells at every step
constexpr double kHeld_s =
    1.0;  // chosen: so few steps take that long only if somebody held the train or kept it waiting
}  // namespace

std::string toString(const Progress& p) {
  using rail::fixedNumber;
  return fixedNumber(p.location_m / rail::kMetresPerKilometre, 3) + " km  " + fixedNumber(p.time_s, 1) + " s  " +
         fixedNumber(p.speed_mps * rail::kKmphPerMps, 1) + " km/h  notch " + std::to_string(p.notch) + "  " +
         rail::messageNumber(p.real_time_factor) + " x real time" +
         (p.time_left_s >= 0.0 ? "  " + fixedNumber(p.time_left_s, 0) + " s left" : "");
}

ProgressMeter::ProgressMeter(const Scenario& scenario, double interval_s, Report report)
    : scenario_(scenario),
      interval_s_(interval_s),
      report_(std::move(report)),
      lead_(scenario.train.locomotives.front().vehicle) {}

void ProgressMeter::onStart(const TrainState& state) {
  last_report_ = last_look_ = Clock::now();
  last_time_s_ = static_cast<double>(state.step) * rail::toSeconds(scenario_.macro_step);
}

void ProgressMeter::onStep(const StepRecord& record) {
  if (record.after.step % kStepsBetweenLooks != 0) return;
  const Clock::time_point now = Clock::now();
  const bool was_held = std::chrono::duration<double>(now - last_look_).count() > kHeld_s;
  last_look_ = now;
  if (was_held) {
    last_report_ = now;  // the speed is that of a train that runs
    last_time_s_ = static_cast<double>(record.after.step) * rail::toSeconds(scenario_.macro_step);
  }
  const double wall_s = std::chrono::duration<double>(now - last_report_).count();
  if (wall_s < interval_s_) return;
  progress_.time_s = static_cast<double>(record.after.step) * rail::toSeconds(scenario_.macro_step);
  progress_.location_m = record.after.s_m[lead_];
  progress_.speed_mps = record.after.v_mps[lead_];
  progress_.notch = record.forces.notch.front();
  progress_.real_time_factor = (progress_.time_s - last_time_s_) / wall_s;
  const double left_s = simulatedSecondsLeft(record.after);
  progress_.time_left_s =
      left_s < 0.0 || progress_.real_time_factor <= 0.0 ? -1.0 : left_s / progress_.real_time_factor;
  last_report_ = now;
  last_time_s_ = progress_.time_s;
  report_(progress_);
}

double ProgressMeter::simulatedSecondsLeft(const TrainState& state) const {
  const double to_end_time_s = rail::toSeconds(scenario_.run.end_time) - progress_.time_s;
  const double v = state.v_mps[lead_];
  if (v <= 0.1) return -1.0;  // stands: when it will go on nobody can tell
  return std::min(to_end_time_s, (scenario_.run.end_location_m - state.s_m[lead_]) / v);
}

}  // namespace ltd
