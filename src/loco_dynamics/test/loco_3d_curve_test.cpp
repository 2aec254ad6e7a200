// The 3D locomotive in R300 on S1002 wheels and UIC60 rails.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "loco_3d_fixtures.hpp"
#include "loco_dynamics/profile/contact_search.hpp"
#include "rail_core/testing/verification.hpp"

namespace {

using fixtures::Ride3d;
using loco::BodyLayout;
using loco::Loco3d;

constexpr double kKappa_1pm = 1.0 / 300.0, kSpeed_mps = 8.85, kMass_kg = 134000.0, kGravity_mps2 = 9.81;

Loco3d::Parameters onProfiles(const std::string& direction = "left", double cant_mm = 0.0) {
  Loco3d::Parameters p = fixtures::paperParameters3d();
  static const auto finder = fixtures::finderOf(loco::ContactSearch(loco::WheelRailGeometry()));
  p.finder = finder;
  p.track = fixtures::makeTrack(direction, cant_mm);
  return p;
}

struct WheelForces {
  double lateral_N = 0.0, left_N = 0.0, right_N = 0.0;
};

WheelForces sumOf(const loco::LocoTraction& answer) {
  WheelForces sum;
  for (const loco::AxleAdhesion& axle : answer.adhesion.axles) {
    sum.lateral_N += axle.lateral_force_N[0] + axle.lateral_force_N[1];
    sum.left_N += axle.vertical_force_N[0];
    sum.right_N += axle.vertical_force_N[1];
  }
  return sum;
}

TEST(Loco3dCurveTest, TheRailsTurnItWithItsMassTimesTheAcceleration) {
  Ride3d ride(onProfiles(), kSpeed_mps, 3450.0);
  ride.run(0.2);
  const double expected_N = kMass_kg * ride.answer.speed_mps * ride.answer.speed_mps * kKappa_1pm;  // 34.99 kN
  EXPECT_NEAR(sumOf(ride.answer).lateral_N, expected_N, 10.0);
  rail::verify({"10", "R300, 8.85 m/s: sum of lateral forces", "m v^2/R", "kN", 34.99,
                1e-3 * sumOf(ride.answer).lateral_N, 0.02, "it coasts and has lost 1 mm/s"});
}

/// A coupler pulls along the track's tangent where it is: in draft both ends pull the car body inwards by F 11/R, in
/// buff outwards. The rails take the rest of m v^2/R.
TEST(Loco3dCurveTest, CouplersPullInwardsInDraftAndOutwardsInBuff) {
  constexpr double kForce_N = 1344e3;
  for (const double sign : {1.0, -1.0}) {
    Ride3d ride(onProfiles(), kSpeed_mps, 3450.0);
    const int ramp = 1000, settled = 2000, end = 3000;  // steps of 2 ms
    double lateral_N = 0.0, needed_N = 0.0;
    for (int i = 1; i <= end; ++i) {
      ride.force.coupler_front_N = sign * kForce_N * std::min(1.0, static_cast<double>(i) / ramp);
      ride.force.coupler_rear_N = -ride.force.coupler_front_N;
      ride.step();
      if (i <= settled) continue;
      lateral_N += sumOf(ride.answer).lateral_N / (end - settled);
      needed_N += kMass_kg * ride.answer.speed_mps * ride.answer.speed_mps * kKappa_1pm / (end - settled);
    }
    rail::verify({"10", std::string("R300, ") + (sign > 0.0 ? "draft" : "buff") + " of 1344 kN: sum of lateral forces",
                  "m v^2/R less 2 F 11 m/R", "kN", 1e-3 * (needed_N - sign * 2.0 * kForce_N * 11.0 * kKappa_1pm),
                  1e-3 * lateral_N, 1.0, "mean over 2 s of a sway of 0.6 Hz that still swings by 2 kN in draft"});
  }
}

/// Load transfer from the inner to the outer wheels: from an independent prototype, 48.9 with gravity's stiffness and
/// 39.6 without.
TEST(Loco3dCurveTest, LoadMovesToTheOuterWheels) {
  for (const bool gravity_stiffness : {true, false}) {
    Loco3d::Parameters p = onProfiles();
    p.gravity_stiffness = gravity_stiffness;
    Ride3d ride(p, kSpeed_mps, 3450.0);
    ride.run(0.2);
    const WheelForces sum = sumOf(ride.answer);
    rail::verify({"10",
                  std::string("R300, 8.85 m/s: load transfer") + (gravity_stiffness ? ", gravity's stiffness" : ""),
                  "independent model", "kN", gravity_stiffness ? 48.9 : 39.6, 0.5e-3 * (sum.right_N - sum.left_N), 0.12,
                  "two units of the last digit given"});
    EXPECT_NEAR(sum.right_N + sum.left_N, fixtures::kWeight_N, 5.0);
  }
}

/// Moment about the track's centre line at the rail tops, over all bodies' own frames: what the contacts give carries
/// weights and centrifugal forces, and what weights gain by the frames' offsets.
TEST(Loco3dCurveTest, TheMomentAboutTheTracksCentreCloses) {
  Loco3d::Parameters p = onProfiles();
  Ride3d ride(p, kSpeed_mps, 3450.0);
  ride.run(0.2);
  const loco::BodyState s = ride.bodies();
  const double v = ride.answer.speed_mps;
  double moment_N_m = 0.0;
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {
    const loco::Body& body = p.structure.bodies[i];
    const double arc_m = -0.5 * kKappa_1pm * body.p_T.x() * body.p_T.x();  // of the frame, from the tangent's height
    const double height_m = i >= BodyLayout::wheelset(0) ? body.p_T.z() + s.q[i][loco::kZ] : body.p_T.z();
    moment_N_m -= (s.q[i][loco::kY] - arc_m) * body.mass_kg * kGravity_mps2;
    moment_N_m += height_m * body.mass_kg * v * v * kKappa_1pm;
    if (i < BodyLayout::wheelset(0)) continue;
    moment_N_m += p.structure.spin_momentum_inertia_kg_m2 * s.v[i][loco::kPitch] * v * kKappa_1pm;
    const auto& contacts = ride.locomotive.contacts(i - BodyLayout::wheelset(0));
    for (std::size_t k = 0; k < contacts.count; ++k) {
      const Eigen::Vector3d F = contacts.list[k].force_N(), at = contacts.list[k].region.p_T;
      moment_N_m += (at.y() - arc_m) * F.z() - at.z() * F.y();
    }
  }
  rail::verify({"10", "R300, 8.85 m/s: moment about the track's centre", "equilibrium", "kN m", 0.0, 1e-3 * moment_N_m,
                0.02, "as an independent model closes; angles of the frames, squared"});
}

TEST(Loco3dCurveTest, AtItsEquilibriumCantNothingPullsOutwards) {
  // v^2 kappa S/g = 39.9 mm
  const double cant_mm = 1e3 * kSpeed_mps * kSpeed_mps * kKappa_1pm * 1.5 / kGravity_mps2;
  Ride3d ride(onProfiles("left", cant_mm), kSpeed_mps, 3450.0);
  ride.run(0.2);
  const WheelForces sum = sumOf(ride.answer);
  EXPECT_NEAR(sum.lateral_N, 0.0, 50.0);                      // the small angle of the cant, cubed, and the coasting
  EXPECT_NEAR(0.5 * (sum.right_N - sum.left_N), 0.0, 1.9e3);  // what standing in the curve without cant gives
  rail::verify({"10", "equilibrium cant at 8.85 m/s", "v^2 S/(R g)", "mm", 40.0, cant_mm, 0.2, "rounded"});
}

TEST(Loco3dCurveTest, AMirroredCurveHasTheMirroredAnswer) {
  Ride3d left(onProfiles("left"), kSpeed_mps, 3295.0), right(onProfiles("right"), kSpeed_mps, 3295.0);
  for (Ride3d* ride : {&left, &right}) {
    ride->force.traction_reference_N = 300e3;
    ride->force.coupler_rear_N = -250e3;
    ride->run(3.0);
  }
  rail::verify({"9", "transition into R300, mirrored: traction to the right", "to the left", "N",
                left.answer.traction_N, right.answer.traction_N, 1e-3, "round-off of 3e5 N"});
  double largest = 0.0;
  const loco::BodyState a = left.bodies(), b = right.bodies();
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {
    for (const loco::Dof dof : {loco::kY, loco::kRoll, loco::kYaw})
      largest = std::max(largest, std::abs(a.q[i][dof] + b.q[i][dof]));
    largest = std::max(largest, std::abs(a.q[i][loco::kZ] - b.q[i][loco::kZ]));
  }
  rail::verify({"9", "transition into R300, mirrored: largest difference in y, z, roll, yaw", "exact", "m or rad", 0.0,
                largest, 1e-10, "round-off of the contacts' search"});
  EXPECT_GT(std::abs(a.q[0][loco::kY]), 5e-3);
}

TEST(Loco3dCurveTest, ThroughTheTransitionItKeepsTheSpeedOfLtdAndItsAccount) {
  Ride3d ride(onProfiles(), 8.0, 3290.0);
  ride.force.traction_reference_N = 490e3;
  double drift_mps = 0.0;
  for (int i = 0; i < 4000; ++i) {
    ride.step();
    ride.force.coupler_rear_N = -ride.answer.traction_N;
    drift_mps = std::max(drift_mps, std::abs(ride.answer.speed_mps - ride.ltd_speed));
  }
  rail::verify({"7", "3D through the transition into R300: largest drift of the CoG against LTD in 8 s", "exact", "m/s",
                0.0, drift_mps, 1e-10, "round-off"});
  EXPECT_GT(ride.sum.motors, 2e7);
  rail::verify({"7", "3D through the transition into R300: residual over the motors' work", "exact", "1", 0.0,
                ride.sum.residual() / ride.sum.motors, 1e-5, "asked for; works use the mean of a step's speeds"});
  EXPECT_LT(std::abs(ride.sum.frames), 1e-3 * ride.sum.motors);  // what the small-angle frames leave out of the account
}

/// What spins drives on: sum F (1 + 6 J/(m r^2)) is the curving resistance, 514 N as in the next test.
TEST(Loco3dCurveTest, CoastingItsSpinningWheelsetsBearAPartOfTheCurvingResistance) {
  Ride3d ride(onProfiles(), kSpeed_mps, 3450.0);
  ride.run(1.0);
  const double spin = 6.0 * 1432.0 / (kMass_kg * 0.5335 * 0.5335);
  EXPECT_NEAR(-ride.answer.traction_N * (1.0 + spin), 514.0, 5.0);
}

/// Held at 8.85 m/s by a grade that pulls with the curving resistance, 8 s long: nothing moves any more.
TEST(Loco3dCurveTest, InSteadyCurvingForcesAndMomentsBalanceToRoundOff) {
  const Loco3d::Parameters p = onProfiles();
  Ride3d ride(p, kSpeed_mps, 3360.0);
  for (int i = 0; i < 4000; ++i) {
    ride.step();
    ride.force.grade_N = -ride.answer.traction_N;
  }
  const loco::BodyState before = ride.bodies();
  ride.step();
  const loco::BodyState s = ride.bodies();
  double largest = 0.0;  // of what is left on a body to move it, in y, z, roll and yaw
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i)
    for (const loco::Dof dof : {loco::kY, loco::kZ, loco::kRoll, loco::kYaw})
      largest = std::max(largest, std::abs((s.v[i][dof] - before.v[i][dof]) / 2e-3 *
                                           ride.locomotive.dynamics().layout().inertia(i, dof)));
  rail::verify({"10", "steady R300: largest unbalanced force or moment on a body", "equilibrium", "N or N m", 0.0,
                largest, 1e-2, "round-off of springs under 1 MN"});
  const double v = ride.answer.speed_mps;
  const WheelForces sum = sumOf(ride.answer);
  rail::verify({"10", "steady R300: sum of wheel loads", "weight", "N", fixtures::kWeight_N, sum.left_N + sum.right_N,
                1e-4, "round-off of 1.3e6 N"});
  // a force along the track turns from frame to frame
  rail::verify({"10", "steady R300: sum of lateral forces", "m v^2/R", "N", kMass_kg * v * v * kKappa_1pm,
                sum.lateral_N, 10.0, "0.5 kN of curving resistance by 22 mrad between the frames"});
  // Eq. (6) would say 2.7 kN; with k0 = 0.075 the contacts make less
  rail::verify({"10", "steady R300: curving resistance of the contacts", "independent model: 0.5 to 1.3 kN", "kN", 0.9,
                -1e-3 * ride.answer.traction_N, 0.4, "wide: the other model's range over profile pairs"});
  double moment_N_m = 0.0;  // about the vertical, every wheelset's in its own frame
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    const double x_m = p.structure.bodies[BodyLayout::wheelset(axle)].p_T.x();
    const auto& contacts = ride.locomotive.contacts(axle);
    for (std::size_t i = 0; i < contacts.count; ++i) {
      const Eigen::Vector3d F = contacts.list[i].force_N();
      moment_N_m += (x_m + contacts.list[i].region.p_T.x()) * F.y() - contacts.list[i].region.p_T.y() * F.x();
    }
  }
  rail::verify({"10", "steady R300: moment of all wheels about the vertical", "equilibrium", "kN m", 0.0,
                1e-3 * moment_N_m, 0.3, "1 % of one wheelset's; longitudinal forces turn with the frames"});
  const loco::AxleAdhesion& first = ride.answer.adhesion.axles.front();
  EXPECT_GT(first.lateral_force_N[1], 30e3);                   // the outer wheel guides, in the flange's root
  EXPECT_LT(s.q[BodyLayout::wheelset(0)][loco::kY], -5.5e-3);  // outwards
  EXPECT_LT(s.q[BodyLayout::wheelset(0)][loco::kYaw], -9e-3);  // nose out: understeering
  EXPECT_GT(s.q[BodyLayout::wheelset(5)][loco::kYaw], 6e-3);
}

