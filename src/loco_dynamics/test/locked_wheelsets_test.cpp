// Car body and bogies on wheelsets that are held to the track: lateral modes, attitude in a curve, yaw stiffness.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "loco_3d_fixtures.hpp"
#include "loco_dynamics/frame_forces.hpp"

namespace {

using loco::BodyDynamics;
using loco::BodyLayout;
using loco::BodyState;
using loco::BodyVector;
using Eigen::Index;

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

TEST(LockedWheelsetsTest, Explore) {
  for (const bool g : {false, true}) {
    Locked locked(g);
    for (const Mode& m : oscillations(locked.eigenvalues())) std::printf("%.4f %.4f\n", m.frequency_Hz, m.damping);
    std::printf("\n");
  }
  Locked curve(false, fixtures::makeTrack(), 3450.0);
  for (std::size_t i = 0; i < 3; ++i)
    std::printf("%s\n", (std::ostringstream() << (curve.state.q[i]*1e3).transpose()).str().c_str());
  const BodyVector loads = curve.loadsAt(curve.state, 1e12);
  for (std::size_t i = 3; i < 9; ++i) std::printf("%s\n", (std::ostringstream() << loads[i].transpose()).str().c_str());
}

}  // namespace
