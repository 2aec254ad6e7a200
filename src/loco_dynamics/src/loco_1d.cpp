#include "loco_dynamics/loco_1d.hpp"

#include <algorithm>
#include <cassert>

#include "adhesion_control/torque_limit.hpp"
#include "loco_dynamics/shoe_brake.hpp"
#include "rail_core/constants.hpp"

namespace loco {

Loco1d::Loco1d(const Parameters& parameters)
    : parameters_(parameters),
      adhesion_limit_N_(parameters.adhesion_limit * parameters.mass_kg * rail::kGravity_mps2) {}

LocoStart Loco1d::equilibriumState(double location_m, double speed_mps) const { return {{location_m, speed_mps}, {}}; }

double computeAdhesionLimitedTraction(double reference_N, double adhesion_limit_N) {
  return std::clamp(reference_N, -adhesion_limit_N, adhesion_limit_N);  // (T8)
}

void Loco1d::step(const std::vector<double>& state, const LocoForce& force, LocoTraction& answer) {
  assert(state.size() == stateSize());
  const double H = rail::toSeconds(force.step_length);
  const double s = state[0];
  const double v = state[1];

  const double F_t =
      adhesion::fadeDynamicBrake(computeAdhesionLimitedTraction(force.traction_reference_N, adhesion_limit_N_), v);
  const double F_others = force.coupler_front_N + force.coupler_rear_N + F_t + force.propulsion_resistance_N +
                          force.curving_resistance_N + force.grade_N;
  const double stopping_N = F_others + parameters_.inertial_mass_kg * v / H;
  const double F_shoes = std::clamp(computeHoldingForce(stopping_N, force.shoe_force_N),  // (P3)
                                    -adhesion_limit_N_ - F_t, adhesion_limit_N_ - F_t);   // rim and rail: (T8) for both
  const double F = F_others + F_shoes;                                                    // Eq. (1)
  const bool stands = F_shoes == -stopping_N;  // exactly: F H/m would leave the last bit of v
  const double v_end = stands ? 0.0 : v + H * F / parameters_.inertial_mass_kg;  // (T5)
  const double s_end = s + H * v_end;

  answer.step = force.step;
  const double S = 0.5 * (v + v_end) * H;
  answer.traction_N = F_t + F_shoes;
  answer.speed_mps = v_end;
  answer.location_m = s_end;
  answer.work_rim_J = F_t * S;  // no slip: rim = rail, Eq. (4)
  answer.work_slip_J = 0.0;
  answer.work_shoes_J = -F_shoes * S;
  answer.state.resize(stateSize());
  answer.state[0] = s_end;
  answer.state[1] = v_end;
  answer.adhesion.axles.clear();  // no wheels
  answer.adhesion.contacts.clear();
  answer.failure.clear();
}

std::vector<BodyPose> Loco1d::computePoses(const std::vector<double>& state) const {
  BodyPose pose;
  pose.name = "car_body";
  pose.location_m = state[0];
  return {pose};
}

}  // namespace loco
