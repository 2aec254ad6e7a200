#pragma once

#include <string>
#include <vector>

#include "loco_dynamics/exchange.hpp"
#include "ltd_sim/energy_booking.hpp"
#include "ltd_sim/train_state.hpp"
#include "rail_core/track.hpp"

namespace ltd {

/// Longitudinal train dynamics: every vehicle one degree of freedom, at its own place on the track.
///   m a = F_c1 + F_c2 + F_t + F_db + F_ab + F_pr + F_cr + F_G                                       (Eq. 1)
/// Integrated by semi-implicit Euler with the macro step H:                                          (T5)
///   v_k+1 = v_k + H F_k / m,   s_k+1 = s_k + H v_k+1
/// where F_t + F_db, of a locomotive also the part of F_ab that its own shoes make, is the locomotives' mean force over
/// the step as they answer it, and everything else is taken at t_k. In an emergency the traction is cut (chosen).
class TrainDynamics {
 public:
  /// Keeps references to its arguments.
  TrainDynamics(const TrainModel& train, const rail::Track& track, const Driver& driver, const AirBrake& air_brake,
                rail::Nanoseconds step);

  /// The train at rest in its couplers (mid-slack) with the leading locomotive's CoG at `location_m`, at `speed_mps`.
  TrainState initialState(double location_m, double speed_mps) const;

  /// All forces at t_k but the traction, which the locomotives answer: computeOuterForces(), then decide().
  void computeForces(TrainState& state, TrainForces& forces);
  /// What does not depend on the driver's word of this step, and what he sees.
  void computeOuterForces(const TrainState& state, TrainForces& forces);
  /// Lets the driver decide, which his state notes, and the motors follow.
  void decide(TrainState& state, TrainForces& forces) const;

  /// What locomotive i is told of this step.
  void fillLocoForce(std::size_t i, const TrainState& state, const TrainForces& forces, loco::LocoForce& out) const;

  /// Speeds at the end of the step with those very forces and the locomotives' answers. The state stays as it is, so
  /// a step that fails needs no copy to go back to.
  /// @return empty, or what became of which vehicle (a number that is none)
  std::string computeSpeeds(const TrainState& state, const TrainForces& forces,
                            const std::vector<const loco::LocoTraction*>& answers);
  /// Per vehicle, as computeSpeeds() left them.
  const std::vector<double>& nextSpeeds() const { return v_next_; }
  /// Advances to those speeds and books the energy. @pre computeSpeeds() with the same arguments found nothing wrong
  void advance(TrainState& state, const TrainForces& forces, const std::vector<const loco::LocoTraction*>& answers);

  /// Brings the stored energies of the account (kinetic, potential, couplers) up to the state.                 (T9)
  void updateStoredEnergies(TrainState& state) { booking_.updateStoredEnergies(state); }

  double leadingLocation(const TrainState& state) const { return state.s_m[train_.locomotives.front().vehicle]; }
  double leadingSpeed(const TrainState& state) const { return state.v_mps[train_.locomotives.front().vehicle]; }
  /// Vehicle whose CoG has left the track, from 0; -1 if all are on it.
  int vehicleOffTrack(const TrainState& state) const;

 private:
  void computeCouplerForces(const TrainState& state, TrainForces& forces) const;
  void computeTrackForces(const TrainState& state, TrainForces& forces);
  void fillView(const TrainState& state, TrainForces& forces) const;
  double respond(const LocoUnit& unit, double last_N, double target_N) const;
  double computeServedForce(std::size_t vehicle, double power_W, const TrainState& state,
                            const TrainForces& forces) const;
  void computeStepUse(TrainForces& forces) const;

  const TrainModel& train_;
  const rail::Track& track_;
  const Driver& driver_;
  const AirBrake& air_brake_;
  rail::Nanoseconds step_ns_;
  double H_;
  EnergyBooking booking_;
  std::vector<std::size_t> track_hint_;  ///< per vehicle
  std::vector<bool> is_locomotive_;      ///< per vehicle
  std::vector<double> traction_;         ///< scratch, per vehicle
  std::vector<double> v_next_;           ///< per vehicle
};

}  // namespace ltd
