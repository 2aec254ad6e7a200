// Car body and bogies on wheelsets that are held to the track: lateral modes, attitude in a curve, yaw stiffness.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <string>

#include "loco_3d_fixtures.hpp"
#include "loco_dynamics/frame_forces.hpp"
#include "rail_core/testing/verification.hpp"

namespace {

using Eigen::Index;
using loco::BodyDynamics;
using loco::BodyLayout;
using loco::BodyState;
using loco::BodyVector;

constexpr Index kFree = 3 * 6;  // car body and two bogie frames

/// Table 2's dampers, the primary's 10 kN s/m in all directions; without what was chosen for the rubber.
loco::LocoStructure tableTwo(const std::vector<rail::Override>& more = {}) {
  std::vector<rail::Override> overrides = {{"secondary.damping_per_bogie.longitudinal_N_s_per_m", "0"},
                                           {"secondary.damping_per_bogie.lateral_N_s_per_m", "0"},
                                           {"secondary.damping_per_bogie.vertical_N_s_per_m", "0"}};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return fixtures::readFile("/bodies/co_co_134t.yaml", loco::LocoStructure::read, overrides);
}

/// The locomotive with locked wheelsets at a place of a track, v -> 0.
class Locked {
 public:
  explicit Locked(bool gravity_stiffness, std::shared_ptr<const rail::Track> track = nullptr, double s_m = 3000.0,
                  const loco::LocoStructure& structure = tableTwo())
      : structure_(structure),
        dynamics_(BodyLayout(structure.bodies, {loco::kX, loco::kY, loco::kZ, loco::kRoll, loco::kPitch, loco::kYaw}),
                  structure.suspension),
        track_(std::move(track)),
        frames_(dynamics_.layout(), track_.get()),
        gravity_stiffness_(gravity_stiffness) {
    dynamics_.unpack(std::vector<double>(dynamics_.stateSize(), 0.0).data(), state);
    for (auto& q : state.q) q[loco::kX] = s_m;
    frames_.place(state.q);
    frames_.computeGaps(state.v);
    settle();
  }

  loco::Placement placement() const { return {&frames_.gaps(), gravity_stiffness_}; }

  BodyVector loadsAt(BodyState at, double h, BodyState* after = nullptr) {
    BodyVector loads;
    for (auto& load : loads) load.setZero();
    dynamics_.addInnerForces(at, h, loads, placement());
    if (after != nullptr) *after = at;
    return loads;
  }

  /// Complex eigenvalues about the settled state, with the yaw dampers' own states.
  Eigen::VectorXcd eigenvalues() {
    constexpr double h = 1e-9;  // of the dampers' implicit step: short enough to be their derivative
    const auto dampers = static_cast<Index>(state.damper_x_m.size());
    const Index size = 2 * kFree + dampers;
    const auto rate = [&](const Eigen::VectorXd& x) {
      BodyState at = state, after;
      for (Index i = 0; i < kFree; ++i) {
        at.q[static_cast<std::size_t>(i / 6)][i % 6] += x[i];
        at.v[static_cast<std::size_t>(i / 6)][i % 6] += x[kFree + i];
      }
      for (Index i = 0; i < dampers; ++i) at.damper_x_m[static_cast<std::size_t>(i)] += x[2 * kFree + i];
      const BodyVector loads = loadsAt(at, h, &after);
      Eigen::VectorXd out(size);
      for (Index i = 0; i < kFree; ++i) {
        const auto body = static_cast<std::size_t>(i / 6);
        out[i] = x[kFree + i];
        out[kFree + i] = loads[body][i % 6] / dynamics_.layout().inertia(body, static_cast<loco::Dof>(i % 6));
      }
      for (Index i = 0; i < dampers; ++i) {
        const auto k = static_cast<std::size_t>(i);
        out[2 * kFree + i] = (after.damper_x_m[k] - at.damper_x_m[k]) / h;
      }
      return out;
    };
    Eigen::MatrixXd A(size, size);
    constexpr double kStep = 1e-6;
    for (Index j = 0; j < size; ++j) {
      const Eigen::VectorXd d = kStep * Eigen::VectorXd::Unit(size, j);
      A.col(j) = (rate(d) - rate(-d)) / (2.0 * kStep);
    }
    return A.eigenvalues();
  }

  BodyState state;

 private:
  /// Newton's method on the free bodies; the yaw dampers follow without force.
  void settle() {
    for (int iteration = 0; iteration < 30; ++iteration) {
      const Eigen::VectorXd loads = flat(state);
      if (loads.cwiseAbs().maxCoeff() < 1e-6) break;
      Eigen::MatrixXd jacobian(kFree, kFree);
      for (Index j = 0; j < kFree; ++j) {
        BodyState moved = state;
        moved.q[static_cast<std::size_t>(j / 6)][j % 6] += 1e-7;
        jacobian.col(j) = (flat(moved) - loads) / 1e-7;
      }
      const Eigen::VectorXd step = jacobian.partialPivLu().solve(-loads);
      for (Index j = 0; j < kFree; ++j) state.q[static_cast<std::size_t>(j / 6)][j % 6] += step[j];
    }
    loadsAt(state, 1e12, &state);
  }
  Eigen::VectorXd flat(const BodyState& at) {
    const BodyVector loads = loadsAt(at, 1e12);
    Eigen::VectorXd out(kFree);
    for (Index i = 0; i < kFree; ++i) out[i] = loads[static_cast<std::size_t>(i / 6)][i % 6];
    return out;
  }

