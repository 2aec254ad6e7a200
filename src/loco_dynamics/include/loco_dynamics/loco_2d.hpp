#pragma once

#include <array>
#include <vector>

#include "loco_dynamics/body_dynamics.hpp"
#include "loco_dynamics/loco_account.hpp"
#include "loco_dynamics/loco_structure.hpp"
#include "loco_dynamics/locomotive.hpp"
#include "loco_dynamics/planar_contact.hpp"
#include "loco_dynamics/traction_drive.hpp"

namespace loco {

/// The 2D locomotive of Wu et al. 2020, Sect. 3.3: nine bodies with longitudinal, bounce and pitch motion (27 degrees
/// of freedom), wheelsets in the middle of the track, adhesion control. What acts where: couplers on the car body at
/// their height, propulsion and curving resistance at the car body's CoG, the grade's force on every body by its mass,
/// the motors' torque on the wheelset and its reaction on the bogie frame (TractionDrive).
///
/// State: positions and velocities of the bodies, the yaw dampers' own displacements, the controller's state.
class Loco2d : public Locomotive {
 public:
  struct Parameters {
    LocoStructure structure;
    PlanarContact::Parameters contact;
    RailConditions rail;
    adhesion::ControlParameters control;
    double adhesion_limit = 0.0;       ///< of the weight [-]
    rail::Nanoseconds micro_step = 0;  ///< h
  };
  explicit Loco2d(const Parameters& parameters);

  std::size_t stateSize() const override;
  LocoStart equilibriumState(double location_m, double speed_mps) const override;
  void step(const std::vector<double>& state, const LocoForce& force, LocoTraction& answer) override;
  std::vector<BodyPose> computePoses(const std::vector<double>& state) const override;

  using Account = LocoAccount;
  const Account& account() const { return account_; }

 private:
  BodyVector computeEquilibrium() const;
  void addOuterForces(const LocoForce& force, BodyVector& loads) const;
  void addContactForces(const LocoForce& force, double h, BodyVector& loads);
  double storedEnergy() const;
  void book(const LocoForce& force, const BodyVector& v_old, double h, LocoTraction& answer);
  void report(AdhesionReport& out) const;

  Parameters parameters_;
  mutable BodyDynamics dynamics_;
  PlanarContact contact_;
  TractionDrive drive_;
  BodyState state_;
  struct Axle {
    PlanarContact::AxleForce contact;
    double normal_N = 0.0;          ///< of a wheel
    double damping_normal_N = 0.0;  ///< its part from damping
    double force_N = 0.0;           ///< of both wheels, + forward
    double slip_mps = 0.0;          ///< w = omega r - v
    double slip_power_W = 0.0;      ///< with the mean of the old and the new slip
    double v_mps = 0.0;
    double shoe_N_m = 0.0;  ///< torque of the shoes on the wheelset
  };
  std::array<Axle, BodyLayout::kAxles> axles_;  ///< in the last micro step
  Account account_;
};

}  // namespace loco
