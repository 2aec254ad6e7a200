// Levenberg's and Marquardt's method for a 3D locomotive's equilibrium.

#include "loco_dynamics/loco_3d.hpp"
#include "rail_core/message_number.hpp"

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

constexpr double kBalance_N = 0.1;  ///< chosen: round-off of springs under 1 MN leaves 1e-4 N, on S1002 and the cone

/// Empty if these loads, in kN and kN m, are none.
std::string nameUnbalanced(const BodyLayout& layout, const Flat& loads) {
  Eigen::Index worst = 0;
  const double left_N = 1e3 * loads.cwiseAbs().maxCoeff(&worst);
  if (left_N <= kBalance_N) return {};
  return layout.bodies()[static_cast<std::size_t>(worst) / kDofs].name + ": no equilibrium was found, " +
         rail::messageNumber(left_N) + " N or N m are left on it";
}

}  // namespace

/// Levenberg's and Marquardt's method: contacts open and close, so that Newton's alone need not arrive.
/// @return empty, or on which body how much is left that moves it
std::string Loco3d::relax(const TrackFrames& frames, BodyState& state) const {
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
    if (!better) break;  // as near as it gets
  }
  return nameUnbalanced(dynamics_.layout(), loads);
}

}  // namespace loco
