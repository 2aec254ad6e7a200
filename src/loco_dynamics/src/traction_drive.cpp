#include "loco_dynamics/traction_drive.hpp"

namespace loco {

namespace {

adhesion::Setup controllerSetup(const LocoStructure& structure, rail::Nanoseconds micro_step) {
  adhesion::Setup setup;
  setup.micro_step = micro_step;
  setup.wheel_radius_m = structure.wheel_radius_m;
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle)
    setup.bogie_of_axle.push_back(axle / BodyLayout::kAxlesPerBogie);
  return setup;
}

}  // namespace

TractionDrive::TractionDrive(const LocoStructure& structure, const adhesion::ControlParameters& control,
                             double adhesion_limit, rail::Nanoseconds micro_step)
    : reaction_(structure.motor_reaction),
      controller_(adhesion::makeController(control, controllerSetup(structure, micro_step))),
      limit_{structure.wheel_radius_m, structure.totalMass(), static_cast<int>(BodyLayout::kAxles), adhesion_limit},
      rim_power_limit_(control.rim_power_limit),
      measurements_(BodyLayout::kAxles),
      commands_(BodyLayout::kAxles) {
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    const double d = structure.motor_nose_x_m[axle];
    const double axle_x_m = structure.bodies[BodyLayout::wheelset(axle)].p_T.x();
    noses_[axle] = {d, axle_x_m + d - structure.bodies[BodyLayout::bogieOfAxle(axle)].p_T.x()};
  }
}

void TractionDrive::addTorques(const LocoForce& force, const BodyVector& v, double* state, BodyVector& loads) {
  const double reference_N_m = adhesion::computeTorqueReference(limit_, force.traction_reference_N);
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    const double omega = v[BodyLayout::wheelset(axle)][kPitch];
    measurements_[axle].omega_radps = omega;
    const double limited_N_m = rim_power_limit_
                                   ? adhesion::limitRimPower(limit_, reference_N_m, omega, force.rim_power_limit_W)
                                   : reference_N_m;
    measurements_[axle].torque_reference_N_m = adhesion::fadeDynamicBrake(limited_N_m, omega * limit_.wheel_radius_m);
  }
  controller_->step(force.speed_mps, measurements_, state, commands_);
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    const double T = commands_[axle].torque_N_m;
    auto& wheelset = loads[BodyLayout::wheelset(axle)];
    auto& frame = loads[BodyLayout::bogieOfAxle(axle)];
    wheelset[kPitch] += T;
    if (reaction_ == MotorReaction::kCouple) {
      frame[kPitch] -= T;
      continue;
    }
    const Nose& nose = noses_[axle];  // (M1)
    wheelset[kZ] -= T / nose.x_axle_m;
    addForce(frame, {0.0, 0.0, T / nose.x_axle_m}, {nose.x_frame_m, 0.0, 0.0});
  }
}

double TractionDrive::housingSpeed(const BodyVector& v, std::size_t axle) const {
  const auto& frame = v[BodyLayout::bogieOfAxle(axle)];
  if (reaction_ == MotorReaction::kCouple) return frame[kPitch];
  const double nose_mps = frame[kZ] - frame[kPitch] * noses_[axle].x_frame_m;
  return -(nose_mps - v[BodyLayout::wheelset(axle)][kZ]) / noses_[axle].x_axle_m;
}

TractionDrive::Work TractionDrive::computeWork(const BodyVector& v_mean, double h) const {
  Work work;
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    const double omega = v_mean[BodyLayout::wheelset(axle)][kPitch];
    work.rims += commands_[axle].torque_N_m * omega * h;
    work.motors += commands_[axle].torque_N_m * (omega - housingSpeed(v_mean, axle)) * h;
  }
  return work;
}

}  // namespace loco
