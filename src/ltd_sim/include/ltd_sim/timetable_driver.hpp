#pragma once

#include <string>
#include <vector>

#include "ltd_sim/driver_command.hpp"
#include "ltd_sim/train_ability.hpp"
#include "rail_core/track.hpp"
#include "rail_core/yaml_reader.hpp"

namespace ltd {

/// A driver who keeps speed limits and a timetable, looking ahead.
class TimetableDriver {
 public:
  /// What he remembers.
  struct State {
    std::vector<std::string> notes;  ///< late arrivals and the like, in order
  };

  /// Reads the map's keys; the caller finishes the reader.
  static TimetableDriver read(rail::YamlReader& reader, const rail::Track& track, const TrainAbility& ability);

  void command(const DriverView& view, State& state, DriverCommand& lead) const;
};

}  // namespace ltd
