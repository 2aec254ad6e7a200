#include "ltd_sim/driver_schedule.hpp"

#include <algorithm>
#include <cmath>

#include "driver_sources.hpp"
#include "ltd_sim/csv_file.hpp"
#include "rail_core/constants.hpp"
#include "rail_core/csv_table.hpp"

namespace ltd {

namespace {

constexpr const char* kNoSand =
    "must be 0: the scenario has no sanded_adhesion, so sand would change nothing: give one, or leave sanding out";

bool isWholeUpTo(double x, int largest) { return x == std::floor(x) && x >= 0.0 && x <= largest; }

}  // namespace

DriverSource makeCsvSource(rail::YamlReader& reader, const std::string& key, const rail::CsvTable& csv,
                           std::size_t column) {
  DriverSource source;
  source.given = true;
  for (std::size_t i = 0; i < csv.rows.size(); ++i) source.rows.push_back({csv.rows[i][0], csv.rows[i][column]});
  const std::string file = reader.file(key);
  source.refuse = [&reader, csv, file, column](std::size_t row, std::size_t cell, const std::string& rule) {
    const std::size_t j = cell == 0 ? 0 : column;
    reader.problems().add(file, "line " + std::to_string(csv.line_of_row[row]) + ": " + csv.columns[j],
                          allDigits(csv.rows[row][j]), rule);
  };
  return source;
}

const char* DriverSchedule::listName(std::size_t channel) {
  constexpr const char* kNames[kChannels] = {"notches", "brake_notches", "pipe_bar", "independent_brake", "sanding"};
  return kNames[channel];
}

const char* DriverSchedule::columnName(std::size_t channel) {
  constexpr const char* kNames[kChannels] = {"notch", "brake_notch", "pipe_bar", "independent_brake", "sanding"};
  return kNames[channel];
}

std::string DriverSchedule::valueRule(std::size_t channel, double value, const Largest& largest) {
  switch (channel) {
    case kNotch:
      return isWholeUpTo(value, largest.notch) ? ""
                                               : "must be a whole notch from 0 to " + std::to_string(largest.notch);
    case kBrakeNotch:
      return isWholeUpTo(value, largest.brake_notch)
                 ? ""
                 : "must be a whole brake notch from 0 to " + std::to_string(largest.brake_notch);
    case kPipe:
      if (!largest.air_brake && value < kChargedPipe_Pa) return "must be 5, " + std::string(kNoAirBrake);
      return value >= 0.0 && value <= kChargedPipe_Pa ? "" : "must be 0 to 5 bar (500 kPa)";
    case kIndependent:
      if (!largest.air_brake && value > 0.0) return "must be 0, " + std::string(kNoAirBrake);
      return value >= 0.0 && value <= 1.0 ? "" : "must be a share from 0 to 1";
    default:
      if (!largest.sand && value == 1.0) return kNoSand;
      return value == 0.0 || value == 1.0 ? "" : "must be 0 or 1";
  }
}

DriverSource DriverSchedule::listSource(rail::YamlReader& reader, std::size_t channel) {
  const std::string key = listName(channel);
  DriverSource source;
  source.given = true;
  const std::size_t before = reader.problems().count();
  source.rows = reader.rows(key, 2);
  if (source.rows.empty() && reader.problems().count() == before)
    reader.refuse(key, "must have at least one entry [from, " + std::string(columnName(channel)) + "]");
  source.refuse = [&reader, key](std::size_t row, std::size_t cell, const std::string& rule) {
    reader.refuse(key + "." + std::to_string(row) + "." + std::to_string(cell), rule);
  };
  return source;
}

/// A table may hold any of the channels; the others stay without entries.
void DriverSchedule::readTable(rail::YamlReader& reader, Sources& sources) const {
  const std::string file = reader.file("table");
  const std::size_t before = reader.problems().count();
  const rail::CsvTable csv =
      rail::readOpenCsv(reader.text("table"), file, over_time_ ? "time_s" : "location_km", reader.problems());
  if (reader.problems().count() != before) return;
  const std::string header = "line " + std::to_string(csv.line_of_header);
  std::vector<std::string> known;
  for (std::size_t channel = 0; channel < kChannels; ++channel) known.push_back(columnName(channel));
  for (std::size_t j = 1; j < csv.columns.size(); ++j) {
    const auto at = std::find(known.begin(), known.end(), csv.columns[j]);
    if (at != known.end()) {
      sources[static_cast<std::size_t>(at - known.begin())] = makeCsvSource(reader, "table", csv, j);
      continue;
    }
    const std::string near = rail::nearestWord(csv.columns[j], known);
    reader.problems().add(
        file, header,
        "unknown column '" + csv.columns[j] + "'" + (near.empty() ? "" : ", did you mean '" + near + "'?"));
  }
  if (csv.columns.size() < 2) reader.problems().add(file, header, "must have a column beside the first, such as notch");
}

void DriverSchedule::readLists(rail::YamlReader& reader, Sources& sources) const {
  bool any = reader.has("emergency_from");
  for (std::size_t channel = 0; channel < kChannels; ++channel) {
    if (!reader.has(listName(channel))) continue;
    any = true;
    sources[channel] = listSource(reader, channel);
  }
  if (reader.has("notches_table")) {
    if (sources[kNotch].given) reader.refuse("notches", "must not stand beside notches_table");
    const rail::CsvTable csv = rail::readCsv(reader.text("notches_table"), reader.file("notches_table"),
                                             {over_time_ ? "time_s" : "location_km", "notch"}, reader.problems());
    sources[kNotch] = makeCsvSource(reader, "notches_table", csv, 1);
  } else if (!any) {
    sources[kNotch] = listSource(reader, kNotch);
  }
}

/// Takes a channel's entries; speaks up about every one that breaks a rule, and counts them.
std::size_t DriverSchedule::take(std::size_t channel, const DriverSource& source, const Largest& largest) {
  const std::vector<std::vector<double>>& rows = source.rows;
  std::size_t faults = 0;
  const auto refuse = [&](std::size_t row, std::size_t cell, const std::string& rule) {
    source.refuse(row, cell, rule);
    ++faults;
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i > 0 && rows[i][0] <= rows[i - 1][0]) refuse(i, 0, "must be after the entry before it");
    const Entry entry{rows[i][0] * source.from_to_si, rows[i][1] * source.value_to_si};
    const std::string rule = valueRule(channel, entry.value, largest);
    if (!rule.empty()) refuse(i, 1, rule);
    channels_[channel].push_back(entry);
  }
  return faults;
}

