#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ltd_sim/driver_command.hpp"
#include "ltd_sim/driver_schedule.hpp"
#include "ltd_sim/timetable_driver.hpp"
#include "ltd_sim/train_ability.hpp"
#include "rail_core/sim_time.hpp"
#include "rail_core/track.hpp"
#include "rail_core/yaml_reader.hpp"

namespace ltd {

/// A driver in another program: when he is asked, and what is done if he keeps silent.                        (V8)
struct ExternalDriver {
  rail::Nanoseconds period = 0;    ///< asked at t = n period; a whole multiple of the macro step
  double answer_deadline_s = 0.0;  ///< wall time
  DriverCommand on_silence;        ///< traction is off in it
};

/// The driver: what he commands, and what becomes of it in every notch group of locomotives. Constant; what he
/// remembers is his State.
///
/// YAML `driver`:
///   kind: schedule        # if absent; or recorder, timetable, external: docs/drivers.md
///   ...                   # keys of the kind: DriverSchedule, TimetableDriver, ExternalDriver
///   groups:                # every notch group of the train by its name
///     lead: {follows: lead}                                  # the lead's notches, at once
///     remote: {follows: lead, delay_s: 2.0, notch_offset: -1}  # later and a notch lower, never below 0
///     dead: {notch: 0}                                       # fixed; or {brake_notch: 3}
class Driver {
 public:
  /// What a driver remembers. Copyable; a run resumed from a copy goes on with the same bits.
  struct State {
    /// A change of the lead's notches: what delayed groups look back to.
    struct Change {
      rail::Nanoseconds time = 0;
      int notch = 0;
      int brake_notch = 0;
    };
    /// In order; what lies before the longest delay of all groups is forgotten, but for the last of it.
    std::vector<Change> changes;
    DriverCommand lead;                ///< in force
    DriverCommand given;               ///< external: the answer to the last question
    TimetableDriver::State timetable;  ///< with the notes of a timetable driver
  };

  /// @param groups  names of the train's notch groups, in the order in which commands are asked for
  /// @param largest_notch, largest_brake_notch  per group: the smallest number of notches of its locomotives
  /// @param ability  what the train can do; only a timetable driver needs it
  static Driver read(rail::YamlReader reader, const std::vector<std::string>& groups,
                     const std::vector<int>& largest_notch, const std::vector<int>& largest_brake_notch,
                     rail::Nanoseconds macro_step, const rail::Track& track, const TrainAbility& ability = {});

  /// Decides at t_k; call once per macro step, before lead() and groupCommand().
  void command(const DriverView& view, State& state) const;

  /// What the lead locomotives and the brake pipe are told.
  const DriverCommand& lead(const State& state) const { return state.lead; }

  /// What a group's locomotives are told at time t. Delay and fixed notch change notch and brake notch, the offset the
  /// notch alone; air, sand and emergency are the lead's, at once: the pipe carries them.                    (V3)
  DriverCommand groupCommand(std::size_t group, rail::Nanoseconds t, const State& state) const;

  /// Set if the driver is in another program.
  const std::optional<ExternalDriver>& external() const { return external_; }
  /// External: true if the answer for the step at t must be given before command().
  bool asksAt(rail::Nanoseconds t) const { return external_ && t % external_->period == 0; }
  /// External: takes the answer for the step at which it asked. @return empty, or why it is refused
  std::string give(const DriverCommand& answer, State& state) const;
  /// External: no answer came in time.
  void giveSilence(State& state) const { state.given = external_->on_silence; }

  /// Timetable: true if there are points ahead, so that a train at rest is to move again.
  bool goesOn(const State& state) const { return timetable_ && timetable_->goesOn(state.timetable); }

  /// What happened on the way that a reader of the results should know, in order.
  const std::vector<std::string>& notes(const State& state) const { return state.timetable.notes; }

  /// Recorder: the recorded speed there, for comparison.
  std::optional<double> recordedSpeed(const DriverView& view) const {
    return schedule_ ? schedule_->recordedSpeed(view.t, view.location_m) : std::nullopt;
  }

 private:
  struct Group {
    bool fixed = false;
    int fixed_notch = 0;
    int fixed_brake_notch = 0;
    rail::Nanoseconds delay = 0;
    int notch_offset = 0;
    int largest_notch = 0;
    int largest_brake_notch = 0;
  };
  static Group readGroup(rail::YamlReader reader, int largest_notch, int largest_brake_notch);
  void remember(rail::Nanoseconds t, State& state) const;
  static ExternalDriver readExternal(rail::YamlReader& reader, rail::Nanoseconds macro_step,
                                     const DriverSchedule::Largest& largest);

  std::optional<DriverSchedule> schedule_;
  std::shared_ptr<const TimetableDriver> timetable_;  ///< constant, so copies of the driver share it
  std::optional<ExternalDriver> external_;
  DriverSchedule::Largest largest_;
  std::vector<Group> groups_;
  rail::Nanoseconds longest_delay_ = 0;  ///< of all groups
};

}  // namespace ltd
