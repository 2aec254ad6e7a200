#pragma once

#include <cstdint>
#include <vector>

#include "ltd_sim/air_brake.hpp"
#include "ltd_sim/driver.hpp"
#include "ltd_sim/limit_watch.hpp"
#include "ltd_sim/loco_energy.hpp"
#include "ltd_sim/train_model.hpp"
#include "rail_core/energy_account.hpp"

namespace ltd {

/// What the results tell of the train at one moment. Copied in every step, so nothing large may be in it.
struct TrainSnapshot {
  std::uint64_t step = 0;                  ///< macro steps committed; the state is that at t = step H
  std::vector<double> s_m;                 ///< per vehicle: chainage of the CoG
  std::vector<double> v_mps;               ///< per vehicle
  std::vector<double> traction_N;          ///< per locomotive: mean traction over the last step
  std::vector<LocoEnergy> loco_energy;     ///< per locomotive
  std::vector<PowerSupply::State> supply;  ///< per locomotive
  rail::EnergyAccount account;             ///< stored energies: as of the last updateStoredEnergies()
};

/// Everything that changes during a run: copy it, and the run can go on from the copy.
struct TrainState : TrainSnapshot {
  std::vector<double> reference_N;  ///< per locomotive: traction reference, the motor response's memory; < 0: braking
  std::vector<std::vector<double>> loco_state;  ///< per locomotive: s_k of its model; empty before its first step
  Driver::State driver;
  AirBrake::State air;
  std::vector<rail::Nanoseconds> store_empty_at;  ///< per locomotive: first time that its store gave out; -1: never
  bool moved = false;                             ///< the train has been on its way
  rail::Nanoseconds standing_since = -1;          ///< at rest since then, having moved; -1: not
  rail::Nanoseconds slow_since = -1;              ///< traction on and below the stall speed since then; -1: not
  LimitWatch limit_watch;
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

}  // namespace ltd
