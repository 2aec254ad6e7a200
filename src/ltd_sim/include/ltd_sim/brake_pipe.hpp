#pragma once

#include <cstddef>
#include <vector>

#include "ltd_sim/driver_command.hpp"
#include "rail_core/yaml_reader.hpp"

namespace ltd {

/// The brake pipe: the driver's valve, the waves that run along the pipe, and recharging.
///   the valve's pressure p_v goes to what is asked for, at limited rates of exhaust and charging             (B1)
///   p_i <= p_v(t - tau_i) falls at once, rises at r/(1 + d_i/L) at most; tau_i = min over valves (delay + d/c)  (B2)
/// with d the distance along the train and c the speed of service or of emergency: after an emergency command p_i is
/// the lower of the two waves. `remote valves` repeat the driver's valve on the first locomotive of each further notch
/// group. Electronic control: all vehicles are told the asked pressure at once, after one delay; p_i is that signal,
/// the pipe itself stays charged. Not modelled: the wave's flattening, leakage, flow between vehicles, the pipe's
/// bends.
class BrakePipe {
 public:
  struct Parameters {
    bool electronic = false;
    double full_service_Pa = 0.0;
    double service_exhaust_Pa_per_s = 0.0;
    double emergency_exhaust_Pa_per_s = 0.0;
    double charging_Pa_per_s = 0.0;  ///< r, at the valve
    double charging_length_m = 0.0;  ///< L: so far from a valve the pipe is recharged half as fast
    double service_wave_mps = 0.0;
    double emergency_wave_mps = 0.0;
    bool remote_valves = false;
    double delay_s = 0.0;  ///< of the remote valves; electronic: of all vehicles
  };

  struct State {
    double valve_Pa = kChargedPipe_Pa;  ///< at the driver's valve
    std::vector<double> pipe_Pa;        ///< per vehicle
    std::vector<char> emergency;        ///< per vehicle: the emergency's wave is here
    /// The driver's valve in the past, one sample a step, as a ring: what travels as service and as emergency.
    struct Sample {
      double service_Pa = kChargedPipe_Pa;
      double emergency_Pa = kChargedPipe_Pa;
    };
    std::vector<Sample> history;  ///< sized in the first step, whose length holds for all
    std::size_t newest = 0;       ///< index in history
    std::size_t steps_since_emergency = 0;
  };

  BrakePipe() = default;
  /// @param place_m   of each vehicle, backwards from the driver's valve; < 0 before it
  /// @param remote_m  places of the remote valves
  BrakePipe(const Parameters& parameters, const std::vector<double>& place_m, const std::vector<double>& remote_m);

  /// YAML `pipe`: full_service_bar, and if electronic delay_s, otherwise service_exhaust_bar_per_s,
  /// emergency_exhaust_bar_per_s, charging_bar_per_s, charging_length_m, service_wave_mps, emergency_wave_mps,
  /// remote_valves and, if true, remote_delay_s.
  static Parameters read(rail::YamlReader reader, bool electronic);

  /// At rest with this pressure everywhere.
  State initialState(double pressure_Pa) const;

  /// Advances by one step with the command held. @return false if no vehicle's pressure and not the valve's changed
  bool step(const DriverCommand& command, double step_s, State& state) const;

  const Parameters& parameters() const { return p_; }

 private:
  struct Place {
    double service_delay_s = 0.0;
    double emergency_delay_s = 0.0;
    double charging_Pa_per_s = 0.0;
  };
  bool stepValve(const DriverCommand& command, double step_s, State& state) const;

  Parameters p_;
  std::vector<Place> places_;  ///< per vehicle
  double longest_delay_s_ = 0.0;
};

}  // namespace ltd
