#include "scenario_limits.hpp"

#include <optional>

#include "rail_core/constants.hpp"
#include "rail_core/message_number.hpp"

namespace ltd {

namespace {

rail::Nanoseconds readTime(rail::YamlReader& reader, const std::string& key, const rail::Range& range) {
  const std::optional<rail::Nanoseconds> t = rail::wholeNanoseconds(reader.number(key, range));
  if (t && *t > 0) return *t;
  reader.refuse(key, "must be a whole number of nanoseconds, at least one");
  return 1;
}

rail::Nanoseconds readInterval(rail::YamlReader& reader, const std::string& key, rail::Nanoseconds macro_step,
                               bool step_known) {
  rail::Nanoseconds interval = 0;
  const bool known =
      isSound(reader.problems(), [&] { interval = readTime(reader, key, rail::positive()); }) && step_known;
  if (known && interval % macro_step != 0) reader.refuse(key, "must be a whole multiple of steps.macro_step_s");
  return interval;
}

}  // namespace

RunLimits readRun(rail::YamlReader reader) {
  RunLimits run;
  run.start_location_m = reader.number("start_location_km", rail::anyNumber()) * rail::kMetresPerKilometre;
  run.end_location_m = reader.number("end_location_km", rail::anyNumber()) * rail::kMetresPerKilometre;
  run.start_speed_mps = reader.number("start_speed_kmph", rail::between(0.0, 400.0)) / rail::kKmphPerMps;
  run.end_time = readTime(reader, "end_time_s", rail::aboveUpTo(0.0, 1e6));
  rail::YamlReader stall = reader.map("stall");
  run.stall_speed_mps = stall.number("speed_below_mps", rail::notNegative());
  run.stall_time = readTime(stall, "for_s", rail::aboveUpTo(0.0, 1e5));
  stall.finish();
  if (reader.has("end_at_standstill_s"))
    run.standstill_time = readTime(reader, "end_at_standstill_s", rail::aboveUpTo(0.0, 1e5));
  if (reader.has("runaway_above_limit_kmph"))
    run.runaway_margin_mps = reader.number("runaway_above_limit_kmph", rail::between(0.0, 400.0)) / rail::kKmphPerMps;
  reader.finish();
  return run;
}

void readSteps(rail::YamlReader reader, Scenario& scenario) {
  const bool known = isSound(reader.problems(), [&] {
    scenario.macro_step = readTime(reader, "macro_step_s", rail::aboveUpTo(0.0, 1.0));
    scenario.micro_step = readTime(reader, "micro_step_s", rail::aboveUpTo(0.0, 1.0));
  });
  if (known && scenario.macro_step % scenario.micro_step != 0)
    reader.refuse("macro_step_s", "must be a whole multiple of micro_step_s = " +
                                      rail::exactNumber(rail::toSeconds(scenario.micro_step)));
  reader.finish();
}

LockLimits readLock(rail::YamlReader reader) {
  LockLimits lock;
  lock.join_deadline_s = reader.number("join_deadline_s", rail::positive());
  lock.answer_deadline_s = reader.number("answer_deadline_s", rail::positive());
  lock.synchronisation_tolerance_mps = reader.number("synchronisation_tolerance_mps", rail::positive());
  reader.finish();
  return lock;
}

OutputOptions readOutput(rail::YamlReader reader, const Bounds& bounds, rail::Nanoseconds macro_step, bool step_known) {
  OutputOptions output;
  output.report_locations_m = readLocations(reader, "report_locations_km", bounds);
  output.section_boundaries_m = readLocations(reader, "section_boundaries_km", bounds);
  output.timeseries_interval = readInterval(reader, "timeseries_interval_s", macro_step, step_known);
  output.telemetry_interval = readInterval(reader, "telemetry_interval_s", macro_step, step_known);
  output.record_exchange = reader.boolean("record_exchange");
  reader.finish();
  return output;
}

}  // namespace ltd
