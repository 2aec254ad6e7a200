#include "loco_dynamics/suspension.hpp"

#include <algorithm>
#include <cmath>

namespace loco {

namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// What an axlebox sees of its wheelset's motion: everything but the spin.
Vector6 withoutSpin(Vector6 x) {
  x[kPitch] = 0.0;
  return x;
}

template <typename Element>
Eigen::Vector3d relativeMotion(const Element& e, const BodyVector& x) {
  return pointDisplacement(x[e.body_A], e.r_A) - pointDisplacement(x[e.body_B], e.r_B);
}

Eigen::Vector3d relativeMotion(const SpringDamper& e, const BodyVector& x) {
  const Vector6 a = e.spins_A ? withoutSpin(x[e.body_A]) : x[e.body_A];
  return pointDisplacement(a, e.r_A) - pointDisplacement(x[e.body_B], e.r_B);
}

void addPair(std::size_t body_A, const Eigen::Vector3d& r_A, std::size_t body_B, const Eigen::Vector3d& r_B,
             const Eigen::Vector3d& F_on_A, BodyVector& loads) {
  addForce(loads[body_A], F_on_A, r_A);
  addForce(loads[body_B], -F_on_A, r_B);
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

double OddLaw::operator()(double x) const {
  const double ax = std::abs(x);
  double from = 0.0, value = 0.0;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const bool last = i + 1 == pieces_.size() || ax <= pieces_[i].up_to;
    const double to = last ? ax : pieces_[i].up_to;
    value += pieces_[i].slope * (to - from);
    if (last) break;
    from = to;
  }
  return x < 0.0 ? -value : value;
}

double OddLaw::slope(double x) const {
  const double ax = std::abs(x);
  for (std::size_t i = 0; i + 1 < pieces_.size(); ++i) {
    if (ax <= pieces_[i].up_to) return pieces_[i].slope;
  }
  return pieces_.empty() ? 0.0 : pieces_.back().slope;
}

double OddLaw::integral(double x) const {
  const double ax = std::abs(x);
  double from = 0.0, value = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const bool last = i + 1 == pieces_.size() || ax <= pieces_[i].up_to;
    const double length = (last ? ax : pieces_[i].up_to) - from;
    sum += value * length + 0.5 * pieces_[i].slope * length * length;
    if (last) break;
    value += pieces_[i].slope * length;
    from += length;
  }
  return sum;
}

double OddLaw::largestSlope() const {
  double largest = 0.0;
  for (const LawPiece& piece : pieces_) largest = std::max(largest, piece.slope);
  return largest;
}

void addSuspensionForces(const Suspension& suspension, const BodyVector& q, const BodyVector& v, double step_s,
                         double* damper_x_m, SuspensionWorkspace& workspace, BodyVector& loads) {
  for (std::size_t i = 0; i < suspension.springs.size(); ++i) {
    const SpringDamper& e = suspension.springs[i];
    const Eigen::Vector3d damping = -e.damping_N_s_per_m.cwiseProduct(relativeMotion(e, v));
    const Eigen::Vector3d F_on_A = damping - e.stiffness_N_per_m.cwiseProduct(relativeMotion(e, q));  // (S1)
    workspace.damping_on_A_N[i] = damping;
    if (e.spins_A) {  // the force acts on the axlebox: no moment about the axle
      loads[e.body_A].head<3>() += F_on_A;
      Eigen::Vector3d moment = e.r_A.cross(F_on_A);
      moment.y() = 0.0;
      loads[e.body_A].tail<3>() += moment;
      addForce(loads[e.body_B], -F_on_A, e.r_B);
    } else {
      addPair(e.body_A, e.r_A, e.body_B, e.r_B, F_on_A, loads);
    }
  }
  for (const CentrePin& e : suspension.pins) {
    const Eigen::Vector3d d = relativeMotion(e, q);
    addPair(e.body_A, e.r_A, e.body_B, e.r_B, {-e.longitudinal(d.x()), -e.lateral(d.y()), 0.0}, loads);
  }
  for (std::size_t i = 0; i < suspension.yaw_dampers.size(); ++i) {
    const YawDamper& e = suspension.yaw_dampers[i];
    const double d = relativeMotion(e, q).x();
    const double u = solveDamperSpeed(e.damper, e.series_stiffness_N_per_m, d - damper_x_m[i], step_s);  // (S2)
    damper_x_m[i] += step_s * u;
    workspace.damper_speed_mps[i] = u;
    workspace.damper_force_N[i] = e.damper(u);
    addPair(e.body_A, e.r_A, e.body_B, e.r_B, {-workspace.damper_force_N[i], 0.0, 0.0}, loads);
  }
}

double computeDampingWork(const Suspension& suspension, const BodyVector& v_mean, double step_s,
                          const SuspensionWorkspace& workspace) {
  double work = 0.0;
  for (std::size_t i = 0; i < suspension.springs.size(); ++i)
    work -= workspace.damping_on_A_N[i].dot(relativeMotion(suspension.springs[i], v_mean));
  for (std::size_t i = 0; i < suspension.yaw_dampers.size(); ++i)
    work += workspace.damper_force_N[i] * workspace.damper_speed_mps[i];
  return work * step_s;
}

double computeStoredEnergy(const Suspension& suspension, const BodyVector& q, const double* damper_x_m) {
  double energy = 0.0;
  for (const SpringDamper& e : suspension.springs) {
    const Eigen::Vector3d d = relativeMotion(e, q);
    energy += 0.5 * e.stiffness_N_per_m.dot(d.cwiseProduct(d));
  }
  for (const CentrePin& e : suspension.pins) {
    const Eigen::Vector3d d = relativeMotion(e, q);
    energy += e.longitudinal.integral(d.x()) + e.lateral.integral(d.y());
  }
  for (std::size_t i = 0; i < suspension.yaw_dampers.size(); ++i) {
    const YawDamper& e = suspension.yaw_dampers[i];
    const double stretch = relativeMotion(e, q).x() - damper_x_m[i];
    energy += 0.5 * e.series_stiffness_N_per_m * stretch * stretch;
  }
  return energy;
}

}  // namespace loco
