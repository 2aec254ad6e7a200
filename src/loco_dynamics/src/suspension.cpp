#include "loco_dynamics/suspension.hpp"

#include <algorithm>
#include <cmath>

namespace loco {

namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr bool spins(const SpringDamper& e) { return e.spins_A; }
template <typename Element>
constexpr bool spins(const Element&) {
  return false;
}

// Number by number: a vector of which one entry was just cleared cannot be loaded as a whole before that store is done,
// and waiting for it took a third of the 2D locomotive's time.

/// pointDisplacement of an axlebox, which sees everything of its wheelset's motion but the spin, or of another point.
inline Eigen::Vector3d displacementOf(const Vector6& x, const Eigen::Vector3d& r, bool axlebox) {
  const double pitch = axlebox ? 0.0 : x[kPitch];
  return {x[kX] + (pitch * r.z() - x[kYaw] * r.y()), x[kY] + (x[kYaw] * r.x() - x[kRoll] * r.z()),
          x[kZ] + (x[kRoll] * r.y() - pitch * r.x())};
}

/// A force with its moment about the body's CoG; an axlebox takes no moment about its axle.
inline void addAt(Vector6& load, const Eigen::Vector3d& F, const Eigen::Vector3d& r, bool axlebox) {
  load[kX] += F.x();
  load[kY] += F.y();
  load[kZ] += F.z();
  load[kRoll] += r.y() * F.z() - r.z() * F.y();
  if (!axlebox) load[kPitch] += r.z() * F.x() - r.x() * F.z();
  load[kYaw] += r.x() * F.y() - r.y() * F.x();
}

/// Where the frames' gap puts a point of A, in B's frame.                                                  (S3)
Eigen::Vector3d gapMotion(const FrameGap::Parts& g, const Eigen::Vector3d& p_A) {
  return {-g.heading_rad * p_A.y(), g.lateral_m + g.heading_rad * p_A.x() - g.roll_rad * p_A.z(),
          g.height_m + g.roll_rad * p_A.y()};
}

template <typename Element>
inline Eigen::Vector3d relativeMotion(const Element& e, const BodyVector& x) {
  const Eigen::Vector3d a = displacementOf(x[e.body_A], e.r_A, spins(e)), b = displacementOf(x[e.body_B], e.r_B, false);
  return {a.x() - b.x(), a.y() - b.y(), a.z() - b.z()};
}

template <typename Element>
Eigen::Vector3d pointInFrame(const Element& e, const FrameGap& gap) {
  return e.r_A + Eigen::Vector3d(0.0, 0.0, gap.cog_height_A_m);
}

/// Deflection of an element, from the bodies' displacements and the frames' gap.
template <typename Element>
inline Eigen::Vector3d deflection(const Element& e, const BodyVector& q, const Placement& placement) {
  if (placement.gaps == nullptr) return relativeMotion(e, q);
  const FrameGap& gap = (*placement.gaps)[gapIndex(e.body_A, e.body_B)];
  return relativeMotion(e, q) + gapMotion(gap.at, pointInFrame(e, gap));
}

/// Its rate, from the bodies' velocities.
template <typename Element>
inline Eigen::Vector3d deflectionRate(const Element& e, const BodyVector& v, const Placement& placement) {
  if (placement.gaps == nullptr) return relativeMotion(e, v);
  const FrameGap& gap = (*placement.gaps)[gapIndex(e.body_A, e.body_B)];
  return relativeMotion(e, v) + gapMotion(gap.rate, pointInFrame(e, gap));
}

/// Adds the force F on A, in the axes of B, and its reaction, where frames turn or ends are displaced.       (S3)
template <typename Element>
void addTurnedPair(const Element& e, const Eigen::Vector3d& F, const BodyVector& q, const Placement& placement,
                   BodyVector& loads) {
  Eigen::Vector3d F_on_A = F, F_on_B = -F, r_A = e.r_A, r_B = e.r_B;
  if (placement.gaps != nullptr) {
    const FrameGap::Parts& g = (*placement.gaps)[gapIndex(e.body_A, e.body_B)].at;
    const double yaw_B = q[e.body_B][kYaw];
    F_on_B.y() -= F.x() * yaw_B;
    const double F_y = F.y() + F.x() * (yaw_B - g.heading_rad);
    F_on_A.y() = F_y + F.z() * g.roll_rad;
    F_on_A.z() = F.z() - F_y * g.roll_rad;
  }
  if (placement.at_displaced_points) {  // both forces in one line, half-way between the displaced ends
    const Eigen::Vector3d d = deflection(e, q, placement);
    const Eigen::Vector2d on_A(spins(e) ? 0.0 : 0.5 * d.x(), 0.5 * d.y());  // an axlebox's stay above its axle
    const Vector6 &q_A = q[e.body_A], &q_B = q[e.body_B];
    const double pitch_A = spins(e) ? 0.0 : q_A[kPitch];
    r_A.x() += pitch_A * e.r_A.z() - q_A[kYaw] * e.r_A.y() - on_A.x();
    r_A.y() += q_A[kYaw] * e.r_A.x() - q_A[kRoll] * e.r_A.z() - on_A.y();
    r_B.x() += q_B[kPitch] * e.r_B.z() - q_B[kYaw] * e.r_B.y() + d.x() - on_A.x();
    r_B.y() += q_B[kYaw] * e.r_B.x() - q_B[kRoll] * e.r_B.z() + d.y() - on_A.y();
  }
  addAt(loads[e.body_A], F_on_A, r_A, spins(e));
  addAt(loads[e.body_B], F_on_B, r_B, false);
}

/// Adds the force F on A and its reaction.
template <typename Element>
inline void addPair(const Element& e, const Eigen::Vector3d& F, const BodyVector& q, const Placement& placement,
                    BodyVector& loads) {
  if (placement.gaps != nullptr || placement.at_displaced_points) {
    addTurnedPair(e, F, q, placement, loads);
    return;
  }
  addAt(loads[e.body_A], F, e.r_A, spins(e));
  addAt(loads[e.body_B], -F, e.r_B, false);
}

/// The speed u of a damper whose force D(u) is that of the spring in series, K (e - h u), e its stretch if u were 0.
double solveDamperSpeed(const OddLaw& D, double K, double e, double h) {
  // D(u) + K h u rises, so the root is unique; D is straight between knots: Newton's method ends in a few steps.
  double u = 0.0;
  for (int i = 0; i < 8; ++i) {
    const double step = (D(u) + K * h * u - K * e) / (D.slope(u) + K * h);
    u -= step;
    if (step == 0.0) break;
  }
  return u;
}

}  // namespace

