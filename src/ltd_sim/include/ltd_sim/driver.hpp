#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rail_core/sim_time.hpp"
#include "rail_core/yaml_reader.hpp"

namespace ltd {

/// The driver: the notch of every notch group of locomotives.
///
/// YAML `driver`:
///   over: time            # or place
///   notches: [[0, 1], [10, 2], ...]     # from this time [s] or place [km, leading locomotive] on this notch
///   (or `notches_table_file: x.csv` with columns time_s, notch or location_km, notch)
///   groups:                # every notch group of the train by its name
///     lead: {follows: lead}                                  # the notches above, at once
///     remote: {follows: lead, delay_s: 2.0, notch_offset: -1}  # later and a notch lower, never below 0
///     dead: {notch: 0}                                       # fixed
/// Before the first entry the notch is 0.
class Driver {
 public:
  /// A change of the lead notch: what delayed groups look back to. Part of the train's state.
  struct Change {
    rail::Nanoseconds time = 0;
    int notch = 0;
  };
  using State = std::vector<Change>;

  /// @param groups  names of the train's notch groups, in the order in which notches are returned
  /// @param largest_notch  per group: the smallest number of notches of its locomotives
  static Driver read(rail::YamlReader reader, const std::vector<std::string>& groups,
                     const std::vector<int>& largest_notch);

  /// Notes the lead notch at time t and place; call once per macro step, before notch().
  void observe(rail::Nanoseconds t, double location_m, State& state) const;

  /// Notch of a group at time t.
  int notch(std::size_t group, rail::Nanoseconds t, const State& state) const;

 private:
  struct Entry {
    double from = 0.0;  ///< [s] or [m]
    int notch = 0;
  };
  struct Group {
    bool fixed = false;
    int fixed_notch = 0;
    rail::Nanoseconds delay = 0;
    int notch_offset = 0;
    int largest_notch = 0;
  };
  int leadNotch(rail::Nanoseconds t, double location_m) const;
  static std::vector<Entry> readNotches(rail::YamlReader& reader, bool over_time, int largest_notch);
  static Group readGroup(rail::YamlReader reader, int largest_notch);

  bool over_time_ = true;
  std::vector<Entry> entries_;
  std::vector<Group> groups_;
};

}  // namespace ltd
