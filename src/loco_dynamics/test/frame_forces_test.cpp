#include "loco_dynamics/frame_forces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "loco_3d_fixtures.hpp"

namespace {

using loco::BodyLayout;
using loco::BodyVector;
using loco::TrackFrames;

constexpr double kKappa_1pm = 1.0 / 300.0, kSlope_1pm2 = kKappa_1pm / 50.0, kSpeed_mps = 10.0;

BodyLayout layout() {
  return BodyLayout(fixtures::readFile("/bodies/co_co_134t.yaml", loco::LocoStructure::read).bodies,
                    {loco::kX, loco::kY, loco::kZ, loco::kRoll, loco::kPitch, loco::kYaw});
}

BodyVector zero() {
  BodyVector x;
  for (auto& body : x) body.setZero();
  return x;
}

BodyVector running(double v_mps) {
  BodyVector v = zero();
  for (auto& body : v) body[loco::kX] = v_mps;
  return v;
}

TrackFrames framesAt(const BodyLayout& bodies, const rail::Track& track, double s_m) {
  TrackFrames frames(bodies, &track);
  BodyVector q = zero();
  for (auto& body : q) body[loco::kX] = s_m;
  frames.place(q);
  return frames;
}

TEST(FrameForcesTest, InACurveBodiesArePushedOutwardsWithMV2Kappa) {
  const BodyLayout bodies = layout();
  const auto track = fixtures::makeTrack("left");
  BodyVector loads = zero();
  loco::addFrameForces(bodies, framesAt(bodies, *track, 3450.0), running(kSpeed_mps), 0.0, loads);
  EXPECT_NEAR(loads[0][loco::kY], -91600.0 * 100.0 * kKappa_1pm, 1e-6);
  EXPECT_EQ(loads[0][loco::kZ], 0.0);
}

TEST(FrameForcesTest, CantPullsInwardsAndPressesDown) {
  const BodyLayout bodies = layout();
  const auto track = fixtures::makeTrack("left", 150.0);
  BodyVector loads = zero();
  loco::addFrameForces(bodies, framesAt(bodies, *track, 3450.0), running(kSpeed_mps), 0.0, loads);
  const double angle = std::asin(0.1), m = 91600.0, a = 100.0 * kKappa_1pm;
  EXPECT_NEAR(loads[0][loco::kY], m * (9.81 * std::sin(angle) - a * std::cos(angle)), 1e-6);
  EXPECT_NEAR(loads[0][loco::kZ], m * (9.81 * (1.0 - std::cos(angle)) - a * std::sin(angle)), 1e-6);
}

TEST(FrameForcesTest, ASpinningWheelsetThatIsTurnedLeftRollsToItsRightSideDown) {
  // dL/dt = Omega x L, L = H along the axle (left): Omega_z x L points backward, so the body feels H Omega_z forward
  const BodyLayout bodies = layout();
  const auto track = fixtures::makeTrack("left");
  BodyVector v = running(kSpeed_mps), loads = zero();
  const std::size_t set = BodyLayout::wheelset(2);
  v[set][loco::kPitch] = 20.0;
  v[set][loco::kYaw] = 0.01;
  v[set][loco::kRoll] = 0.03;
  loco::addFrameForces(bodies, framesAt(bodies, *track, 3450.0), v, 250.0, loads);
  EXPECT_NEAR(loads[set][loco::kRoll], 5000.0 * (0.01 + kSpeed_mps * kKappa_1pm), 1e-9);
  EXPECT_NEAR(loads[set][loco::kYaw], -5000.0 * 0.03, 1e-9);
  EXPECT_EQ(loads[1][loco::kRoll], 0.0);  // a bogie frame does not spin
}

TEST(FrameForcesTest, OverARunOffASpinningWheelsetIsTurnedByItsFramesRoll) {
  // Omega_x x L points up (x cross y), so the body feels H Omega_x about -z; to the left curve the left rail goes down
  const BodyLayout bodies = layout();
  const auto track = fixtures::makeTrack("left", 150.0);
  BodyVector v = running(kSpeed_mps), loads = zero();
  const std::size_t set = BodyLayout::wheelset(2);
  v[set][loco::kPitch] = 20.0;
  const TrackFrames frames = framesAt(bodies, *track, 3325.0);
  loco::addFrameForces(bodies, frames, v, 250.0, loads);
  const double roll_rate = kSpeed_mps * -0.003 / (1.5 * std::cos(frames[set].roll_rad));
  EXPECT_NEAR(loads[set][loco::kYaw], -5000.0 * roll_rate, 1e-9);
}

/// Turning forces in a step of 1 ms.
BodyVector turning(const BodyLayout& bodies, const rail::Track& track, double s_m, double v_mps, double a_mps2) {
  const double h = 1e-3, v_next = v_mps + h * a_mps2;
  BodyVector loads = zero();
  loco::addTurningForces(bodies, framesAt(bodies, track, s_m), framesAt(bodies, track, s_m + h * v_next),
                         running(v_mps), running(v_next), h, loads);
  return loads;
}

TEST(FrameForcesTest, InATransitionBodiesResistTheFramesYaw) {
  const BodyLayout bodies = layout();
  const auto track = fixtures::makeTrack("left");
  const double I = 3772695.0, kappa = 25.0 * kSlope_1pm2;
  const BodyVector steady = turning(bodies, *track, 3325.0, kSpeed_mps, 0.0);
  EXPECT_NEAR(steady[0][loco::kYaw], -I * 100.0 * kSlope_1pm2, 1e-4);  // v^2 kappa'; of 2.5e4 N m
  const BodyVector faster = turning(bodies, *track, 3325.0, kSpeed_mps, 0.5);
  EXPECT_NEAR(faster[0][loco::kYaw] - steady[0][loco::kYaw], -I * 0.5 * kappa, 3.0);  // v' kappa, and h v' v kappa'
}

TEST(FrameForcesTest, OverARunOffBodiesResistTheFramesRollAndRise) {
  const BodyLayout bodies = layout();
  const auto track = fixtures::makeTrack("left", 150.0);
  // at the beginning of the run-off the slope rises from 0 to 0.003 over 3 m
  const double bend_1pm = 0.003 / 3.0;
  const BodyVector loads = turning(bodies, *track, 3300.0, kSpeed_mps, 0.0);
  const double roll_rate = -bend_1pm / 1.5 * 100.0;
  EXPECT_NEAR(loads[0][loco::kRoll], -177095.0 * roll_rate, 0.03);  // of 1.2e4: the cant's angle, squared
  EXPECT_NEAR(loads[0][loco::kY], 91600.0 * 1.93 * roll_rate, 0.03);
  EXPECT_NEAR(loads[0][loco::kZ], -91600.0 * 0.5 * bend_1pm * 100.0, 1e-3);
}

TEST(TrackFramesTest, GapsHaveTheirRates) {
  const BodyLayout bodies = layout();
  const auto track = fixtures::makeTrack("right", 120.0);
  const BodyVector v = running(kSpeed_mps);
  for (const double s_m : {3301.0, 3325.0, 3348.0, 3450.0}) {
    const double h = 1e-5;
    TrackFrames before = framesAt(bodies, *track, s_m - h * kSpeed_mps);
    TrackFrames here = framesAt(bodies, *track, s_m), after = framesAt(bodies, *track, s_m + h * kSpeed_mps);
    for (TrackFrames* frames : {&before, &here, &after}) frames->computeGaps(v);
    for (std::size_t i = 0; i < here.gaps().size(); ++i) {
      const auto &a = after.gaps()[i].at, &b = before.gaps()[i].at, &rate = here.gaps()[i].rate;
      EXPECT_NEAR((a.heading_rad - b.heading_rad) / (2.0 * h), rate.heading_rad, 1e-7) << s_m << " " << i;
      EXPECT_NEAR((a.lateral_m - b.lateral_m) / (2.0 * h), rate.lateral_m, 1e-7) << s_m << " " << i;
      EXPECT_NEAR((a.roll_rad - b.roll_rad) / (2.0 * h), rate.roll_rad, 1e-6) << s_m << " " << i;
      EXPECT_NEAR((a.height_m - b.height_m) / (2.0 * h), rate.height_m, 1e-6) << s_m << " " << i;
    }
  }
}

}  // namespace
