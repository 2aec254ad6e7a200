#pragma once

#include <functional>

#include "ltd_sim/brake_response.hpp"

namespace ltd {

/// What a driver knows of the train that he drives: its size, and what its notches and brakes give. All forces are
/// those of all locomotives or all shoes together, >= 0, at a speed along the track. Filled by whoever knows train and
/// brakes; a driver that follows a timetable plans with it, the others do not ask.
struct TrainAbility {
  bool known = true;         ///< false: train or brakes are faulty, so nothing may be measured by what follows
  double mass_kg = 0.0;      ///< inertial, the whole train
  double weight_N = 0.0;     ///< the whole train: what a grade pulls with
  double ahead_m = 0.0;      ///< from the leading locomotive's CoG to the train's head
  double behind_m = 0.0;     ///< from there to the train's tail
  double curving_N_m = 0.0;  ///< resistance in a curve times its radius, the whole train in it
  int notches = 0;           ///< of the lead group
  int brake_notches = 0;     ///< likewise; 0: no dynamic brake
  bool air_brake = true;     ///< false: there is none, and none may be commanded
  bool sand = true;          ///< false: sand would change nothing, and none may be commanded
  std::function<double(int notch, double v_mps)> traction_N;             ///< at the rail
  std::function<double(int brake_notch, double v_mps)> dynamic_brake_N;  ///< may be empty without brake notches
  std::function<double(double v_mps)> full_service_N;  ///< air brake after a full service reduction; empty: none
  double first_reduction_Pa = 0.4e5;                   ///< of the pipe, a smaller one applies nothing; chosen
  double full_service_reduction_Pa = 1.5e5;            ///< of the pipe, for full service; UIC 540: down to 3.5 bar
  double full_release_reduction_Pa = 0.15e5;           ///< of the pipe, a smaller one holds nothing; chosen
  BrakeResponse brake_response;                        ///< default: at once
  std::function<double(double v_mps)> resistance_N;    ///< on straight, level track; empty: none
};

class AirBrake;
struct TrainModel;

/// That of a train: traction and dynamic brake of all its locomotives on the same notch, each within its adhesion
/// limit; the shoes of all vehicles two minutes after a full service application.
TrainAbility computeAbility(const TrainModel& train, const AirBrake& air_brake);

}  // namespace ltd
