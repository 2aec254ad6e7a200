// Where a 3D locomotive starts: quasi-static equilibrium on its place of the track.

#include <algorithm>
#include <cmath>

#include "loco_dynamics/frame_forces.hpp"
#include "loco_dynamics/loco_3d.hpp"
#include "rail_core/constants.hpp"

namespace loco {

namespace {

constexpr Eigen::Index kSize = BodyLayout::kBodies * kDofs;
using Flat = Eigen::VectorXd;

/// The unknowns: all positions; of a wheelset's pitch, which may be any, its speed instead.
double& unknown(BodyState& state, std::size_t body, Eigen::Index dof) {
  return dof == kPitch && body >= BodyLayout::wheelset(0) ? state.v[body][dof] : state.q[body][dof];
}

/// Unknowns and loads are made numbers of like size: mm, mrad, 10 mrad/s; kN, kN m.
double unitOf(std::size_t body, Eigen::Index dof) {
  return dof == kPitch && body >= BodyLayout::wheelset(0) ? 1e-2 : 1e-3;
}

BodyState movedBy(const Flat& step, BodyState state) {
  for (Eigen::Index i = 0; i < kSize; ++i) {
    const auto body = static_cast<std::size_t>(i) / kDofs;
    const Eigen::Index dof = i % static_cast<Eigen::Index>(kDofs);
    unknown(state, body, dof) += step[i] * unitOf(body, dof);
  }
  return state;
}

constexpr double kForEver_s = 1e12;  ///< a step after which a yaw damper has no force

/// Takes from the forces along the track what slows all bodies down together.
void shareDeceleration(const BodyLayout& layout, BodyVector& loads) {
  double sum_N = 0.0;
  for (const auto& load : loads) sum_N += load[kX];
  for (std::size_t i = 0; i < loads.size(); ++i)
    loads[i][kX] -= sum_N * layout.bodies()[i].mass_kg / layout.totalMass();
}

}  // namespace

/// Everything but the contacts; the yaw dampers have come to rest.
BodyVector Loco3d::computeSteadyLoads(const BodyState& state, const TrackFrames& frames) const {
  BodyState copy = state;
  BodyVector loads;
  for (auto& load : loads) load.setZero();
  dynamics_.addInnerForces(copy, kForEver_s, loads, {&frames.gaps(), parameters_.gravity_stiffness});
  addFrameForces(dynamics_.layout(), frames, state.v, parameters_.structure.spin_momentum_inertia_kg_m2, loads);
  return loads;
}

BodyVector Loco3d::computeStaticLoads(const BodyState& state) const { return computeStaticLoads(state, frames_); }

BodyVector Loco3d::computeStaticLoads(const BodyState& state, TrackFrames frames) const {
  frames.place(state.q);
  frames.computeGaps(state.v);
  BodyVector loads = computeSteadyLoads(state, frames);
  WheelsetContact::Contacts contacts;
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    contact_.compute(motionOf(axle, state, frames), contacts);
    for (std::size_t i = 0; i < contacts.count; ++i) {
      const WheelsetContact::Contact& c = contacts.list[i];
      loads[BodyLayout::wheelset(axle)] += c.J_n * c.normal_N + c.J_x * c.creep_N.x() + c.J_t * c.creep_N.y();
    }
  }
  shareDeceleration(dynamics_.layout(), loads);
  return loads;
}

/// Moves bogies and car sideways to where the track has the bodies that carry them.
void Loco3d::followTrack(BodyState& state) const {
  TrackFrames frames = frames_;
  frames.place(state.q);
  frames.computeGaps(state.v);
  const auto& bodies = dynamics_.layout().bodies();
  double car_m = 0.0;
  for (std::size_t i = 0; i < BodyLayout::kBogies; ++i) {
    const std::size_t bogie = BodyLayout::bogie(i);
    double mean_m = 0.0;
    for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle)
      if (BodyLayout::bogieOfAxle(axle) == bogie)
        mean_m += frames.gaps()[gapIndex(BodyLayout::wheelset(axle), bogie)].at.lateral_m / BodyLayout::kAxlesPerBogie;
    state.q[bogie][kY] += mean_m;
    const FrameGap::Parts& gap = frames.gaps()[gapIndex(BodyLayout::kCar, bogie)].at;
    car_m += (mean_m - gap.lateral_m - gap.heading_rad * bodies[bogie].p_T.x()) / BodyLayout::kBogies;
  }
  state.q[BodyLayout::kCar][kY] += car_m;
}

/// Lets the bodies move on the spot, over track that stays as it is there, until its damping has brought them near the
/// equilibrium that running would bring them to: there may be others, with a wheel up on its flange.
void Loco3d::settle(BodyState& state, double speed_mps) const {
  constexpr double kSettling_s = 4.0, kStep_s = 5e-4;  // chosen: the slowest sway falls to a sixth
  WheelsetContact::Contacts contacts;
  Vector6 inertia;
  for (int i = 0; i < static_cast<int>(kSettling_s / kStep_s); ++i) {
    TrackFrames frames = frames_;
    frames.place(state.q);
    frames.computeGaps(state.v);
    BodyVector loads = computeSteadyLoads(state, frames);
    for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
      const std::size_t body = BodyLayout::wheelset(axle);
      for (std::size_t k = 0; k < kDofs; ++k)
        inertia[static_cast<Eigen::Index>(k)] = dynamics_.layout().inertia(body, static_cast<Dof>(k));
      contact_.compute(motionOf(axle, state, frames), contacts);
      WheelsetContact::addForces(inertia, kStep_s, contacts, loads[body], {});
    }
    shareDeceleration(dynamics_.layout(), loads);
    if (!dynamics_.step(loads, kStep_s, state).empty()) return;
    for (auto& q : state.q) q[kX] -= kStep_s * speed_mps;
  }
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {
    const double omega = state.v[i][kPitch];
    state.v[i].setZero();
    state.v[i][kX] = speed_mps;
    if (i < BodyLayout::wheelset(0)) continue;
    state.v[i][kPitch] = omega;
    state.q[i][kPitch] = 0.0;
  }
}

