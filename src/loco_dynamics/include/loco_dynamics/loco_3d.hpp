#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "loco_dynamics/body_dynamics.hpp"
#include "loco_dynamics/loco_account.hpp"
#include "loco_dynamics/loco_structure.hpp"
#include "loco_dynamics/locomotive.hpp"
#include "loco_dynamics/running_safety.hpp"
#include "loco_dynamics/track_frames.hpp"
#include "loco_dynamics/traction_drive.hpp"
#include "loco_dynamics/wheelset_contact.hpp"

namespace loco {

/// The 3D locomotive of Wu et al. 2020, Sect. 3.4: nine bodies with all six motions (54 degrees of freedom) on curved,
/// canted track, up to three contacts a wheel. Bodies, suspension, drive as in the 2D locomotive. The curving
/// resistance is made in the contacts: LocoForce::curving_resistance_N must be 0. docs/loco_3d.md has the equations.
///
/// State: positions and velocities of the bodies, the yaw dampers' own displacements, the drive's state, how long each
/// wheel (left, right, from the front) has been in the air.
class Loco3d : public Locomotive {
 public:
  struct Parameters {
    LocoStructure structure;
    std::shared_ptr<const rail::Track> track;  ///< null: straight and level
    std::shared_ptr<const ContactFinder> finder;
    WheelsetContact::Parameters contact;
    RailConditions rail;
    adhesion::ControlParameters control;
    double adhesion_limit = 0.0;       ///< of the weight [-]
    rail::Nanoseconds micro_step = 0;  ///< h
    bool gravity_stiffness = true;     ///< forces act at the displaced points
    RunningSafety safety;
  };
  explicit Loco3d(const Parameters& parameters);

  std::size_t stateSize() const override;
  /// In quasi-static equilibrium at this place, straight or curved, running freely.
  LocoStart equilibriumState(double location_m, double speed_mps) const override;
  void step(const std::vector<double>& state, const LocoForce& force, LocoTraction& answer) override;
  std::vector<BodyPose> computePoses(const std::vector<double>& state) const override;

  using Account = LocoAccount;
  const Account& account() const { return account_; }

  /// At the start of the last micro step.
  const WheelsetContact::Contacts& contacts(std::size_t axle) const { return contacts_[axle]; }
  const BodyDynamics& dynamics() const { return dynamics_; }

  /// Forces and moments on all bodies at a state of unaccelerated running with velocities v along the track, without
  /// couplers and motors: what equilibriumState makes vanish. For tests and linearisation.
  BodyVector computeStaticLoads(const BodyState& state) const;

 private:
  using ContactsOfAxles = std::array<WheelsetContact::Contacts, BodyLayout::kAxles>;
  struct Scratch {  ///< forces on the bodies in a micro step, by origin
    BodyVector inner, outer, frame, loads;
  };
  void addOuterForces(const LocoForce& force, const TrackFrames& frames, const BodyVector& q, BodyVector& loads) const;
  void addContactForces(const LocoForce& force, double h);
  void addTurning(double h);
  std::string stepMicro(const LocoForce& force, double* control_state, double h, LocoTraction& answer);
  void book(const BodyVector& v_old, double h, LocoTraction& answer);
  Vector6 inertiaOf(std::size_t axle) const;
  std::string checkWheels(const BodyState& state, const TrackFrames& frames, const ContactsOfAxles& contacts, double h,
                          double* time_in_air_s) const;
  void report(AdhesionReport& out) const;
  WheelsetMotion motionOf(std::size_t axle, const BodyState& state, const TrackFrames& frames) const;
  Placement placement() const { return {&frames_.gaps(), parameters_.gravity_stiffness}; }
  BodyVector computeSteadyLoads(const BodyState& state, const TrackFrames& frames, double share = 1.0) const;
  BodyVector computeRest() const;
  bool onStraightTrack(const BodyState& state) const;
  void placeWheelsets(BodyState& state) const;
  std::string settleStep(BodyState& state, double share, double h, ContactsOfAxles& contacts,
                         double* time_in_air_s) const;
  std::string settle(BodyState& state, double speed_mps) const;
  std::string checkStanding(const BodyState& state, TrackFrames frames) const;
  std::vector<double> packStart(BodyState state) const;
  void followTrack(BodyState& state) const;
  BodyVector computeStaticLoads(const BodyState& state, TrackFrames frames) const;
  std::string relax(const TrackFrames& frames, BodyState& state) const;

  Parameters parameters_;
  mutable BodyDynamics dynamics_;
  WheelsetContact contact_;
  TractionDrive drive_;
  BodyState state_;
  TrackFrames frames_, next_frames_;
  Scratch scratch_;
  ContactsOfAxles contacts_;
  std::array<double, BodyLayout::kAxles> shoe_N_m_{};  ///< torque of the shoes on the wheelset
  Account account_;
};

}  // namespace loco
