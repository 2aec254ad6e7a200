// Forces of suspension elements between bodies whose track frames are turned against each other: (S3).

#include "loco_dynamics/suspension.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using Eigen::Vector3d;
using loco::BodyLayout;
using loco::BodyVector;

constexpr std::size_t kSet = BodyLayout::wheelset(0), kBogie = BodyLayout::bogie(0);
constexpr double kStiffness_N_per_m = 1e6, kDamping_N_s_per_m = 1e4, kTiny = 1e-9;

BodyVector zero() {
  BodyVector x;
  for (auto& body : x) body.setZero();
  return x;
}

/// One element between the first wheelset and its bogie, which acts in one direction, and the gap of their frames.
struct Pair {
  explicit Pair(loco::Dof direction) {
    loco::SpringDamper element;
    element.body_A = kSet;
    element.body_B = kBogie;
    element.stiffness_N_per_m[static_cast<Eigen::Index>(direction)] = kStiffness_N_per_m;
    element.damping_N_s_per_m[static_cast<Eigen::Index>(direction)] = kDamping_N_s_per_m;
    element.spins_A = true;
    suspension.springs.push_back(element);
  }
  BodyVector loads(const BodyVector& q) {
    loco::SuspensionWorkspace workspace(suspension);
    BodyVector sum = zero();
    addSuspensionForces(suspension, q, zero(), 1e-3, {&gaps, false}, nullptr, workspace, sum);
    return sum;
  }
  loco::FrameGap& gap() { return gaps[loco::gapIndex(kSet, kBogie)]; }
  loco::SpringDamper& element() { return suspension.springs.front(); }
  loco::Suspension suspension;
  loco::FrameGaps gaps{};
};

TEST(SuspensionTest, ALongitudinalForceActsAlongTheBogieHoweverTheWheelsetsFrameIsTurned) {
  Pair pair(loco::kX);
  const double theta = 0.006, yaw = 0.02, F = 1e-3 * kStiffness_N_per_m;
  pair.gap().at.heading_rad = theta;
  BodyVector q = zero();
  q[kSet][loco::kX] = -1e-3;  // the bogie pulls it forward
  q[kBogie][loco::kYaw] = yaw;
  const BodyVector loads = pair.loads(q);
  // the bogie's axis points to the left of its own frame by its yaw, and of the wheelset's by theta less
  EXPECT_NEAR(loads[kSet][loco::kX], F, kTiny);
  EXPECT_NEAR(loads[kSet][loco::kY], F * (yaw - theta), kTiny);
  EXPECT_NEAR(loads[kBogie][loco::kX], -F, kTiny);
  EXPECT_NEAR(loads[kBogie][loco::kY], -F * yaw, kTiny);
}

TEST(SuspensionTest, AcrossTurnedFramesActionIsReaction) {
  for (const loco::Dof direction : {loco::kX, loco::kY, loco::kZ}) {
    Pair pair(direction);
    loco::FrameGap::Parts& gap = pair.gap().at;
    gap.heading_rad = 0.006;
    gap.roll_rad = 0.004;
    BodyVector q = zero();
    q[kSet][static_cast<Eigen::Index>(direction)] = -1e-3;
    q[kBogie][loco::kYaw] = 0.02;
    const BodyVector loads = pair.loads(q);
    const Vector3d on_A = loads[kSet].head<3>(), on_B = loads[kBogie].head<3>();
    // a vector of the wheelset's frame as the bogie's frame sees it: turned by the heading and the roll
    const Vector3d turned = on_A + Vector3d(gap.roll_rad, 0.0, gap.heading_rad).cross(on_A);
    EXPECT_GT(on_A.norm(), 990.0);
    EXPECT_NEAR(turned.y() + on_B.y(), 0.0, 0.1) << direction;  // 1 kN by the angles' square, 1e-4
    EXPECT_NEAR(turned.z() + on_B.z(), 0.0, 0.1) << direction;
  }
}

TEST(SuspensionTest, WhereItsRailsAreTwistedAWheelsetsLeftEndRisesAndIsPushedDown) {
  Pair pair(loco::kZ);
  pair.element().r_A = {0.0, 1.078, 0.0};
  pair.gap().at.roll_rad = 0.004;  // left rail up
  pair.gap().rate.roll_rad = 0.03;
  EXPECT_NEAR(pair.loads(zero())[kSet][loco::kZ], -1.078 * (0.004 * kStiffness_N_per_m + 0.03 * kDamping_N_s_per_m),
              kTiny);
}

TEST(SuspensionTest, WhereItsRailsAreTwistedWhatIsAboveThemMovesToTheRightAndIsPushedBack) {
  Pair pair(loco::kY);
  pair.gap().cog_height_A_m = 0.5;
  pair.element().r_A = {0.0, 0.0, 0.1};
  pair.gap().at.roll_rad = 0.004;
  pair.gap().rate.roll_rad = 0.03;
  EXPECT_NEAR(pair.loads(zero())[kSet][loco::kY], 0.6 * (0.004 * kStiffness_N_per_m + 0.03 * kDamping_N_s_per_m),
              kTiny);
}

TEST(SuspensionTest, AWheelsetThatTheRailsRaiseIsPushedDown) {
  Pair pair(loco::kZ);
  pair.gap().at.height_m = 1e-3;
  EXPECT_NEAR(pair.loads(zero())[kSet][loco::kZ], -1e-3 * kStiffness_N_per_m, kTiny);
  EXPECT_NEAR(pair.loads(zero())[kBogie][loco::kZ], 1e-3 * kStiffness_N_per_m, kTiny);
}

TEST(SuspensionTest, AWheelsetThatTheTrackMovesToTheLeftIsPulledBackAndItsLeftEndHeldForward) {
  Pair lateral(loco::kY), longitudinal(loco::kX);
  lateral.gap().at.lateral_m = 1e-3;
  EXPECT_NEAR(lateral.loads(zero())[kSet][loco::kY], -1e-3 * kStiffness_N_per_m, kTiny);
  longitudinal.element().r_A = {0.0, 1.078, 0.0};
  longitudinal.gap().at.heading_rad = 0.006;  // turned left, its left end lies further back
  EXPECT_NEAR(longitudinal.loads(zero())[kSet][loco::kX], 1.078 * 0.006 * kStiffness_N_per_m, kTiny);
}

}  // namespace