/// Lowers each wheelset until its wheels carry its share of the weight, by halving.
void Loco3d::placeWheelsets(BodyState& state) const {
  const double axle_N = dynamics_.layout().totalMass() * rail::kGravity_mps2 / BodyLayout::kAxles;
  WheelsetContact::Contacts contacts;
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    double low_m = -2e-3, high_m = 2e-3;
    for (int i = 0; i < 50; ++i) {
      double& z_m = state.q[BodyLayout::wheelset(axle)][kZ] = 0.5 * (low_m + high_m);
      contact_.compute(motionOf(axle, state, frames_), contacts);
      double sum_N = 0.0;
      for (std::size_t k = 0; k < contacts.count; ++k) sum_N += contacts.list[k].force_N().z();
      (sum_N > axle_N ? low_m : high_m) = z_m;
    }
  }
}

/// Levenberg's and Marquardt's method: contacts open and close, so that Newton's alone need not arrive.
void Loco3d::relax(const TrackFrames& frames, BodyState& state) const {
  const auto loadsAt = [&](const BodyState& at) {
    const BodyVector loads = computeStaticLoads(at, frames);
    Flat flat(kSize);
    for (std::size_t i = 0; i < loads.size(); ++i) flat.segment<kDofs>(static_cast<Eigen::Index>(i * kDofs)) = loads[i];
    return Flat(flat * 1e-3);
  };
  Flat loads = loadsAt(state);
  double damping = 1e-3;
  for (int iteration = 0; iteration < 200 && loads.cwiseAbs().maxCoeff() > 1e-9; ++iteration) {
    Eigen::MatrixXd jacobian(kSize, kSize);
    for (Eigen::Index column = 0; column < kSize; ++column) {
      constexpr double kStep = 1e-5;  // of the units
      jacobian.col(column) = (loadsAt(movedBy(kStep * Flat::Unit(kSize, column), state)) - loads) / kStep;
    }
    const Eigen::MatrixXd square = jacobian.transpose() * jacobian;
    bool better = false;
    for (int attempt = 0; attempt < 12 && !better; ++attempt) {
      Eigen::MatrixXd system = square;
      system.diagonal().array() += damping * (1.0 + 1e-3 * square.diagonal().array());
      const BodyState moved = movedBy(system.ldlt().solve(-jacobian.transpose() * loads), state);
      const Flat there = loadsAt(moved);
      better = there.squaredNorm() < loads.squaredNorm();
      damping *= better ? 0.1 : 10.0;
      if (!better) continue;
      state = moved;
      loads = there;
    }
    if (!better) return;  // as near as it gets
  }
}

bool Loco3d::onStraightTrack(const BodyState& state) const {
  TrackFrames frames = frames_;
  frames.place(state.q);
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i)
    if (frames[i].curvature_1pm != 0.0 || frames[i].roll_rad != 0.0 || frames[i].irregular) return false;
  return true;
}

/// At rest at chainage 0 of straight track.
BodyVector Loco3d::computeRest() const {
  BodyState state;
  dynamics_.unpack(std::vector<double>(dynamics_.stateSize(), 0.0).data(), state);
  placeWheelsets(state);
  relax(TrackFrames(dynamics_.layout(), nullptr), state);
  for (auto& q : state.q) q[kY] = q[kRoll] = q[kYaw] = 0.0;  // both sides are alike: no round-off to grow from
  return state.q;
}

std::vector<double> Loco3d::equilibriumState(double location_m, double speed_mps) const {
  BodyState state = dynamics_.rollingState(location_m, speed_mps, parameters_.structure.wheel_radius_m);
  if (!onStraightTrack(state)) {
    followTrack(state);
    settle(state, speed_mps);
  }
  relax(frames_, state);
  if (onStraightTrack(state))
    for (auto& q : state.q) q[kY] = q[kRoll] = q[kYaw] = 0.0;
  std::vector<double> flat(dynamics_.stateSize());
  BodyState at_rest = state;  // the yaw dampers have followed
  TrackFrames frames = frames_;
  frames.place(state.q);
  frames.computeGaps(state.v);
  BodyVector loads;
  for (auto& load : loads) load.setZero();
  dynamics_.addInnerForces(at_rest, kForEver_s, loads, {&frames.gaps(), parameters_.gravity_stiffness});
  dynamics_.pack(at_rest, flat.data());
  const std::vector<double> control = drive_.initialState();
  flat.insert(flat.end(), control.begin(), control.end());
  flat.insert(flat.end(), 2 * BodyLayout::kAxles, 0.0);
  return flat;
}

}  // namespace loco
