#include "loco_dynamics/modes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace loco {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// (L1) as a system of first order in (q, q', x).
MatrixXd stateMatrix(const LinearModel& model) {
  const Index n = model.size(), m = model.dampers();
  const MatrixXd& G = model.damper_stretch;
  const auto k_s = model.damper_spring_N_per_m.asDiagonal();
  const auto inverse_M = model.inertia.cwiseInverse().asDiagonal();
  MatrixXd A = MatrixXd::Zero(2 * n + m, 2 * n + m);
  A.block(0, n, n, n).setIdentity();
  A.block(n, 0, n, n) = -(inverse_M * model.stiffness);
  A.block(n, n, n, n) = -(inverse_M * model.damping);
  if (m == 0) return A;
  A.block(n, 0, n, n) -= inverse_M * (G.transpose() * k_s * G);
  A.block(n, 2 * n, n, m) = inverse_M * (G.transpose() * k_s);
  const Eigen::VectorXd rate = model.damper_spring_N_per_m.cwiseQuotient(model.damper_slope_N_s_per_m);
  A.block(2 * n, 0, m, n) = rate.asDiagonal() * G;
  A.block(2 * n, 2 * n, m, m) = -MatrixXd(rate.asDiagonal());
  return A;
}

}  // namespace

std::string nameOfShape(const LinearModel& model, const Eigen::VectorXcd& shape) {
  const Eigen::VectorXd energy = model.inertia.cwiseProduct(shape.cwiseAbs2());
  constexpr double kEqual = 0.95;  // chosen: wheelsets that mirror each other differ by round-off
  Index i = 0;
  while (energy[i] < kEqual * energy.maxCoeff()) ++i;
  return model.names[static_cast<std::size_t>(i)];
}

std::vector<Mode> computeModes(const LinearModel& model) {
  const Eigen::EigenSolver<MatrixXd> solver(stateMatrix(model));
  constexpr double kStill_radps = 1e-2;  // chosen: free motion comes out at 1e-5 by round-off
  std::vector<Mode> modes;
  for (Index i = 0; i < solver.eigenvalues().size(); ++i) {
    const std::complex<double> lambda = solver.eigenvalues()[i];
    if (lambda.imag() < kStill_radps) continue;
    Mode mode;
    mode.frequency_Hz = std::abs(lambda) / (2.0 * M_PI);  // (L2)
    mode.damping = -lambda.real() / std::abs(lambda);
    mode.shape = solver.eigenvectors().col(i).head(model.size());
    Index largest = 0;
    mode.shape.cwiseAbs().maxCoeff(&largest);
    mode.shape /= std::complex<double>(mode.shape[largest]);
    mode.name = nameOfShape(model, mode.shape);
    modes.push_back(mode);
  }
  std::sort(modes.begin(), modes.end(), [](const Mode& a, const Mode& b) { return a.frequency_Hz < b.frequency_Hz; });
  return modes;
}

}  // namespace loco
