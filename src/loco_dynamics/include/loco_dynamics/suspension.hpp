#pragma once

#include <string>
#include <vector>

#include "loco_dynamics/body_layout.hpp"
#include "loco_dynamics/odd_law.hpp"

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

/// The frame of body A against that of body B where the track turns between them, and how fast that changes. All 0 on
/// straight track.
struct FrameGap {
  struct Parts {
    double heading_rad = 0.0;  ///< of A's frame, + to the left
    double lateral_m = 0.0;    ///< of A's origin from the tangent at B's
    double roll_rad = 0.0;     ///< of A's frame, from cant
    double height_m = 0.0;     ///< of A's origin over B's, from cant
  };
  Parts at, rate;
  double cog_height_A_m = 0.0;  ///< of A's CoG over its frame's origin
};
/// One for each body but the car: wheelset against its bogie frame, car against the bogie frame.
using FrameGaps = std::array<FrameGap, BodyLayout::kBodies - 1>;
/// Which of them lies between the two ends of an element.
inline std::size_t gapIndex(std::size_t body_A, std::size_t body_B) {
  return (body_A == BodyLayout::kCar ? body_B : body_A) - 1;
}

/// How a suspension stands in its track.
struct Placement {
  const FrameGaps* gaps = nullptr;  ///< null: straight track
  /// Forces act half-way between the displaced ends, seen from above; heights stay nominal, which is under load:
  /// gravity's stiffness.
  bool at_displaced_points = false;
};

/// Scratch memory of one suspension, allocated once: what the second half of a step needs of the first. Forces on A,
/// in B's axes.
struct SuspensionWorkspace {
  explicit SuspensionWorkspace(const Suspension& suspension)
      : damping_on_A_N(suspension.springs.size(), Eigen::Vector3d::Zero()),
        spring_on_A_N(suspension.springs.size(), Eigen::Vector3d::Zero()),
        pin_on_A_N(suspension.pins.size(), Eigen::Vector3d::Zero()),
        damper_force_N(suspension.yaw_dampers.size(), 0.0),
        damper_speed_mps(suspension.yaw_dampers.size(), 0.0) {}
  std::vector<Eigen::Vector3d> damping_on_A_N, spring_on_A_N, pin_on_A_N;
  std::vector<double> damper_force_N, damper_speed_mps;
};

/// Forces of all elements on the bodies, from positions and velocities at the start of a step.
/// On curved track deflections are those in the axes of body B's frame; of the force, its lateral part turns with the
/// frames and with B's yaw, the longitudinal part does not (S3):
///   d = u_A - u_B + g(p_A),   g(p) = (-theta p_y, Y + theta p_x - phi p_z, Z + phi p_y)
///   F_y in B's frame = F_y + F_x psi_B,   in A's frame = F_y + F_x (psi_B - theta) + F_z phi
/// with theta, Y, phi, Z the gap's heading, lateral, roll, height; p_A the point in A's frame.
/// @param damper_x_m   per yaw damper: displacement of the damper itself at the start of the step; becomes that at its
///                     end. It is integrated implicitly: its time constant is a fraction of the step.
/// @param step_s       h
/// @param loads        forces and moments are added here
void addSuspensionForces(const Suspension& suspension, const BodyVector& q, const BodyVector& v, double step_s,
                         const Placement& placement, double* damper_x_m, SuspensionWorkspace& workspace,
                         BodyVector& loads);

/// Energy that the dampers took during the step whose forces are in the workspace [J], with the mean of the old and the
/// new velocities; >= 0 but for the change of a velocity's sign within the step.
double computeDampingWork(const Suspension& suspension, const BodyVector& v_mean, double step_s,
                          const Placement& placement, const SuspensionWorkspace& workspace);

/// Work of all elements' forces along their own deflections during that step [J]: what they give to the bodies and
/// to the turning of the frames, < 0 where they store or dissipate.
double computeElementWork(const Suspension& suspension, const BodyVector& v_mean, double step_s,
                          const Placement& placement, const SuspensionWorkspace& workspace);

/// Elastic energy of all elements [J].
double computeStoredEnergy(const Suspension& suspension, const BodyVector& q, const Placement& placement,
                           const double* damper_x_m);

}  // namespace loco
