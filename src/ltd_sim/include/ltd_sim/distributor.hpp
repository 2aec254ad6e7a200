#pragma once

#include "rail_core/yaml_reader.hpp"

namespace ltd {

/// A vehicle's valve between brake pipe and cylinder: what share of the full cylinder pressure the pipe asks for.
///   graduated  share = (p_charged - p)/(p_charged - p_full_service), 0..1; asked from `first reduction` on, given up
///              at `full release reduction`                                                             (B3)
///   direct     share = (p_r - p_a)/(p_charged - p_full_service),  p_a = max(p_low, p_r - (p_charged - p_full_service))
///              p_low is the lowest pressure since the application, p_r the reservoir's before it, p_a what it has
///              then: once the cylinder is full it falls no further, however far the pipe does. A rise over p_a
///              releases the brake altogether, and the reservoir is recharged from the pipe at a limited rate     (B4)
/// So with direct release a brake applied again too soon has less force. Not modelled: exhaustion with graduated
/// release.
class Distributor {
 public:
  struct Parameters {
    bool direct_release = false;
    double full_reduction_Pa = 0.0;            ///< of full service
    double first_reduction_Pa = 0.0;           ///< a smaller one applies no brake
    double full_release_reduction_Pa = 0.0;    ///< graduated: the brake is released at a smaller one
    double release_rise_Pa = 0.0;              ///< direct: a larger rise over the reservoir releases
    double reservoir_charging_Pa_per_s = 0.0;  ///< direct
  };
  struct State {
    bool applied = false;
    double reservoir_Pa = 0.0;  ///< direct: now, or before the application that lasts
    double lowest_Pa = 0.0;     ///< direct: of the pipe since the application
  };
  Distributor() = default;
  explicit Distributor(const Parameters& parameters) : p_(parameters) {}

  /// YAML `valve`: release (graduated, direct), first_reduction_bar, and full_release_reduction_bar or
  /// release_rise_bar, reservoir_charging_bar_per_s.
  static Distributor read(rail::YamlReader reader, double full_reduction_Pa, bool electronic);

  double firstReduction() const { return p_.first_reduction_Pa; }               ///< [Pa]
  double fullReleaseReduction() const { return p_.full_release_reduction_Pa; }  ///< [Pa], 0: direct release

  /// At rest with the pipe at this pressure, reached from the charged one.
  State initialState(double pipe_Pa) const;

  /// @param emergency  the emergency's wave has passed: applies without waiting for the first reduction
  /// @return share of the full cylinder pressure, 0..1
  double step(double pipe_Pa, bool emergency, double step_s, State& state) const;

 private:
  double stepGraduated(double pipe_Pa, bool emergency, State& state) const;
  double computeAppliedReservoir(const State& state) const;
  double stepDirect(double pipe_Pa, bool emergency, double step_s, State& state) const;

  Parameters p_;
};

}  // namespace ltd
