#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "loco_dynamics/exchange.hpp"
#include "ltd_sim/air_brake.hpp"
#include "ltd_sim/driver.hpp"
#include "ltd_sim/limit_watch.hpp"
#include "ltd_sim/train_model.hpp"
#include "rail_core/energy_account.hpp"
#include "rail_core/track.hpp"

namespace ltd {

/// Energies of one locomotive since the start of the run [J].
struct LocoEnergy {
  double rail = 0.0;           ///< Eq. (4), sum of F_t S, while it does not brake
  double rim = 0.0;            ///< work at the wheel rims, what the driving motors pay
  double slip = 0.0;           ///< lost between rim and rail to slip, driving and braking
  double brake_rail = 0.0;     ///< taken at the rail by its brakes, motors and shoes together
  double recovered_rim = 0.0;  ///< at the wheel rims, what the braking motors get
  double shoes = 0.0;          ///< heat in its brake shoes
};

/// Everything that changes during a run: copy it, and the run can go on from the copy.
struct TrainState {
  std::uint64_t step = 0;           ///< macro steps committed; the state is that at t = step H
  std::vector<double> s_m;          ///< per vehicle: chainage of the CoG
  std::vector<double> v_mps;        ///< per vehicle
  std::vector<double> reference_N;  ///< per locomotive: traction reference, the motor response's memory; < 0: braking
  std::vector<double> traction_N;   ///< per locomotive: mean traction over the last step
  std::vector<LocoEnergy> loco_energy;          ///< per locomotive
  std::vector<std::vector<double>> loco_state;  ///< per locomotive: s_k of its model; empty before its first step
  Driver::State driver;
  AirBrake::State air;
  std::vector<PowerSupply::State> supply;         ///< per locomotive
  std::vector<rail::Nanoseconds> store_empty_at;  ///< per locomotive: first time that its store gave out; -1: never
  bool moved = false;                             ///< the train has been on its way
  rail::Nanoseconds standing_since = -1;          ///< at rest since then, having moved; -1: not
  rail::Nanoseconds slow_since = -1;              ///< traction on and below the stall speed since then; -1: not
  LimitWatch limit_watch;
  rail::EnergyAccount account;  ///< stored energies: as of the last updateStoredEnergies()
};

/// The forces of one step, all at t_k.
struct TrainForces {
  std::vector<Coupler::Force> coupler;    ///< per coupler, + tension
  std::vector<double> grade_N;            ///< per vehicle, + forward
  std::vector<double> propulsion_N;       ///< per vehicle, + forward: Eq. (5) with stiction
  std::vector<double> curving_N;          ///< per vehicle, + forward: Eq. (6) with stiction
  std::vector<double> air_brake_N;        ///< per vehicle, + forward: shoes with stiction; 0 for locomotives, whose own
                                          ///< model has them
  std::vector<double> shoe_N;             ///< per vehicle: largest force that the shoes can hold against, >= 0
  DriverView view;                        ///< what the driver saw
  std::vector<int> notch;                 ///< per locomotive
  std::vector<int> brake_notch;           ///< per locomotive
  std::vector<double> reference_N;        ///< per locomotive: traction reference of this step, < 0: dynamic brake
  std::vector<double> rim_power_limit_W;  ///< per locomotive
  double step_use = 0.0;                  ///< share of the couplers' stability limit that this step uses, see (T6)
  std::size_t step_use_vehicle = 0;       ///< where
};

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

  /// Advances by one step with those very forces and the locomotives' answers, and books the energy.
  /// @return empty, or what became of which vehicle (a number that is none)
  std::string step(TrainState& state, const TrainForces& forces, const std::vector<const loco::LocoTraction*>& answers);

  /// Brings the stored energies of the account (kinetic, potential, couplers) up to the state.                 (T9)
  void updateStoredEnergies(TrainState& state);

  double leadingLocation(const TrainState& state) const { return state.s_m[train_.locomotives.front().vehicle]; }
  double leadingSpeed(const TrainState& state) const { return state.v_mps[train_.locomotives.front().vehicle]; }
  /// Vehicle whose CoG has left the track, from 0; -1 if all are on it.
  int vehicleOffTrack(const TrainState& state) const;

 private:
  void computeCouplerForces(const TrainState& state, TrainForces& forces) const;
  void computeTrackForces(const TrainState& state, TrainForces& forces);
  void fillView(const TrainState& state, TrainForces& forces) const;
  double respond(const LocoUnit& unit, double last_N, double target_N) const;
  void bookLoco(std::size_t j, const loco::LocoTraction& answer, const TrainForces& forces, TrainState& state) const;
  void computeStepUse(TrainForces& forces) const;
  void bookVehicle(std::size_t i, double v_old, double v_new, const TrainForces& forces, rail::EnergyAccount& a) const;
  void bookCouplers(const TrainState& state, const TrainForces& forces, rail::EnergyAccount& account) const;
  double couplerElongation(std::size_t i, const TrainState& state) const {
    return state.s_m[i] - state.s_m[i + 1] - train_.coupler_distance_m[i];
  }

  const TrainModel& train_;
  const rail::Track& track_;
  const Driver& driver_;
  const AirBrake& air_brake_;
  rail::Nanoseconds step_ns_;
  double H_;
  std::vector<std::size_t> track_hint_;  ///< per vehicle
  std::vector<bool> is_locomotive_;      ///< per vehicle
  std::vector<double> traction_;         ///< scratch, per vehicle
  std::vector<double> v_old_;            ///< scratch, per vehicle
};

}  // namespace ltd
