#pragma once

#include <string>
#include <vector>

#include "loco_dynamics/body_layout.hpp"

namespace loco {

/// Spring and damper side by side between a point of body A and one of body B, linear, in each direction.       (S1)
///   F_on_A = -(k d + c d'),   d = u_A - u_B: relative displacement of the two points
struct SpringDamper {
  std::string name;
  std::size_t body_A = 0, body_B = 0;
  Eigen::Vector3d r_A = Eigen::Vector3d::Zero(), r_B = Eigen::Vector3d::Zero();  ///< points from the bodies' CoGs [m]
  Eigen::Vector3d stiffness_N_per_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d damping_N_s_per_m = Eigen::Vector3d::Zero();
  bool spins_A = false;  ///< A is a wheelset: the axlebox does not spin, so its pitch is not seen
};

/// One straight piece of a law odd in its argument, from the end of the previous one.
struct LawPiece {
  double up_to = 0.0;  ///< magnitude at which the piece ends; the last goes on for ever
  double slope = 0.0;
};

/// Piecewise linear law, odd: force over displacement [N/m], or over speed [N s/m].
class OddLaw {
 public:
  OddLaw() = default;
  explicit OddLaw(std::vector<LawPiece> pieces) : pieces_(std::move(pieces)) {}
  double operator()(double x) const;
  double slope(double x) const;
  double integral(double x) const;  ///< from 0 to x, >= 0 for rising laws
  double largestSlope() const;

 private:
  std::vector<LawPiece> pieces_;
};

/// Centre pin with clearance: an odd law of the displacement along x and another along y.
struct CentrePin {
  std::size_t body_A = 0, body_B = 0;
  Eigen::Vector3d r_A = Eigen::Vector3d::Zero(), r_B = Eigen::Vector3d::Zero();
  OddLaw longitudinal, lateral;
};

/// Yaw damper along x: a damper with an odd law of its own speed in series with a spring (Maxwell).            (S2)
///   F = K (d - x),  F = D(x'),  d: relative displacement of its ends; x: that of the damper, its state
struct YawDamper {
  std::size_t body_A = 0, body_B = 0;
  Eigen::Vector3d r_A = Eigen::Vector3d::Zero(), r_B = Eigen::Vector3d::Zero();
  double series_stiffness_N_per_m = 0.0;
  OddLaw damper;  ///< force [N] over speed [m/s]
};

/// All elements between a locomotive's bodies. Constant.
struct Suspension {
  std::vector<SpringDamper> springs;
  std::vector<CentrePin> pins;
  std::vector<YawDamper> yaw_dampers;
};

/// Scratch memory of one suspension, allocated once: what the second half of a step needs of the first.
struct SuspensionWorkspace {
  explicit SuspensionWorkspace(const Suspension& suspension)
      : damping_on_A_N(suspension.springs.size(), Eigen::Vector3d::Zero()),
        damper_force_N(suspension.yaw_dampers.size(), 0.0),
        damper_speed_mps(suspension.yaw_dampers.size(), 0.0) {}
  std::vector<Eigen::Vector3d> damping_on_A_N;
  std::vector<double> damper_force_N, damper_speed_mps;
};

/// Forces of all elements on the bodies, from positions and velocities at the start of a step.
/// @param damper_x_m   per yaw damper: displacement of the damper itself at the start of the step; becomes that at its
/// end.
///                     It is integrated implicitly: its time constant is a fraction of the step.
/// @param step_s       h
/// @param loads        forces and moments are added here
void addSuspensionForces(const Suspension& suspension, const BodyVector& q, const BodyVector& v, double step_s,
                         double* damper_x_m, SuspensionWorkspace& workspace, BodyVector& loads);

/// Energy that the dampers took during the step whose forces are in the workspace [J], with the mean of the old and the
/// new velocities; >= 0 but for the change of a velocity's sign within the step.
double computeDampingWork(const Suspension& suspension, const BodyVector& v_mean, double step_s,
                          const SuspensionWorkspace& workspace);

/// Elastic energy of all elements [J].
double computeStoredEnergy(const Suspension& suspension, const BodyVector& q, const double* damper_x_m);

}  // namespace loco
