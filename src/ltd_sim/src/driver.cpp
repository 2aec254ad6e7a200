#include "ltd_sim/driver.hpp"

#include <algorithm>
#include <cmath>

#include "ltd_sim/csv_file.hpp"
#include "rail_core/constants.hpp"
#include "rail_core/csv_table.hpp"

namespace ltd {

namespace {

constexpr const char* kLead = "lead";

}  // namespace

std::vector<Driver::Entry> Driver::readNotches(rail::YamlReader& reader, bool over_time, int largest_notch) {
  std::vector<std::vector<double>> rows;
  std::vector<int> lines;  // of the CSV; empty if the notches stand in the YAML
  const bool table = reader.has("notches_table");
  if (table) {
    const rail::CsvTable csv = rail::readCsv(reader.text("notches_table"), reader.file("notches_table"),
                                             {over_time ? "time_s" : "location_km", "notch"}, reader.problems());
    rows = csv.rows;
    lines = csv.line_of_row;
    if (reader.has("notches")) {
      reader.rows("notches", 2);
      reader.refuse("notches", "must not stand beside notches_table");
    }
  } else {
    rows = reader.rows("notches", 2);
    if (rows.empty() && reader.has("notches")) reader.refuse("notches", "must have at least one entry [from, notch]");
  }
  const auto refuse = [&](std::size_t row, std::size_t column, const std::string& rule) {
    if (!table) {
      reader.refuse("notches." + std::to_string(row) + "." + std::to_string(column), rule);
    } else {
      const std::string name = column == 1 ? "notch" : over_time ? "time_s" : "location_km";
      reader.problems().add(reader.file("notches_table"), "line " + std::to_string(lines[row]) + ": " + name,
                            allDigits(rows[row][column]), rule);
    }
  };
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double notch = rows[i][1];
    if (i > 0 && rows[i][0] <= rows[i - 1][0]) refuse(i, 0, "must be after the entry before it");
    if (notch != std::floor(notch) || notch < 0.0 || notch > largest_notch)
      refuse(i, 1, "must be a whole notch from 0 to " + std::to_string(largest_notch));
    entries.push_back({over_time ? rows[i][0] : rows[i][0] * rail::kMetresPerKilometre, static_cast<int>(notch)});
  }
  return entries;
}

Driver::Group Driver::readGroup(rail::YamlReader reader, int largest_notch) {
  Group group;
  group.largest_notch = largest_notch;
  group.fixed = reader.has("notch");
  if (group.fixed) {
    group.fixed_notch = reader.integer("notch", 0, largest_notch);
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

Driver Driver::read(rail::YamlReader reader, const std::vector<std::string>& groups,
                    const std::vector<int>& largest_notch) {
  Driver driver;
  driver.over_time_ = reader.choice("over", {"time", "place"}) == "time";
  const int largest = largest_notch.empty() ? 0 : *std::max_element(largest_notch.begin(), largest_notch.end());
  driver.entries_ = readNotches(reader, driver.over_time_, largest);
  rail::YamlReader map = reader.map("groups");
  for (std::size_t i = 0; i < groups.size(); ++i)
    driver.groups_.push_back(readGroup(map.map(groups[i]), largest_notch[i]));
  map.finish();
  reader.finish();
  return driver;
}

int Driver::leadNotch(rail::Nanoseconds t, double location_m) const {
  const double at = over_time_ ? rail::toSeconds(t) : location_m;
  const auto after = std::upper_bound(entries_.begin(), entries_.end(), at,
                                      [](double value, const Entry& entry) { return value < entry.from; });
  return after == entries_.begin() ? 0 : (after - 1)->notch;
}

void Driver::observe(rail::Nanoseconds t, double location_m, State& state) const {
  const int notch = leadNotch(t, location_m);
  if (state.empty() || state.back().notch != notch) state.push_back({t, notch});
}

int Driver::notch(std::size_t group, rail::Nanoseconds t, const State& state) const {
  const Group& g = groups_[group];
  if (g.fixed) return g.fixed_notch;
  int lead = 0;
  for (auto change = state.rbegin(); change != state.rend(); ++change) {
    if (change->time <= t - g.delay) {
      lead = change->notch;
      break;
    }
  }
  if (lead == 0) return 0;  // idle stays idle whatever the offset
  return std::clamp(lead + g.notch_offset, 0, g.largest_notch);
}

}  // namespace ltd
