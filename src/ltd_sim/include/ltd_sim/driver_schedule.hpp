#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "ltd_sim/driver_command.hpp"
#include "rail_core/yaml_reader.hpp"

namespace ltd {

struct DriverSource;

/// Commands written down beforehand, each from a time or a place on until the next.                          (V1)
/// Before the first entry of a channel it stays as DriverCommand has it: idle, pipe charged, no sand.
///
/// YAML, lists of [from, value], from in s (`over: time`) or km of the leading locomotive (`over: place`):
///   notches, brake_notches, pipe_bar, independent_brake (share), sanding (0 or 1); and emergency_from: x
/// or `table_file: x.csv`, first column time_s or location_km, then any of notch, brake_notch, pipe_bar,
/// independent_brake, sanding; or `notches_table_file` with the columns of notches alone, in any order.
/// Refused: entries not in order, a notch and a brake notch at once, numbers beyond their range, commands to an air
/// brake or of sand that the scenario has not.
class DriverSchedule {
 public:
  /// The most that may be asked for.
  struct Largest {
    int notch = 0;
    int brake_notch = 0;
    bool air_brake = true;  ///< false: the pipe stays charged, no brake is applied
    bool sand = true;
  };

  /// Reads the keys above; the caller finishes the reader.
  static DriverSchedule read(rail::YamlReader& reader, const Largest& largest);

  /// Reads an event recorder's file, see driver_recorder.cpp for keys and rules.                             (V2)
  static DriverSchedule readRecorder(rail::YamlReader& reader, const Largest& largest);

  /// What is asked for at this time and place.
  DriverCommand at(rail::Nanoseconds t, double location_m) const;

  /// What a recorder's speed was there, between its rows linear; nothing outside them or without such a column.
  std::optional<double> recordedSpeed(rail::Nanoseconds t, double location_m) const;

 private:
  enum Channel : std::size_t { kNotch, kBrakeNotch, kPipe, kIndependent, kSanding, kChannels };
  struct Entry {
    double from = 0.0;   ///< [s] or [m]
    double value = 0.0;  ///< SI
  };
  using Sources = std::array<DriverSource, kChannels>;
  static const char* listName(std::size_t channel);
  static const char* columnName(std::size_t channel);
  static std::string valueRule(std::size_t channel, double value, const Largest& largest);
  static DriverSource listSource(rail::YamlReader& reader, std::size_t channel);
  void readTable(rail::YamlReader& reader, Sources& sources) const;
  void readLists(rail::YamlReader& reader, Sources& sources) const;
  struct Recording;
  static Recording readColumns(rail::YamlReader map, bool over_time);
  void takeRecording(rail::YamlReader& reader, const Recording& recording, const Largest& largest);
  void takeAll(const Sources& sources, const Largest& largest);
  std::size_t take(std::size_t channel, const DriverSource& source, const Largest& largest);
  void refuseBothNotches(const Sources& sources) const;
  double value(std::size_t channel, double at, double before) const;
  double where(rail::Nanoseconds t, double location_m) const;

  bool over_time_ = true;
  double start_time_s_ = 0.0;  ///< a recorder's time at the start of the run
  std::array<std::vector<Entry>, kChannels> channels_;
  std::vector<Entry> speeds_;
  double emergency_from_ = std::numeric_limits<double>::infinity();
};

}  // namespace ltd
