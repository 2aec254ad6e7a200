#include "loco_dynamics/body_dynamics.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>

#include "loco_dynamics/loco_structure.hpp"

namespace {

using loco::BodyDynamics;
using loco::BodyLayout;
using loco::BodyState;
using loco::BodyVector;

const std::vector<loco::Dof> kPlanar = {loco::kX, loco::kZ, loco::kPitch};

loco::LocoStructure paperLocomotive(const std::vector<rail::Override>& overrides = {}) {
  rail::Problems problems;
  const rail::Document document =
      rail::Document::load(std::string(CONFIG_DIR) + "/bodies/co_co_134t.yaml", overrides, problems);
  const loco::LocoStructure structure = loco::LocoStructure::read(rail::YamlReader(document, problems));
  problems.throwIfAny();
  return structure;
}

BodyState atRest(const BodyDynamics& dynamics) {
  BodyState state;
  dynamics.unpack(std::vector<double>(dynamics.stateSize(), 0.0).data(), state);
  return state;
}

/// Complex eigenvalues of the planar model on wheels with linear vertical springs and dampers, free to roll without
/// friction. The yaw dampers' own states belong to the system: x' = (K/c) (d - x) on their first branch.
std::vector<std::complex<double>> eigenvalues(BodyDynamics& dynamics, double wheel_stiffness_N_per_m,
                                              double wheel_damping_N_s_per_m) {
  const auto n = static_cast<Eigen::Index>(dynamics.layout().size());
  const auto size = static_cast<Eigen::Index>(dynamics.stateSize());
  const double h = 1e-9;  // of the dampers' implicit step: short enough to be their derivative
  const auto derivative = [&](const std::vector<double>& x) {
    BodyState state;
    dynamics.unpack(x.data(), state);
    BodyVector loads{};
    for (auto& load : loads) load.setZero();
    const std::vector<double> damper_x = state.damper_x_m;
    dynamics.addInnerForces(state, h, loads);
    Eigen::VectorXd rate(size);
    rate.head(n) = Eigen::Map<const Eigen::VectorXd>(x.data() + n, n);
    Eigen::Index row = n;
    for (std::size_t i = 0; i < loads.size(); ++i) {
      if (i >= BodyLayout::wheelset(0))
        loads[i][loco::kZ] -=
            2.0 * (wheel_stiffness_N_per_m * state.q[i][loco::kZ] + wheel_damping_N_s_per_m * state.v[i][loco::kZ]);
      for (const loco::Dof dof : kPlanar)
        rate[row++] = loads[i][static_cast<Eigen::Index>(dof)] / dynamics.layout().inertia(i, dof);
    }
    for (std::size_t i = 0; i < damper_x.size(); ++i) rate[row++] = (state.damper_x_m[i] - damper_x[i]) / h;
    return rate;
  };
  Eigen::MatrixXd A(size, size);
  const double step = 1e-6;
  for (Eigen::Index j = 0; j < size; ++j) {
    std::vector<double> plus(dynamics.stateSize(), 0.0), minus(dynamics.stateSize(), 0.0);
    plus[static_cast<std::size_t>(j)] = step;
    minus[static_cast<std::size_t>(j)] = -step;
    A.col(j) = (derivative(plus) - derivative(minus)) / (2.0 * step);
  }
  const Eigen::VectorXcd values = A.eigenvalues();
  return {values.data(), values.data() + values.size()};
}

struct Mode {
  double frequency_Hz, damping;
};

std::vector<Mode> oscillations(const std::vector<std::complex<double>>& values) {
  std::vector<Mode> modes;
  for (const std::complex<double>& v : values)
    if (v.imag() > 1e-3) modes.push_back({std::abs(v) / (2.0 * M_PI), -v.real() / std::abs(v)});
  return modes;
}

TEST(BodyDynamicsTest, MassesOfThePapersLocomotiveCloseAt134Tonnes) {
  EXPECT_DOUBLE_EQ(paperLocomotive().totalMass(), 134000.0);
}

TEST(BodyDynamicsTest, ThePlanarModelHas27DegreesOfFreedomAndTheSpatial54) {
  const loco::LocoStructure s = paperLocomotive();
  EXPECT_EQ(BodyLayout(s.bodies, kPlanar).size(), 27u);
  EXPECT_EQ(BodyLayout(s.bodies, {loco::kX, loco::kY, loco::kZ, loco::kRoll, loco::kPitch, loco::kYaw}).size(), 54u);
}

TEST(BodyDynamicsTest, ElementsActOnBothBodiesSoThatNoNetForceOrMomentRemains) {
  const loco::LocoStructure s = paperLocomotive();
  BodyDynamics dynamics(BodyLayout(s.bodies, kPlanar), s.suspension);
  BodyState state = atRest(dynamics);
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {  // some distorted, moving state
    state.q[i][loco::kX] = 1e-3 * std::sin(1.0 + 2.0 * static_cast<double>(i));
    state.q[i][loco::kZ] = 2e-3 * std::cos(3.0 * static_cast<double>(i));
    state.v[i][loco::kPitch] = i < 3 ? 1e-2 * std::sin(5.0 * static_cast<double>(i)) : 0.0;
  }
  BodyVector loads{};
  for (auto& load : loads) load.setZero();
  dynamics.addInnerForces(state, 1e-3, loads);
  double F_x = 0.0, F_z = 0.0, M_y = 0.0;
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {
    F_x += loads[i][loco::kX];
    F_z += loads[i][loco::kZ] + s.bodies[i].mass_kg * 9.81;
    M_y += loads[i][loco::kPitch] + s.bodies[i].p_T.z() * loads[i][loco::kX] -
           s.bodies[i].p_T.x() * (loads[i][loco::kZ] + s.bodies[i].mass_kg * 9.81);
  }
  EXPECT_NEAR(F_x, 0.0, 1e-6);  // of element forces of 1e5 N: round-off
  EXPECT_NEAR(F_z, 0.0, 1e-6);
  // The axlebox carries no pitch of its wheelset: its moment r x F is taken by the frame's guidance.
  EXPECT_NEAR(M_y, 0.0, 1e-5);
}

/// Frictionless planar modes, linear contact 1.1 GN/m with 100 kN s/m a wheel, Table 2's dampers with the primary's 10
/// kN s/m vertically only, the chosen rubber damping off, the yaw dampers without their spring in series (here 4 GN/m,
/// near enough to none). Frequencies of the eigenvalues' magnitude in Hz and damping ratios, from an independent
/// prototype.
TEST(BodyDynamicsTest, PlanarModesAreThoseOfAnIndependentModel) {
  const loco::LocoStructure s = paperLocomotive({{"secondary.yaw_dampers.series_stiffness_N_per_m", "4e9"},
                                                 {"primary.damping.longitudinal_N_s_per_m", "0"},
                                                 {"primary.damping.lateral_N_s_per_m", "0"},
                                                 {"secondary.damping_per_bogie.longitudinal_N_s_per_m", "0"},
                                                 {"secondary.damping_per_bogie.vertical_N_s_per_m", "0"}});
  BodyDynamics dynamics(BodyLayout(s.bodies, kPlanar), s.suspension);
  std::vector<Mode> modes = oscillations(eigenvalues(dynamics, 1.1e9, 100e3));
  std::sort(modes.begin(), modes.end(), [](const Mode& a, const Mode& b) { return a.frequency_Hz < b.frequency_Hz; });
  const auto expectMode = [&](double frequency_Hz, double frequency_tolerance, double damping,
                              double damping_tolerance) {
    const bool found = std::any_of(modes.begin(), modes.end(), [&](const Mode& m) {
      return std::abs(m.frequency_Hz - frequency_Hz) <= frequency_tolerance &&
             std::abs(m.damping - damping) <= damping_tolerance;
    });
    EXPECT_TRUE(found) << frequency_Hz << " Hz, zeta " << damping;
  };
  // tolerances: half of the last digit that is quoted, doubled
  expectMode(1.348, 0.001, 0.803, 0.001);
  expectMode(1.428, 0.001, 0.276, 0.001);
  expectMode(1.482, 0.001, 0.293, 0.001);
  expectMode(1.649, 0.001, 0.979, 0.001);
  expectMode(5.78, 0.01, 0.40, 0.01);
  expectMode(15.32, 0.01, 0.116, 0.001);
  expectMode(15.41, 0.01, 0.114, 0.001);
  expectMode(25.89, 0.01, 0.0, 0.001);
  expectMode(36.0, 0.1, 0.027, 0.001);
  expectMode(128.0, 1.0, 0.040, 0.001);
  expectMode(128.0, 1.0, 0.062, 0.001);
}

}  // namespace
