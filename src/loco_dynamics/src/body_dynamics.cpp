#include "loco_dynamics/body_dynamics.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rail_core/constants.hpp"
#include "rail_core/message_number.hpp"

namespace loco {

namespace {

const char* nameOf(Dof dof) {
  static const char* const names[] = {"x", "y", "z", "roll", "pitch", "yaw"};
  return names[dof];
}

/// How far a body is from its place, seen from the car body [m, rad]; a wheelset's spin has no place.
double offsetOf(const BodyVector& q, const BodyVector& rest, std::size_t body, Dof dof) {
  if (dof == kPitch && body >= BodyLayout::wheelset(0)) return 0.0;
  const auto k = static_cast<Eigen::Index>(dof);
  return q[body][k] - (dof == kX ? q[BodyLayout::kCar][k] : rest[body][k]);
}

/// A run that grows without bound is told long before it has no numbers left.
std::string findImplausible(const BodyLayout& layout, const BodyVector& q, const BodyVector& rest) {
  constexpr double kLargest = 1.0;  // m, rad; chosen: far beyond small motions, of which the model is
  double largest = 0.0;
  std::size_t body = 0;
  Dof dof = kX;
  for (std::size_t i = 0; i < layout.bodies().size(); ++i) {
    for (const Dof k : layout.dofs()) {
      const double offset = std::abs(offsetOf(q, rest, i, k));
      if (offset <= largest) continue;
      largest = offset;
      body = i;
      dof = k;
    }
  }
  if (largest <= kLargest) return {};
  return layout.bodies()[body].name + ": in " + nameOf(dof) + " is " +
         rail::messageNumber(offsetOf(q, rest, body, dof)) + (dof < kRoll ? " m" : " rad") + " from its place";
}

}  // namespace

BodyDynamics::BodyDynamics(BodyLayout layout, Suspension suspension)
    : layout_(std::move(layout)), suspension_(std::move(suspension)), workspace_(suspension_) {
  for (auto& body : rest_) body.setZero();
}

void BodyDynamics::pack(const BodyState& state, double* out) const {
  for (const BodyVector* x : {&state.q, &state.v})
    for (const auto& body : *x)
      for (const Dof dof : layout_.dofs()) *out++ = body[static_cast<Eigen::Index>(dof)];
  for (const double x : state.damper_x_m) *out++ = x;
}

void BodyDynamics::unpack(const double* in, BodyState& state) const {
  for (BodyVector* x : {&state.q, &state.v}) {
    for (auto& body : *x) {
      body.setZero();
      for (const Dof dof : layout_.dofs()) body[static_cast<Eigen::Index>(dof)] = *in++;
    }
  }
  state.damper_x_m.resize(suspension_.yaw_dampers.size());
  for (double& x : state.damper_x_m) x = *in++;
}

std::vector<BodyPose> BodyDynamics::computePoses(const double* in) const {
  BodyState state;
  unpack(in, state);
  std::vector<BodyPose> poses;
  for (std::size_t i = 0; i < layout_.bodies().size(); ++i) {
    const Body& body = layout_.bodies()[i];
    const Eigen::Matrix<double, 6, 1> q = state.q[i] - rest_[i];
    BodyPose pose;
    pose.name = body.name;
    std::replace(pose.name.begin(), pose.name.end(), ' ', '_');
    pose.location_m = body.p_T.x() + q[kX];
    pose.y_m = body.p_T.y() + q[kY];
    pose.z_m = body.p_T.z() + q[kZ];
    pose.roll_rad = q[kRoll];
    pose.pitch_rad = q[kPitch];
    pose.yaw_rad = q[kYaw];
    poses.push_back(pose);
  }
  return poses;
}

BodyState BodyDynamics::rollingState(double location_m, double speed_mps, double wheel_radius_m) const {
  BodyState state;
  unpack(std::vector<double>(stateSize(), 0.0).data(), state);
  state.q = rest_;
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {
    state.q[i][kX] += location_m;
    state.v[i][kX] = speed_mps;
    if (i >= BodyLayout::wheelset(0)) state.v[i][kPitch] = speed_mps / wheel_radius_m;
  }
  return state;
}

void BodyDynamics::addInnerForces(BodyState& state, double h, BodyVector& loads, const Placement& placement) {
  for (std::size_t i = 0; i < layout_.bodies().size(); ++i)
    loads[i][kZ] -= layout_.bodies()[i].mass_kg * rail::kGravity_mps2;
  addSuspensionForces(suspension_, state.q, state.v, h, placement, state.damper_x_m.data(), workspace_, loads);
}

std::string BodyDynamics::step(const BodyVector& loads, double h, BodyState& state) const {
  for (std::size_t i = 0; i < layout_.bodies().size(); ++i) {
    for (const Dof dof : layout_.dofs()) {
      const auto k = static_cast<Eigen::Index>(dof);
      state.v[i][k] += h * loads[i][k] / layout_.inertia(i, dof);  // (I1)
      state.q[i][k] += h * state.v[i][k];
      if (!std::isfinite(state.v[i][k]))
        return layout_.bodies()[i].name + ": its speed in " + nameOf(dof) + " is no number";
    }
  }
  return findImplausible(layout_, state.q, rest_);
}

double BodyDynamics::computeDampingWork(const BodyVector& v_old, const BodyVector& v_new, double h,
                                        const Placement& placement) const {
  BodyVector v_mean;
  for (std::size_t i = 0; i < v_mean.size(); ++i) v_mean[i] = 0.5 * (v_old[i] + v_new[i]);
  return loco::computeDampingWork(suspension_, v_mean, h, placement, workspace_);
}

double BodyDynamics::computeElementWork(const BodyVector& v_mean, double h, const Placement& placement) const {
  return loco::computeElementWork(suspension_, v_mean, h, placement, workspace_);
}

double BodyDynamics::computeKineticEnergy(const BodyVector& v) const {
  double energy = 0.0;
  for (std::size_t i = 0; i < layout_.bodies().size(); ++i)
    for (const Dof dof : layout_.dofs()) {
      const double speed = v[i][static_cast<Eigen::Index>(dof)];
      energy += 0.5 * layout_.inertia(i, dof) * speed * speed;
    }
  return energy;
}

double BodyDynamics::computeStoredEnergy(const BodyState& state, const Placement& placement) const {
  double energy = loco::computeStoredEnergy(suspension_, state.q, placement, state.damper_x_m.data());
  for (std::size_t i = 0; i < layout_.bodies().size(); ++i)
    energy += layout_.bodies()[i].mass_kg * rail::kGravity_mps2 * state.q[i][kZ];
  return energy;
}

double BodyDynamics::centreOfGravity(const BodyVector& x) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < layout_.bodies().size(); ++i) sum += layout_.bodies()[i].mass_kg * x[i][kX];
  return sum / layout_.totalMass();
}

}  // namespace loco
