#include <algorithm>

#include "driver_sources.hpp"
#include "ltd_sim/csv_file.hpp"
#include "ltd_sim/driver_schedule.hpp"
#include "rail_core/constants.hpp"
#include "rail_core/message_number.hpp"

// A locomotive's event recorder as a driver.                                                                (V2)
//
// YAML `driver` with kind: recorder:
//   over: place           # or time
//   recording_file: x.csv # columns may be many; only those named below are read
//   columns: {location_km: km, notch: notch, brake_notch: db, pipe_bar: pressure, speed_kmph: v}
//   start_time_s: 43200   # over time: the recorder's time at the start of the run; 0 if absent
// Keys of `columns` say what a column is and its unit: time_s, location_km or location_m, notch, brake_notch, pipe_bar
// or pipe_kPa, independent_brake, sanding, speed_kmph or speed_mps; the values are the file's names.
//
// A standing locomotive goes on logging at one place. Over place the last of those rows holds there: it is the one with
// which the train left. A wait is thereby lost; `over: time` keeps it.

namespace ltd {

namespace {

/// What a column may be, with its unit.
struct Meaning {
  const char* key;
  double to_si;
};
constexpr Meaning kLocationKm{"location_km", rail::kMetresPerKilometre};
constexpr Meaning kLocationM{"location_m", 1.0};
constexpr Meaning kTime{"time_s", 1.0};
constexpr Meaning kPipeBar{"pipe_bar", kPascalsPerBar};
constexpr Meaning kPipe_kPa{"pipe_kPa", 1000.0};
constexpr Meaning kSpeedKmph{"speed_kmph", 1.0 / rail::kKmphPerMps};
constexpr Meaning kSpeedMps{"speed_mps", 1.0};

/// The one of these that is given, if any.
std::optional<Named> readOne(rail::YamlReader& columns, const std::vector<Meaning>& meanings) {
  std::optional<Named> named;
  for (const Meaning& meaning : meanings) {
    if (!columns.has(meaning.key)) continue;
    const std::string name = columns.text(meaning.key);
    if (named) columns.refuse(meaning.key, "must not stand beside " + std::string(meanings.front().key));
    named = {name, meaning.to_si};
  }
  return named;
}

/// Refuses a column of pipe pressures that cannot have the unit that its key says. @return true if it cannot
bool refusePipeUnit(const rail::CsvTable& csv, std::size_t column, double to_si, const std::string& file,
                    rail::Problems& problems) {
  // Chosen: a pipe that never has 0.2 bar is empty on the whole way, so that its train cannot have moved; the bars of
  // any brake pipe, over vacuum too, are below 20, and so is what any brake's reservoir has.
  constexpr double kLeast_kPa = 20.0, kMost_bar = 20.0;
  double largest = 0.0;
  for (const std::vector<double>& row : csv.rows) largest = std::max(largest, row[column]);
  std::string rule;
  if (to_si == kPipe_kPa.to_si && largest < kLeast_kPa)
    rule = "must be >= 20 kPa: are these bar? then the key is pipe_bar";
  else if (to_si == kPipeBar.to_si && largest > kMost_bar)
    rule = "must be <= 5 bar: are these kPa? then the key is pipe_kPa";
  if (!rule.empty()) problems.add(file, csv.columns[column], rail::messageNumber(largest), "the largest value " + rule);
  return !rule.empty();
}

/// Of rows at one place only the last is kept; a row further back is refused with its line.
rail::CsvTable lastRowsOfEachPlace(const rail::CsvTable& csv, const std::string& file, rail::Problems& problems) {
  rail::CsvTable kept;
  kept.columns = csv.columns;
  for (std::size_t i = 0; i < csv.rows.size(); ++i) {
    if (i > 0 && csv.rows[i][0] < csv.rows[i - 1][0])
      problems.add(file, "line " + std::to_string(csv.line_of_row[i]) + ": " + csv.columns[0],
                   allDigits(csv.rows[i][0]), "must not be behind the row before it");
    if (!kept.rows.empty() && csv.rows[i][0] == kept.rows.back()[0]) {
      kept.rows.pop_back();
      kept.line_of_row.pop_back();
    }
    kept.rows.push_back(csv.rows[i]);
    kept.line_of_row.push_back(csv.line_of_row[i]);
  }
  return kept;
}

}  // namespace

/// What the columns of a recording are called, and their units.
struct DriverSchedule::Recording {
  std::optional<Named> from;
  std::array<std::optional<Named>, kChannels> channels;
  std::optional<Named> speed;
};

DriverSchedule::Recording DriverSchedule::readColumns(rail::YamlReader map, bool over_time) {
  Recording recording;
  const std::optional<Named> place = readOne(map, {kLocationKm, kLocationM});
  const std::optional<Named> time = readOne(map, {kTime});
  recording.from = over_time ? time : place;
  if (!recording.from) map.refuse(over_time ? "time_s" : "location_km", "is missing: the column over which to drive");
  for (const std::size_t channel : {kNotch, kBrakeNotch, kIndependent, kSanding})
    recording.channels[channel] = readOne(map, {{columnName(channel), 1.0}});
  recording.channels[kPipe] = readOne(map, {kPipeBar, kPipe_kPa});
  recording.speed = readOne(map, {kSpeedKmph, kSpeedMps});
  map.finish();
  const auto& channels = recording.channels;
  if (std::none_of(channels.begin(), channels.end(), [](const auto& c) { return c.has_value(); }))
    map.refuse("", "must name the column of a command, such as notch");
  return recording;
}

void DriverSchedule::takeRecording(rail::YamlReader& reader, const Recording& recording, const Largest& largest) {
  std::vector<std::string> names{recording.from->name};
  for (const std::optional<Named>& channel : recording.channels)
    if (channel) names.push_back(channel->name);
  if (recording.speed) names.push_back(recording.speed->name);
  const std::string file = reader.file("recording");
  const std::size_t before = reader.problems().count();
  rail::CsvTable csv = rail::readCsvColumns(reader.text("recording"), file, names, reader.problems());
  if (!over_time_) csv = lastRowsOfEachPlace(csv, file, reader.problems());
  if (reader.problems().count() != before) return;
  Sources sources;
  std::size_t column = 1;
  for (std::size_t channel = 0; channel < kChannels; ++channel) {
    if (!recording.channels[channel]) continue;
    const double to_si = recording.channels[channel]->to_si;
    if (channel == kPipe && refusePipeUnit(csv, column, to_si, file, reader.problems())) return;
    sources[channel] = makeCsvSource(reader, "recording", csv, column++);
    sources[channel].from_to_si = recording.from->to_si;
    sources[channel].value_to_si = to_si;
  }
  takeAll(sources, largest);
  if (!recording.speed) return;
  for (const std::vector<double>& row : csv.rows)
    speeds_.push_back({row[0] * recording.from->to_si, row[column] * recording.speed->to_si});
}

DriverSchedule DriverSchedule::readRecorder(rail::YamlReader& reader, const Largest& largest) {
  DriverSchedule schedule;
  schedule.over_time_ = reader.choice("over", {"place", "time"}) == "time";
  if (schedule.over_time_)
    schedule.start_time_s_ = reader.numberOr("start_time_s", rail::anyNumber(), 0.0);
  else
    reader.refuseKey("start_time_s", "is of use with over: time only");
  const std::size_t before = reader.problems().count();
  const Recording recording = readColumns(reader.map("columns"), schedule.over_time_);
  if (reader.problems().count() == before)
    schedule.takeRecording(reader, recording, largest);
  else
    reader.ignore("recording");
  return schedule;
}

std::optional<double> DriverSchedule::recordedSpeed(rail::Nanoseconds t, double location_m) const {
  const double here = where(t, location_m);
  if (speeds_.empty() || here < speeds_.front().from || here > speeds_.back().from) return std::nullopt;
  const auto after = std::upper_bound(speeds_.begin(), speeds_.end(), here,
                                      [](double place, const Entry& entry) { return place < entry.from; });
  if (after == speeds_.end()) return speeds_.back().value;
  const Entry& last = *(after - 1);
  return last.value + (after->value - last.value) * (here - last.from) / (after->from - last.from);
}

}  // namespace ltd