/// Looks wherever either begins; an entry of both at once is the brake's fault.
void DriverSchedule::refuseBothNotches(const Sources& sources) const {
  const auto refuse = [&](std::size_t channel, std::size_t other, bool at_once) {
    for (std::size_t i = 0; i < channels_[channel].size(); ++i) {
      const Entry& entry = channels_[channel][i];
      const std::vector<Entry>& others = channels_[other];
      const bool same = std::any_of(others.begin(), others.end(), [&](const Entry& e) { return e.from == entry.from; });
      if (entry.value > 0.0 && value(other, entry.from, 0.0) > 0.0 && (at_once || !same))
        sources[channel].refuse(i, 1,
                                "must be 0 while " + std::string(columnName(other)) + " is " +
                                    allDigits(value(other, entry.from, 0.0)) + ": never both at once");
    }
  };
  refuse(kBrakeNotch, kNotch, true);
  refuse(kNotch, kBrakeNotch, false);
}

DriverSchedule DriverSchedule::read(rail::YamlReader& reader, const Largest& largest) {
  DriverSchedule schedule;
  schedule.over_time_ = reader.choice("over", {"time", "place"}) == "time";
  Sources sources;
  if (reader.has("table")) {
    schedule.readTable(reader, sources);
    for (std::size_t channel = 0; channel < kChannels; ++channel)
      reader.refuseKey(listName(channel), "must not stand beside table");
    reader.refuseKey("notches_table", "must not stand beside table");
  } else {
    schedule.readLists(reader, sources);
  }
  if (reader.has("emergency_from")) {
    schedule.emergency_from_ =
        reader.number("emergency_from", rail::anyNumber()) * (schedule.over_time_ ? 1.0 : rail::kMetresPerKilometre);
    if (!largest.air_brake) reader.refuse("emergency_from", std::string("must be left out, ") + kNoAirBrake);
  }
  for (DriverSource& source : sources) source.from_to_si = schedule.over_time_ ? 1.0 : rail::kMetresPerKilometre;
  sources[kPipe].value_to_si = kPascalsPerBar;
  schedule.takeAll(sources, largest);
  return schedule;
}

void DriverSchedule::takeAll(const Sources& sources, const Largest& largest) {
  std::size_t faults = 0;
  for (std::size_t channel = 0; channel < kChannels; ++channel) faults += take(channel, sources[channel], largest);
  if (faults == 0) refuseBothNotches(sources);
}

double DriverSchedule::where(rail::Nanoseconds t, double location_m) const {
  return over_time_ ? rail::toSeconds(t) + start_time_s_ : location_m;
}

double DriverSchedule::value(std::size_t channel, double at, double before) const {
  const std::vector<Entry>& entries = channels_[channel];
  const auto after = std::upper_bound(entries.begin(), entries.end(), at,
                                      [](double place, const Entry& entry) { return place < entry.from; });
  return after == entries.begin() ? before : (after - 1)->value;
}

DriverCommand DriverSchedule::at(rail::Nanoseconds t, double location_m) const {
  const double here = where(t, location_m);
  DriverCommand command;
  command.notch = static_cast<int>(value(kNotch, here, 0.0));
  command.brake_notch = static_cast<int>(value(kBrakeNotch, here, 0.0));
  command.pipe_pressure_Pa = value(kPipe, here, kChargedPipe_Pa);
  command.independent_brake = value(kIndependent, here, 0.0);
  command.sanding = value(kSanding, here, 0.0) > 0.0;
  command.emergency = here >= emergency_from_;
  return command;
}

}  // namespace ltd
