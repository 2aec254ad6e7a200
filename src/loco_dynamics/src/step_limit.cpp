#include "loco_dynamics/step_limit.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "loco_dynamics/modes.hpp"

namespace loco {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kNeutral = 1.0 + 1e-6;  // free motion is a double eigenvalue 1: round-off moves it by 1e-8

/// What the implicit yaw dampers are over a step: force c_s u with u = k_s (G q - x)/(c_s + k_s h).
VectorXd dampersEffectiveStiffness(const LinearModel& model, double h) {
  const auto k = model.damper_spring_N_per_m.array(), c = model.damper_slope_N_s_per_m.array();
  return (c * k / (c + k * h)).matrix();
}

/// One step of (I1) and (S2) as a matrix on (q, v, x), scaled by masses and h so that its entries are of one size. (L3)
MatrixXd stepMatrix(const LinearModel& model, double h) {
  const Index n = model.size(), m = model.dampers(), size = 2 * n + m;
  const MatrixXd& G = model.damper_stretch;
  const VectorXd k = dampersEffectiveStiffness(model, h);
  MatrixXd velocity = MatrixXd::Zero(n, size);  // of the new v
  velocity.leftCols(n) = -h * model.stiffness;
  velocity.middleCols(n, n) = -h * model.damping;
  if (m > 0) {
    velocity.leftCols(n) -= h * G.transpose() * k.asDiagonal() * G;
    velocity.rightCols(m) = h * G.transpose() * k.asDiagonal();
  }
  velocity = (model.inertia.cwiseInverse().asDiagonal() * velocity).eval();
  velocity.middleCols(n, n) += MatrixXd::Identity(n, n);
  MatrixXd A = MatrixXd::Zero(size, size);
  A.middleRows(n, n) = velocity;
  A.topRows(n) = h * velocity;
  A.topLeftCorner(n, n) += MatrixXd::Identity(n, n);
  VectorXd scale(size);
  scale.head(n) = model.inertia.cwiseSqrt();
  scale.segment(n, n) = h * scale.head(n);
  if (m > 0) {
    const auto k_s = model.damper_spring_N_per_m.array();
    const VectorXd rate = (h * k_s / (model.damper_slope_N_s_per_m.array() + h * k_s)).matrix();
    A.block(2 * n, 0, m, n) = rate.asDiagonal() * G;
    A.bottomRightCorner(m, m) = MatrixXd::Identity(m, m) - MatrixXd(rate.asDiagonal());
    scale.tail(m) = h * model.damper_spring_N_per_m.cwiseSqrt();
  }
  return scale.asDiagonal() * A * scale.cwiseInverse().asDiagonal();
}

/// Steps between which the spectral radius leaves 1.
struct Bracket {
  double stable_s, unstable_s;
};

Bracket findBracket(const LinearModel& model) {
  Bracket bracket{0.0, 1e-6};
  while (computeSpectralRadius(model, bracket.unstable_s) <= kNeutral) {
    bracket.stable_s = bracket.unstable_s;
    bracket.unstable_s *= 4.0;
  }
  return bracket;
}

/// Names the motion that grows fastest with a step that is too long.
void describe(const LinearModel& model, double h, StepLimit& limit) {
  const Eigen::EigenSolver<MatrixXd> solver(stepMatrix(model, h));
  Index worst = 0;
  solver.eigenvalues().cwiseAbs().maxCoeff(&worst);
  const Eigen::VectorXcd shape =
      solver.eigenvectors().col(worst).head(model.size()).cwiseQuotient(model.inertia.cwiseSqrt());
  MatrixXd K = model.stiffness;
  if (model.dampers() > 0)
    K += model.damper_stretch.transpose() * dampersEffectiveStiffness(model, h).asDiagonal() * model.damper_stretch;
  const double mass = model.inertia.dot(shape.cwiseAbs2());  // Rayleigh's quotients
  const double omega = std::sqrt(std::abs(shape.dot(K * shape)) / mass);
  limit.mode = nameOfShape(model, shape);
  limit.frequency_Hz = omega / (2.0 * M_PI);
  limit.damping = std::abs(shape.dot(model.damping * shape)) / (2.0 * omega * mass);
}

}  // namespace

double computeSpectralRadius(const LinearModel& model, double step_s) {
  const Eigen::EigenSolver<MatrixXd> solver(stepMatrix(model, step_s), false);
  return solver.eigenvalues().cwiseAbs().maxCoeff();
}

StepLimit computeStepLimit(const LinearModel& model) {
  Bracket bracket = findBracket(model);
  while (bracket.unstable_s - bracket.stable_s > 1e-4 * bracket.unstable_s) {
    const double middle = 0.5 * (bracket.stable_s + bracket.unstable_s);
    (computeSpectralRadius(model, middle) <= kNeutral ? bracket.stable_s : bracket.unstable_s) = middle;
  }
  StepLimit limit;
  limit.stable_s = bracket.stable_s;
  describe(model, 1.01 * bracket.unstable_s, limit);
  return limit;
}

}  // namespace loco
