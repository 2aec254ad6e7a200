#pragma once

#include <memory>
#include <string>
#include <vector>

#include "adhesion_control/adhesion_controller.hpp"
#include "adhesion_control/pi_adhesion_controller.hpp"
#include "rail_core/yaml_reader.hpp"

namespace adhesion {

/// What a file in config/control/ says. Constant.
struct ControlParameters {
  std::string law;                      ///< one of knownLaws()
  double torque_lag_s = 0.0;            ///< tau of the motors, 0: none                              (A6)
  bool rim_power_limit = false;         ///< whether the locomotive applies limitRimPower()          (A8)
  PiAdhesionController::Parameters pi;  ///< law: pi
};

/// The laws that a control file may name: pi, none. To add your own: one row of the table in controller_factory.cpp,
/// and a member of ControlParameters for what its file says.
const std::vector<std::string>& knownLaws();

/// Reads and checks a control map: law, torque_lag_s, rim_power_limit, and the keys of the law. For pi: slip_limit,
/// proportional_gain_N_m, integral_gain_N_m_per_s, grouping (axle or bogie), sampling_period_s. Finishes the reader.
/// @param micro_step  h [ns]; <= 0 if it is not known, then nobody checks that it divides the sampling period
ControlParameters readController(rail::YamlReader reader, rail::Nanoseconds micro_step);

/// The controller of one locomotive. `parameters` must have been read without problems, with the same micro step.
std::unique_ptr<const AdhesionController> makeController(const ControlParameters& parameters, const Setup& setup);

}  // namespace adhesion
