#pragma once

#include <string>
#include <vector>

#include "loco_dynamics/body_layout.hpp"
#include "loco_dynamics/locomotive.hpp"
#include "loco_dynamics/suspension.hpp"

namespace loco {

/// Positions and velocities of all bodies and what else of the suspension has a state. Copyable; its flat form travels
/// in messages. Positions along the track are chainages of the locomotive's centre as each body sees it: a body's
/// chainage less its nominal place, so bodies at rest in their places have one and the same x.
struct BodyState {
  BodyVector q{};                  ///< [m, rad]
  BodyVector v{};                  ///< [m/s, rad/s]
  std::vector<double> damper_x_m;  ///< per yaw damper
};

/// Equations of motion of a locomotive's bodies with a layout's degrees of freedom, and their integration by
/// semi-implicit Euler: (I1)
///   v_n+1 = v_n + h loads / inertia,   q_n+1 = q_n + h v_n+1
/// Constant but for scratch memory.
class BodyDynamics {
 public:
  BodyDynamics(BodyLayout layout, Suspension suspension);

  const BodyLayout& layout() const { return layout_; }
  const Suspension& suspension() const { return suspension_; }

  std::size_t stateSize() const { return 2 * layout_.size() + suspension_.yaw_dampers.size(); }
  void pack(const BodyState& state, double* out) const;
  void unpack(const double* in, BodyState& state) const;
  /// Positions in static equilibrium, from which poses and implausible offsets count; 0 until it is set. Springs are
  /// without load at q = 0, the heights of the bodies' file are those in equilibrium.
  void setRest(const BodyVector& q) { rest_ = q; }
  const BodyVector& rest() const { return rest_; }
  /// At rest() moved to a place, all bodies at one speed, wheelsets rolling without slip.
  BodyState rollingState(double location_m, double speed_mps, double wheel_radius_m) const;

  /// Where the bodies stand in a packed state.
  std::vector<BodyPose> computePoses(const double* in) const;

  /// Adds gravity (straight down) and the suspension's forces at this state; see addSuspensionForces for damper_x_m.
  void addInnerForces(BodyState& state, double h, BodyVector& loads, const Placement& placement = {});

  /// Takes the step (I1). @return empty, or the body and degree of freedom whose velocity is not a number, or that is
  /// more than 1 m or 1 rad from its place
  std::string step(const BodyVector& loads, double h, BodyState& state) const;

  /// Energy that the suspension's dampers took in the step just done [J], between these velocities.
  double computeDampingWork(const BodyVector& v_old, const BodyVector& v_new, double h,
                            const Placement& placement = {}) const;
  /// Work of the suspension's elements along their own deflections in that step [J].
  double computeElementWork(const BodyVector& v_mean, double h, const Placement& placement) const;
  double computeKineticEnergy(const BodyVector& v) const;
  /// Elastic energy of the suspension and potential energy of gravity [J].
  double computeStoredEnergy(const BodyState& state, const Placement& placement = {}) const;
  /// Mean of a velocity along the track over all mass: speed of the centre of gravity [m/s]; of q: its chainage [m].
  double centreOfGravity(const BodyVector& x) const;

 private:
  BodyLayout layout_;
  Suspension suspension_;
  SuspensionWorkspace workspace_;
  BodyVector rest_;
};

}  // namespace loco
