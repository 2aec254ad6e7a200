#pragma once

#include <array>
#include <memory>
#include <vector>

#include "adhesion_control/controller_factory.hpp"
#include "adhesion_control/torque_limit.hpp"
#include "loco_dynamics/body_layout.hpp"
#include "loco_dynamics/exchange.hpp"
#include "loco_dynamics/loco_structure.hpp"

namespace loco {

/// Motors and adhesion control of a locomotive with bodies: from LTD's traction reference to a torque T on each
/// wheelset and its reaction: a couple -T on the bogie frame or, if a motor hangs on its axle and has its nose on the
/// frame at d from it, vertical forces                                                                      (M1)
///   T/d on the frame at the nose, -T/d on the wheelset
/// Constant but for what the axles did last; its state is in the caller's hands. Not modelled: the motors' own mass
/// moving apart from the frame.
class TractionDrive {
 public:
  TractionDrive(const LocoStructure& structure, const adhesion::ControlParameters& control, double adhesion_limit,
                rail::Nanoseconds micro_step);

  std::size_t stateSize() const { return controller_->stateSize(); }
  std::vector<double> initialState() const { return controller_->initialState(); }

  /// Takes one micro step of the controller and adds the torques to the loads.
  /// @param v      velocities at the start of the micro step
  /// @param state  of stateSize(); becomes that at the end of the micro step
  void addTorques(const LocoForce& force, const BodyVector& v, double* state, BodyVector& loads);

  /// Of the last micro step, per axle from the front; torques on the wheelset.
  double torque_N_m(std::size_t axle) const { return commands_[axle].torque_N_m; }
  double torqueReference_N_m(std::size_t axle) const { return measurements_[axle].torque_reference_N_m; }
  bool controlled(std::size_t axle) const { return commands_[axle].active; }

  /// Work of all torques in the step just taken, with the means of its velocities [J].
  struct Work {
    double rims = 0.0;    ///< at the wheels' rims: torque times spin of the wheelset
    double motors = 0.0;  ///< of the motors: torque times spin of the wheelset against the housing
  };
  Work computeWork(const BodyVector& v_mean, double h) const;

  /// Speed at which a motor's housing turns, + as a wheel that rolls forward [rad/s].
  double housingSpeed(const BodyVector& v, std::size_t axle) const;

 private:
  struct Nose {
    double x_axle_m = 0.0;   ///< d: from the axle
    double x_frame_m = 0.0;  ///< from the frame's CoG
  };
  MotorReaction reaction_;
  std::array<Nose, BodyLayout::kAxles> noses_{};
  std::unique_ptr<const adhesion::AdhesionController> controller_;
  adhesion::TorqueLimit limit_;
  bool rim_power_limit_;
  std::vector<adhesion::AxleMeasurement> measurements_;
  std::vector<adhesion::AxleCommand> commands_;
};

}  // namespace loco
