#include "ltd_sim/driver.hpp"

#include <algorithm>
#include <cmath>

#include "driver_sources.hpp"
#include "ltd_sim/command_limits.hpp"

namespace ltd {

namespace {

constexpr const char* kLead = "lead";

int largestOf(const std::vector<int>& values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

}  // namespace

Driver::Group Driver::readGroup(rail::YamlReader reader, int largest_notch, int largest_brake_notch) {
  Group group;
  group.largest_notch = largest_notch;
  group.largest_brake_notch = largest_brake_notch;
  group.fixed = reader.has("notch") || reader.has("brake_notch");
  if (group.fixed) {
    group.fixed_notch = reader.integerOr("notch", 0, largest_notch, 0);
    group.fixed_brake_notch = reader.integerOr("brake_notch", 0, largest_brake_notch, 0);
    if (group.fixed_notch > 0 && group.fixed_brake_notch > 0)
      reader.refuse("brake_notch", "must be 0 beside a notch: never both at once");
  } else {
    reader.choice("follows", {kLead});
    const double delay_s = reader.numberOr("delay_s", rail::between(0.0, 600.0), 0.0);
    const std::optional<rail::Nanoseconds> delay = rail::wholeNanoseconds(delay_s);
    if (!delay) reader.refuse("delay_s", "must be a whole number of nanoseconds");
    group.delay = delay.value_or(0);
    group.notch_offset = reader.integerOr("notch_offset", -largest_notch, largest_notch, 0);
  }
  reader.finish();
  return group;
}

ExternalDriver Driver::readExternal(rail::YamlReader& reader, rail::Nanoseconds macro_step,
                                    const DriverSchedule::Largest& largest) {
  ExternalDriver external;
  const double period_s = reader.number("period_s", rail::aboveUpTo(0.0, 3600.0));
  const std::optional<rail::Nanoseconds> period = rail::wholeNanoseconds(period_s);
  external.period = period && *period > 0 ? *period : 1;
  if (macro_step > 0 && (!period || *period % macro_step != 0))
    reader.refuse("period_s", "must be a whole multiple of steps.macro_step_s");
  external.answer_deadline_s = reader.number("answer_deadline_s", rail::positive());
  rail::YamlReader silence = reader.map("on_silence");
  DriverCommand& command = external.on_silence;
  command.brake_notch = silence.integerOr("brake_notch", 0, largest.brake_notch, 0);
  const double charged_bar = kChargedPipe_Pa / kPascalsPerBar;
  command.pipe_pressure_Pa =
      silence.numberOr("pipe_bar", rail::between(0.0, charged_bar), charged_bar) * kPascalsPerBar;
  command.independent_brake = silence.numberOr("independent_brake", rail::between(0.0, 1.0), 0.0);
  command.emergency = silence.booleanOr("emergency", false);
  if (!largest.air_brake && command.pipe_pressure_Pa < kChargedPipe_Pa)
    silence.refuse("pipe_bar", std::string("must be 5, ") + kNoAirBrake);
  if (!largest.air_brake && command.independent_brake > 0.0)
    silence.refuse("independent_brake", std::string("must be 0, ") + kNoAirBrake);
  if (!largest.air_brake && command.emergency)
    silence.refuse("emergency", std::string("must be false, ") + kNoAirBrake);
  silence.finish();
  return external;
}

Driver Driver::read(rail::YamlReader reader, const std::vector<std::string>& groups,
                    const std::vector<int>& largest_notch, const std::vector<int>& largest_brake_notch,
                    rail::Nanoseconds macro_step, const rail::Track& track, const TrainAbility& ability) {
  Driver driver;
  driver.largest_ = {largestOf(largest_notch), largestOf(largest_brake_notch), ability.air_brake, ability.sand};
  const std::string kind = reader.choiceOr("kind", {"schedule", "recorder", "timetable", "external"}, "schedule");
  if (kind == "schedule") driver.schedule_ = DriverSchedule::read(reader, driver.largest_);
  if (kind == "recorder") driver.schedule_ = DriverSchedule::readRecorder(reader, driver.largest_);
  if (kind == "timetable")
    driver.timetable_ = std::make_shared<const TimetableDriver>(TimetableDriver::read(reader, track, ability));
  if (kind == "external") driver.external_ = readExternal(reader, macro_step, driver.largest_);
  rail::YamlReader map = reader.map("groups");
  for (std::size_t i = 0; i < groups.size(); ++i)
    driver.groups_.push_back(readGroup(map.map(groups[i]), largest_notch[i], largest_brake_notch[i]));
  for (const Group& group : driver.groups_) driver.longest_delay_ = std::max(driver.longest_delay_, group.delay);
  map.finish();
  reader.finish();
  return driver;
}

void Driver::command(const DriverView& view, State& state) const {
  if (schedule_) state.lead = schedule_->at(view.t, view.location_m);
  if (timetable_) timetable_->command(view, state.timetable, state.lead);
  if (asksAt(view.t)) state.lead = state.given;
  remember(view.t, state);
}

/// Notes a change of the notches; allocates only when more of them lie within the longest delay than ever before.
void Driver::remember(rail::Nanoseconds t, State& state) const {
  std::vector<State::Change>& changes = state.changes;
  const DriverCommand& lead = state.lead;
  if (!changes.empty() && changes.back().notch == lead.notch && changes.back().brake_notch == lead.brake_notch) return;
  std::size_t past = 0;  // so many are before the one that the most delayed group obeys now
  while (past + 1 < changes.size() && changes[past + 1].time <= t - longest_delay_) ++past;
  if (longest_delay_ == 0 && !changes.empty()) past = changes.size();
  changes.erase(changes.begin(), changes.begin() + static_cast<std::ptrdiff_t>(past));
  changes.push_back({t, lead.notch, lead.brake_notch});
}

DriverCommand Driver::groupCommand(std::size_t group, rail::Nanoseconds t, const State& state) const {
  const Group& g = groups_[group];
  DriverCommand command = state.lead;
  command.notch = g.fixed_notch;
  command.brake_notch = g.fixed_brake_notch;
  if (g.fixed) return command;
  for (auto change = state.changes.rbegin(); change != state.changes.rend(); ++change) {
    if (change->time > t - g.delay) continue;
    // idle stays idle whatever the offset
    command.notch = change->notch == 0 ? 0 : std::clamp(change->notch + g.notch_offset, 0, g.largest_notch);
    command.brake_notch = std::min(change->brake_notch, g.largest_brake_notch);
    break;
  }
  return command;
}

/// Fields have the names that they have in the message DriverCommand.
std::string Driver::give(const DriverCommand& answer, State& state) const {
  std::string fault = refuseCommand(answer, largest_);
  if (fault.empty()) state.given = answer;
  return fault;
}

}  // namespace ltd