void addSuspensionForces(const Suspension& suspension, const BodyVector& q, const BodyVector& v, double step_s,
                         const Placement& placement, double* damper_x_m, SuspensionWorkspace& workspace,
                         BodyVector& loads) {
  for (std::size_t i = 0; i < suspension.springs.size(); ++i) {
    const SpringDamper& e = suspension.springs[i];
    const Eigen::Vector3d damping = -e.damping_N_s_per_m.cwiseProduct(deflectionRate(e, v, placement));
    const Eigen::Vector3d spring = -e.stiffness_N_per_m.cwiseProduct(deflection(e, q, placement));
    workspace.damping_on_A_N[i] = damping;
    workspace.spring_on_A_N[i] = spring;
    addPair(e, damping + spring, q, placement, loads);  // (S1)
  }
  for (std::size_t i = 0; i < suspension.pins.size(); ++i) {
    const CentrePin& e = suspension.pins[i];
    const Eigen::Vector3d d = deflection(e, q, placement);
    workspace.pin_on_A_N[i] = {-e.longitudinal(d.x()), -e.lateral(d.y()), 0.0};
    addPair(e, workspace.pin_on_A_N[i], q, placement, loads);
  }
  for (std::size_t i = 0; i < suspension.yaw_dampers.size(); ++i) {
    const YawDamper& e = suspension.yaw_dampers[i];
    const double d = deflection(e, q, placement).x();
    const double u = solveDamperSpeed(e.damper, e.series_stiffness_N_per_m, d - damper_x_m[i], step_s);  // (S2)
    damper_x_m[i] += step_s * u;
    workspace.damper_speed_mps[i] = u;
    workspace.damper_force_N[i] = e.damper(u);
    addPair(e, {-workspace.damper_force_N[i], 0.0, 0.0}, q, placement, loads);
  }
}

double computeDampingWork(const Suspension& suspension, const BodyVector& v_mean, double step_s,
                          const Placement& placement, const SuspensionWorkspace& workspace) {
  double work = 0.0;
  for (std::size_t i = 0; i < suspension.springs.size(); ++i)
    work -= workspace.damping_on_A_N[i].dot(deflectionRate(suspension.springs[i], v_mean, placement));
  for (std::size_t i = 0; i < suspension.yaw_dampers.size(); ++i)
    work += workspace.damper_force_N[i] * workspace.damper_speed_mps[i];
  return work * step_s;
}

double computeElementWork(const Suspension& suspension, const BodyVector& v_mean, double step_s,
                          const Placement& placement, const SuspensionWorkspace& workspace) {
  double work = 0.0;
  for (std::size_t i = 0; i < suspension.springs.size(); ++i)
    work += (workspace.damping_on_A_N[i] + workspace.spring_on_A_N[i])
                .dot(deflectionRate(suspension.springs[i], v_mean, placement));
  for (std::size_t i = 0; i < suspension.pins.size(); ++i)
    work += workspace.pin_on_A_N[i].dot(deflectionRate(suspension.pins[i], v_mean, placement));
  for (std::size_t i = 0; i < suspension.yaw_dampers.size(); ++i)
    work -= workspace.damper_force_N[i] * deflectionRate(suspension.yaw_dampers[i], v_mean, placement).x();
  return work * step_s;
}

double computeStoredEnergy(const Suspension& suspension, const BodyVector& q, const Placement& placement,
                           const double* damper_x_m) {
  double energy = 0.0;
  for (const SpringDamper& e : suspension.springs) {
    const Eigen::Vector3d d = deflection(e, q, placement);
    energy += 0.5 * e.stiffness_N_per_m.dot(d.cwiseProduct(d));
  }
  for (const CentrePin& e : suspension.pins) {
    const Eigen::Vector3d d = deflection(e, q, placement);
    energy += e.longitudinal.integral(d.x()) + e.lateral.integral(d.y());
  }
  for (std::size_t i = 0; i < suspension.yaw_dampers.size(); ++i) {
    const YawDamper& e = suspension.yaw_dampers[i];
    const double stretch = deflection(e, q, placement).x() - damper_x_m[i];
    energy += 0.5 * e.series_stiffness_N_per_m * stretch * stretch;
  }
  return energy;
}

}  // namespace loco
