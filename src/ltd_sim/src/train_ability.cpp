#include "ltd_sim/train_ability.hpp"

#include <algorithm>
#include <memory>

#include "ltd_sim/air_brake.hpp"
#include "ltd_sim/resistance.hpp"
#include "ltd_sim/train_model.hpp"
#include "rail_core/constants.hpp"

namespace ltd {

namespace {

/// Brake two minutes after the pipe was set to full service: in every train the cylinders are full then.
AirBrake::State fullService(const AirBrake& air_brake) {
  constexpr rail::Nanoseconds kStep = rail::kNanosecondsPerSecond / 10;
  DriverCommand command;
  command.pipe_pressure_Pa = air_brake.fullServicePressure();
  AirBrake::State state = air_brake.initialState();
  for (int i = 0; i < 1200; ++i) air_brake.step(command, kStep, state);
  return state;
}

double adhesionLimit(const TrainModel& train, const LocoUnit& unit) {
  return unit.adhesion_limit * train.vehicles[unit.vehicle].mass_kg * rail::kGravity_mps2;
}

/// Sum over the locomotives of a force by type, within adhesion; a notch beyond a type's last counts as that.
template <typename Force>
double sumOver(const TrainModel& train, Force force) {
  double sum_N = 0.0;
  for (const LocoUnit& unit : train.locomotives) sum_N += std::min(force(unit.type), adhesionLimit(train, unit));
  return sum_N;
}

}  // namespace

TrainAbility computeAbility(const TrainModel& train_model, const AirBrake& air_brake) {
  const auto train = std::make_shared<const TrainModel>(train_model);
  const auto air = std::make_shared<const AirBrake>(air_brake);
  const auto applied = std::make_shared<const AirBrake::State>(fullService(air_brake));
  TrainAbility ability;
  ability.air_brake = air_brake.present();
  for (const double mass_kg : train->inertial_mass_kg) ability.mass_kg += mass_kg;
  if (train->locomotives.empty()) return ability;
  const LocoUnit& lead = train->locomotives.front();
  ability.ahead_m = 0.5 * train->vehicles.front().length_m;
  ability.behind_m = 0.5 * train->vehicles.back().length_m;
  for (std::size_t i = 0; i < train->coupler_distance_m.size(); ++i)
    (i < lead.vehicle ? ability.ahead_m : ability.behind_m) += train->coupler_distance_m[i];
  for (const rail::Vehicle& vehicle : train->vehicles) {
    ability.weight_N += vehicle.mass_kg * rail::kGravity_mps2;
    ability.curving_N_m += computeCurvingResistance(vehicle, 1.0);
  }
  ability.notches = train->traction[lead.type].notches();
  ability.brake_notches = train->dynamic_brakes[lead.type].notches();
  ability.traction_N = [train](int notch, double v_mps) {
    return sumOver(*train, [&](std::size_t type) {
      const TractionCharacteristic& traction = train->traction[type];
      return traction.computeForce(std::min(notch, traction.notches()), v_mps);
    });
  };
  ability.dynamic_brake_N = [train](int notch, double v_mps) {
    return sumOver(*train, [&](std::size_t type) {
      const DynamicBrake& brake = train->dynamic_brakes[type];
      return brake.computeForce(std::min(notch, brake.notches()), v_mps);
    });
  };
  if (air->present()) {
    ability.first_reduction_Pa = air->firstReduction();
    ability.full_release_reduction_Pa = air->fullReleaseReduction();
    ability.brake_response = computeBrakeResponse(*train, *air);
    ability.full_service_reduction_Pa = kChargedPipe_Pa - air->fullServicePressure();
    ability.full_service_N = [train, air, applied](double v_mps) {
      double sum_N = 0.0;
      for (std::size_t i = 0; i < train->vehicles.size(); ++i) sum_N += air->shoeForce(i, v_mps, *applied);
      return sum_N;
    };
  }
  ability.resistance_N = [train](double v_mps) {
    double sum_N = 0.0;
    for (const rail::Vehicle& vehicle : train->vehicles) sum_N += computePropulsionResistance(vehicle, v_mps);
    return sum_N;
  };
  return ability;
}

}  // namespace ltd
