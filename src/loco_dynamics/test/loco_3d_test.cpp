#include "loco_dynamics/loco_3d.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "loco_3d_fixtures.hpp"
#include "loco_dynamics/loco_2d.hpp"
#include "rail_core/testing/verification.hpp"

namespace {

using fixtures::Ride3d;
using loco::BodyLayout;
using loco::Loco3d;

double sumOfLoads(const loco::LocoTraction& answer) {
  double sum_N = 0.0;
  for (const loco::AxleAdhesion& axle : answer.adhesion.axles)
    sum_N += axle.vertical_force_N[0] + axle.vertical_force_N[1];
  return sum_N;
}

/// Largest lateral, roll or yaw displacement of any body.
double largestLateral(const loco::BodyState& state) {
  double largest = 0.0;
  for (const auto& q : state.q)
    largest = std::max({largest, std::abs(q[loco::kY]), std::abs(q[loco::kRoll]), std::abs(q[loco::kYaw])});
  return largest;
}

TEST(Loco3dTest, AtRestOnLevelTrackItStaysAtRest) {
  Ride3d ride(fixtures::paperParameters3d(), 0.0);
  ride.run(1.0);
  EXPECT_NEAR(ride.answer.speed_mps, 0.0, 1e-9);  // round-off of springs under 1.3 MN
  EXPECT_NEAR(ride.answer.traction_N, 0.0, 1e-3);
  EXPECT_NEAR(sumOfLoads(ride.answer), fixtures::kWeight_N, 1e-3);
}

TEST(Loco3dTest, RollingFreelyItKeepsItsMomentum) {
  Ride3d ride(fixtures::paperParameters3d(), 10.0);
  ride.run(2.0);
  EXPECT_NEAR(ride.answer.speed_mps, 10.0, 1e-9);
  EXPECT_NEAR(ride.answer.work_slip_J, 0.0, 1e-9);
}

TEST(Loco3dTest, OnStraightTrackNothingLateralMovesUnderFullTraction) {
  Ride3d ride(fixtures::paperParameters3d(), 4.42);
  ride.force.traction_reference_N = 490e3;
  ride.force.coupler_rear_N = -350e3;
  ride.run(5.0);
  rail::verify({"9", "straight track, full traction for 5 s: largest lateral motion of a body", "exact", "m or rad",
                0.0, largestLateral(ride.bodies()), 1e-9,
                "round-off of the start, 1e-12, and of forces of 1e5 N over 1e7 N/m"});
}

TEST(Loco3dTest, ItsCentreOfGravityKeepsTheSpeedOfLtdToRoundOff) {
  Ride3d ride(fixtures::paperParameters3d(), 4.42);
  ride.force.traction_reference_N = 490e3;
  ride.force.coupler_rear_N = -380e3;
  ride.force.grade_N = -2e3;
  ride.force.propulsion_resistance_N = -1e3;
  double drift_mps = 0.0;
  for (int i = 0; i < 1500; ++i) {
    ride.step();
    drift_mps = std::max(drift_mps, std::abs(ride.answer.speed_mps - ride.ltd_speed));
  }
  rail::verify({"7", "3D on straight track: largest drift of the CoG against LTD in 3 s", "exact", "m/s", 0.0,
                drift_mps, 1e-10, "round-off"});
}

TEST(Loco3dTest, ItsOwnEnergyAccountClosesUnderControl) {
  Ride3d ride(fixtures::paperParameters3d(), 4.42);
  ride.force.traction_reference_N = 490e3;
  ride.force.coupler_rear_N = -350e3;
  ride.run(5.0);
  EXPECT_GT(ride.sum.motors, 8e6);
  rail::verify({"7", "3D on straight track under control: residual over the motors' work", "exact", "1", 0.0,
                ride.sum.residual() / ride.sum.motors, 1e-5, "asked for; works use the mean of a step's speeds"});
}

TEST(Loco3dTest, UnderTractionLoadMovesToTheRearByTheMomentOfTheCoupler) {
  Ride3d ride(fixtures::paperParameters3d(), 4.42);
  ride.force.traction_reference_N = 200e3;
  for (int i = 0; i < 10000; ++i) {
    ride.step();
    ride.force.coupler_rear_N = -ride.answer.traction_N;
  }
  // with the bodies' own displacements along the track: sum N x = -F h + sum m g x
  const loco::LocoStructure structure = fixtures::paperParameters3d().structure;
  const loco::BodyState bodies = ride.bodies();
  double moment_N_m = 0.0;
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {
    const double x_m = structure.bodies[i].p_T.x() + bodies.q[i][loco::kX] - ride.answer.location_m;
    double N = 0.0;
    if (i >= BodyLayout::wheelset(0)) {
      const double* const wheels_N = ride.answer.adhesion.axles[i - BodyLayout::wheelset(0)].vertical_force_N;
      N = wheels_N[0] + wheels_N[1];
    }
    moment_N_m += (N - structure.bodies[i].mass_kg * 9.81) * x_m;
  }
  EXPECT_NEAR(ride.answer.traction_N, 200e3 * 0.5335 / 0.53339, 30.0);  // the loaded wheels are smaller
  EXPECT_NEAR(moment_N_m, -0.885 * ride.answer.traction_N, 50.0);       // what is left moves below 1 mm/s^2
  EXPECT_NEAR(sumOfLoads(ride.answer), fixtures::kWeight_N, 1.0);
}

/// With the 2D locomotive's patch on each wheel and forces at undisplaced points it is the 2D locomotive. While slip
/// builds up (W5) and (P2) differ in the order of the step: 3.7 kN in the first 0.1 s, 1.4 kN in the second, and half
/// of that with half the step; what they leave dies out.
TEST(Loco3dTest, WithAGivenPatchItIsThePlanarModel) {
  Loco3d::Parameters p = fixtures::paperParameters3d();
  p.finder = fixtures::finderOf(fixtures::GivenPatch{});
  p.rail.elsewhere.method = loco::CreepMethod::kClosed;
  p.gravity_stiffness = false;
  loco::Loco2d planar({p.structure,
                       {0.3, -2.25, 0.5335, 100e3, {210e9, 0.28}, 82e9},
                       p.rail,
                       p.control,
                       p.adhesion_limit,
                       p.micro_step});
  Ride3d ride(p, 4.42);
  std::vector<double> state = planar.equilibriumState(3000.0, 4.42).state;
  loco::LocoTraction answer;
  ride.force.traction_reference_N = 490e3;
  for (int i = 0; i < 3000; ++i) {
    planar.step(state, ride.force, answer);
    state = answer.state;
    ride.step();
    const double most_N = i < 150 ? 4e3 : i < 500 ? 160.0 : 35.0;
    ASSERT_NEAR(ride.answer.traction_N, answer.traction_N, most_N) << i;
    ride.force.coupler_rear_N = -ride.answer.traction_N;
  }
  rail::verify({"9", "given patch: traction under control after 6 s", "2D locomotive", "N", answer.traction_N,
                ride.answer.traction_N, 0.1, "2.5e-7 of it: settled"});
  const loco::BodyState bodies = ride.bodies();
  double largest = 0.0;
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {
    // the planar state: x, z, pitch of each body, then their speeds
    const double x_m = bodies.q[i][loco::kX] - bodies.q[0][loco::kX] - (state[3 * i] - state[0]);
    const double pitch_rad = i < BodyLayout::wheelset(0) ? bodies.q[i][loco::kPitch] - state[3 * i + 2] : 0.0;
    largest =
        std::max({largest, std::abs(x_m), std::abs(bodies.q[i][loco::kZ] - state[3 * i + 1]), std::abs(pitch_rad)});
    EXPECT_NEAR(bodies.v[i][loco::kX], state[27 + 3 * i], 1e-6) << i;
  }
  rail::verify({"9", "given patch: largest difference in x, z, pitch of a body", "2D locomotive", "m or rad", 0.0,
                largest, 1e-8, "what the last oscillation leaves of 1 mm"});
}

TEST(Loco3dTest, ATorqueDrivesTheNamedAxlesOnly) {
  Ride3d ride(fixtures::paperParameters3d(), 4.42);
  ride.force.traction_reference_N = 100e3;
  ride.run(1.0);
  for (const loco::AxleAdhesion& axle : ride.answer.adhesion.axles) {
    EXPECT_NEAR(axle.torque_N_m, 100e3 / 6.0 * 0.5335, 1.0);
    EXPECT_NEAR(axle.adhesion * axle.normal_force_N, axle.force_N, 1e-6);
    EXPECT_GT(axle.frictional_power_W, 0.0);
  }
  EXPECT_EQ(ride.answer.adhesion.contacts.size(), 12u);
}

TEST(Loco3dTest, IsAPureFunctionOfStateAndForce) {
  Loco3d::Parameters p = fixtures::paperParameters3d();
  p.track = fixtures::makeTrack();
  Ride3d ride(p, 4.42, 3290.0);
  ride.force.traction_reference_N = 490e3;
  ride.force.coupler_rear_N = -350e3;
  ride.run(1.0);  // the front is in the transition
  Loco3d fresh(p);
  loco::LocoTraction again;
  const std::vector<double> before = ride.state;
  const loco::LocoForce force = ride.force;
  ride.step();
  fresh.step(before, force, again);
  EXPECT_TRUE(loco::samePayload(ride.answer, again));
}

TEST(Loco3dTest, HalvingTheMicroStepLeavesTheForceAlone) {
  double force_N[2];
  for (int k = 0; k < 2; ++k) {
    Loco3d::Parameters p = fixtures::paperParameters3d();
    p.micro_step = fixtures::kMicro / (1 + k);
    Ride3d ride(p, 4.42);
    ride.force.traction_reference_N = 490e3;
    ride.force.coupler_rear_N = -375e3;
    ride.run(4.0);
    force_N[k] = ride.answer.traction_N;
  }
  rail::verify({"8", "3D at 4.4 m/s, micro step 0.5 ms: force", "0.25 ms", "N", force_N[1], force_N[0], 100.0,
                "0.1 kN is asked for"});
}

TEST(Loco3dTest, AStateThatIsNoNumberNamesItsBodyAndDegreeOfFreedom) {
  Ride3d ride(fixtures::paperParameters3d(), 4.42);
  const std::size_t bogie_2_roll_speed = 54 + 2 * 6 + 3;
  ride.state[bogie_2_roll_speed] = std::nan("");
  ride.locomotive.step(ride.state, ride.force, ride.answer);
  EXPECT_NE(ride.answer.failure.find("is no number"), std::string::npos) << ride.answer.failure;
}

}  // namespace
