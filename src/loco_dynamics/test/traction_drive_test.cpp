#include "loco_dynamics/traction_drive.hpp"

#include "loco_2d_fixtures.hpp"

namespace {

using fixtures::paperParameters;
using fixtures::Ride;
using loco::BodyLayout;
using loco::BodyVector;

loco::Loco2d::Parameters withNoses() {
  loco::Loco2d::Parameters p = paperParameters();
  p.structure = fixtures::paperStructure({{"motor_reaction", "nose"}, {"motor_nose_x_m", "[-1.0, -0.8, 0.9]"}});
  return p;
}

BodyVector zero() {
  BodyVector x;
  for (auto& body : x) body.setZero();
  return x;
}

/// Loads of 60 kN of traction without control: T = 5335 N m on each axle.
BodyVector loadsOf(const loco::Loco2d::Parameters& p) {
  loco::TractionDrive drive(p.structure, paperParameters("none").control, 0.35, p.micro_step);
  std::vector<double> state = drive.initialState();
  loco::LocoForce force;
  force.traction_reference_N = 60e3;
  BodyVector loads = zero();
  drive.addTorques(force, zero(), state.data(), loads);
  return loads;
}

constexpr double kTorque_N_m = 60e3 * 0.5335 / 6.0;

TEST(TractionDriveTest, TheReactionIsACoupleOnTheFrameUnlessTheFileSaysOtherwise) {
  const BodyVector loads = loadsOf(paperParameters());
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle)
    EXPECT_NEAR(loads[BodyLayout::wheelset(axle)][loco::kPitch], kTorque_N_m, 1e-9);
  for (std::size_t i = 0; i < BodyLayout::kBogies; ++i)
    EXPECT_NEAR(loads[BodyLayout::bogie(i)][loco::kPitch], -3.0 * kTorque_N_m, 1e-9);
}

TEST(TractionDriveTest, ANoseBehindItsAxlePressesTheFrameDownAndLiftsTheAxle) {
  const BodyVector loads = loadsOf(withNoses());
  // the housing wants to turn backwards: its rear end goes down
  EXPECT_NEAR(loads[BodyLayout::wheelset(0)][loco::kZ], kTorque_N_m / 1.0, 1e-9);
  EXPECT_NEAR(loads[BodyLayout::wheelset(1)][loco::kZ], kTorque_N_m / 0.8, 1e-9);
  EXPECT_NEAR(loads[BodyLayout::wheelset(2)][loco::kZ], -kTorque_N_m / 0.9, 1e-9);
  EXPECT_NEAR(loads[BodyLayout::wheelset(5)][loco::kZ], -kTorque_N_m / 1.0,
              1e-9);  // the rear bogie is the mirror image
}

TEST(TractionDriveTest, NeitherReactionLeavesAForceOrAMomentOnTheLocomotive) {
  for (const loco::Loco2d::Parameters& p : {paperParameters(), withNoses()}) {
    const BodyVector loads = loadsOf(p);
    double F = 0.0, M = 0.0;
    for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {
      F += loads[i][loco::kZ];
      M += loads[i][loco::kPitch] - p.structure.bodies[i].p_T.x() * loads[i][loco::kZ];
    }
    EXPECT_NEAR(F, 0.0, 1e-9);
    EXPECT_NEAR(M, 0.0, 1e-8);
  }
}

TEST(TractionDriveTest, TheHousingTurnsWithTheLineFromAxleToNose) {
  const loco::Loco2d::Parameters p = withNoses();
  const loco::TractionDrive drive(p.structure, p.control, 0.35, p.micro_step);
  BodyVector v = zero();
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {  // all turns about the track's origin as one
    v[i][loco::kPitch] = 0.1;
    v[i][loco::kZ] = -0.1 * p.structure.bodies[i].p_T.x();
  }
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle)
    EXPECT_NEAR(drive.housingSpeed(v, axle), 0.1, 1e-12) << axle;
}

TEST(TractionDriveTest, WithNosesTheAccountClosesAndTheTrainFeelsTheSameForce) {
  double force_N[2], load_N[2];
  for (int k = 0; k < 2; ++k) {
    Ride ride(k == 0 ? paperParameters() : withNoses(), 4.42);
    ride.force.traction_reference_N = 200e3;
    double motors = 0.0, residual = 0.0;
    for (int i = 0; i < 5000; ++i) {
      ride.step();
      motors += ride.locomotive.account().motors;
      residual += ride.locomotive.account().residual();
      ride.force.coupler_rear_N = -ride.answer.traction_N;
    }
    EXPECT_LT(std::abs(residual), 1e-6 * motors);
    force_N[k] = ride.answer.traction_N;
    load_N[k] = ride.answer.adhesion.axles[0].normal_force_N;
  }
  EXPECT_NEAR(force_N[0], force_N[1], 1.0);
  EXPECT_GT(std::abs(load_N[0] - load_N[1]), 1e3);  // but not on the same axle loads
}

}  // namespace
