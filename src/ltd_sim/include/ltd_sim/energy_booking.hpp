#pragma once

#include <cstddef>
#include <vector>

#include "ltd_sim/train_state.hpp"
#include "rail_core/track.hpp"

namespace ltd {

/// Keeps the energy account of a train: works of one step, and the energies that are stored. Work is force times the
/// mean of old and new speed times the step.                                                              (T7)
class EnergyBooking {
 public:
  /// Keeps references to its arguments.
  EnergyBooking(const TrainModel& train, const rail::Track& track, rail::Nanoseconds step);

  /// Books one step. @param v_old  per vehicle, before the step  @param state  after it, but for the account
  void bookStep(const std::vector<double>& v_old, const TrainForces& forces,
                const std::vector<const loco::LocoTraction*>& answers, TrainState& state) const;

  /// Brings the stored energies of the account (kinetic, potential, couplers) up to the state.                 (T9)
  void updateStoredEnergies(TrainState& state);

 private:
  void bookVehicle(std::size_t i, double v_old, double v_new, const TrainForces& forces,
                   rail::EnergyAccount& account) const;
  void bookCouplers(const std::vector<double>& v_old, const TrainForces& forces, TrainState& state) const;
  void bookLoco(std::size_t j, double v_old, const loco::LocoTraction& answer, const TrainForces& forces,
                TrainState& state) const;

  const TrainModel& train_;
  const rail::Track& track_;
  rail::Nanoseconds step_ns_;
  double H_;
  std::vector<std::size_t> track_hint_;  ///< per vehicle
};

}  // namespace ltd