TEST(Loco3dCurveTest, StandingInACurveItStaysAndIsSymmetricFrontToRear) {
  Ride3d ride(onProfiles(), 0.0, 3450.0);
  ride.run(0.5);
  const loco::BodyState s = ride.bodies();
  EXPECT_NEAR(ride.answer.speed_mps, 0.0, 1e-9);
  EXPECT_NEAR(s.q[1][loco::kY], s.q[2][loco::kY], 1e-9);
  EXPECT_NEAR(s.q[1][loco::kYaw], -s.q[2][loco::kYaw], 1e-9);
}

TEST(Loco3dCurveTest, ALateralPushThatIsTooHardEndsWithTheWheelsName) {
  Loco3d::Parameters p = onProfiles();
  Ride3d ride(p, kSpeed_mps, 3000.0);
  ride.force.coupler_front_N = ride.force.coupler_rear_N = 0.0;
  ride.state[54 + 3 * 6 + 1] = 8.0;  // m/s sideways: wheelset 1 jumps over the rail
  for (int i = 0; i < 500 && ride.answer.failure.empty(); ++i) {
    ride.locomotive.step(ride.state, ride.force, ride.answer);
    ride.state = ride.answer.state;
  }
  EXPECT_EQ(ride.answer.failure,
            "wheelset 1, left wheel, at 3.008517 km: flange climb, it runs beyond the flange's largest angle");
}

}  // namespace