  loco::LocoStructure structure_;
  BodyDynamics dynamics_;
  std::shared_ptr<const rail::Track> track_;
  loco::TrackFrames frames_;
  bool gravity_stiffness_;
};

struct Mode {
  double frequency_Hz, damping;
};

std::vector<Mode> oscillations(const Eigen::VectorXcd& values) {
  std::vector<Mode> modes;
  for (const std::complex<double>& v : values)
    if (v.imag() > 1e-3) modes.push_back({std::abs(v) / (2.0 * M_PI), -v.real() / std::abs(v)});
  std::sort(modes.begin(), modes.end(), [](const Mode& a, const Mode& b) { return a.frequency_Hz < b.frequency_Hz; });
  return modes;
}

void expectMode(const std::vector<Mode>& modes, const std::string& name, double frequency_Hz, double damping) {
  const double digit_Hz = frequency_Hz < 20.0 ? 1e-3 : 1e-2;
  const auto distance = [&](const Mode& m) {
    return std::abs(m.frequency_Hz - frequency_Hz) / digit_Hz + std::abs(m.damping - damping) / 1e-3;
  };
  const Mode& m = *std::min_element(modes.begin(), modes.end(),
                                    [&](const Mode& x, const Mode& y) { return distance(x) < distance(y); });
  rail::verify({"9", "wheelsets locked: " + name + ", frequency", "independent model", "Hz", frequency_Hz,
                m.frequency_Hz, 0.51 * digit_Hz, "half of the last digit given"});
  rail::verify({"9", "wheelsets locked: " + name + ", damping ratio", "independent model", "1", damping, m.damping,
                0.51e-3, "half of the last digit given"});
}

/// From an independent prototype: sway, car yaw, bogie lateral, bogie yaw, bogie roll.
TEST(LockedWheelsetsTest, LateralModesAreThoseOfAnIndependentModel) {
  const std::vector<Mode> modes = oscillations(Locked(false).eigenvalues());
  expectMode(modes, "lower sway", 0.662, 0.115);
  expectMode(modes, "car yaw", 0.921, 0.150);
  expectMode(modes, "upper sway", 1.577, 0.269);
  expectMode(modes, "bogies lateral, in phase", 5.836, 0.176);
  expectMode(modes, "bogies lateral, in antiphase", 5.857, 0.178);
  expectMode(modes, "bogies yaw, in phase", 15.592, 0.082);
  expectMode(modes, "bogies yaw, in antiphase", 15.594, 0.081);
  expectMode(modes, "bogies roll, first", 26.67, 0.220);
  expectMode(modes, "bogies roll, second", 27.20, 0.204);
}

TEST(LockedWheelsetsTest, GravitysStiffnessSlowsTheLowerSwayAndHastensTheUpper) {
  const std::vector<Mode> modes = oscillations(Locked(true).eigenvalues());
  expectMode(modes, "lower sway with gravity's stiffness", 0.615, 0.126);
  expectMode(modes, "upper sway with gravity's stiffness", 1.592, 0.265);
}

TEST(LockedWheelsetsTest, InR300TheCarIsAChordAndTheBogiesTurnOverTheirOuterAxles) {
  for (const double side : {1.0, -1.0}) {  // to the left, to the right
    Locked curve(false, fixtures::makeTrack(side > 0.0 ? "left" : "right"), 3450.0);
    const std::string place = side > 0.0 ? "locked in R300 left, " : "locked in R300 right, ";
    const auto& q = curve.state.q;
    rail::verify({"9", place + "car inward", "independent model", "mm", 77.43, 1e3 * side * q[0][loco::kY], 5.1e-3,
                  "half of the last digit given"});
    for (const std::size_t bogie : {1u, 2u}) {
      const std::string name = place + "bogie " + std::to_string(bogie);
      rail::verify({"9", name + " inward", "independent model", "mm", 3.803, 1e3 * side * q[bogie][loco::kY], 5.1e-4,
                    "half of the last digit given"});
      rail::verify({"9", name + " yaw", "independent model", "mrad", bogie == 1 ? -0.1966 : 0.1966,
                    1e3 * side * q[bogie][loco::kYaw], 1e-4, "last digit given"});
    }
    const double expected_kN[3] = {-10.19, 17.11, -6.92};
    const BodyVector loads = curve.loadsAt(curve.state, 1e12);
    for (std::size_t axle = 0; axle < 3; ++axle)
      rail::verify({"9", place + "primary on wheelset " + std::to_string(axle + 1), "independent model", "kN",
                    expected_kN[axle], 1e-3 * side * loads[BodyLayout::wheelset(axle)][loco::kY], 5.1e-3,
                    "half of the last digit given"});
  }
}

TEST(LockedWheelsetsTest, TheSprungCarTurnsABogieBackWithThreeMeganewtonMetresPerRadian) {
  Locked locked(false);
  BodyState turned = locked.state;
  turned.q[1][loco::kYaw] += 1e-3;
  turned.damper_x_m.assign(turned.damper_x_m.size(), 0.0);
  const double moment_N_m = locked.loadsAt(turned, 1e12)[0][loco::kYaw];
  rail::verify({"9", "secondary yaw stiffness of a bogie", "sum of k_y x^2 + k_x y^2", "MN m/rad", 3.083,
                1e-3 * moment_N_m, 5.1e-4, "half of the last digit given"});
}

TEST(LockedWheelsetsTest, InAStandingCantEveryBodyLeansWithItsTrack) {
  // where cant is constant, frames have no gaps: only gravity's lateral part acts, which is not among inner forces
  Locked canted(true, fixtures::makeTrack("left", 100.0), 3450.0);
  Locked level(true, fixtures::makeTrack("left", 0.0), 3450.0);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR((canted.state.q[i] - level.state.q[i]).cwiseAbs().maxCoeff(), 0.0, 1e-12) << i;
}

}  // namespace
