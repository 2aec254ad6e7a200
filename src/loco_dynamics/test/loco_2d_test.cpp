#include "loco_dynamics/loco_2d.hpp"

#include "loco_2d_fixtures.hpp"
#include "rail_core/testing/verification.hpp"

namespace {

using fixtures::kWeight_N;
using fixtures::paperParameters;
using fixtures::Ride;
using loco::BodyLayout;
using loco::Loco2d;

Ride makeRide(double v_mps, const std::string& control = "pi_per_axle") {
  return Ride(paperParameters(control), v_mps);
}

double sumOfLoads(const loco::LocoTraction& answer) {
  double sum = 0.0;
  for (const loco::AxleAdhesion& axle : answer.adhesion.axles) sum += axle.normal_force_N;
  return sum;
}

TEST(Loco2dTest, AtRestOnLevelTrackItStaysAtRest) {
  Ride ride = makeRide(0.0);
  ride.run(1.0);
  rail::verify({"1", "2D: speed after 1 s at rest on level track", "exact", "m/s", 0.0, ride.answer.speed_mps, 1e-9,
                "round-off of springs under 1.3 MN"});
  EXPECT_NEAR(ride.answer.traction_N, 0.0, 1e-3);
  for (const loco::AxleAdhesion& axle : ride.answer.adhesion.axles)
    EXPECT_NEAR(axle.normal_force_N, kWeight_N / 6.0, 1e-3);
}

TEST(Loco2dTest, RollingFreelyItKeepsItsMomentumAndItsEnergy) {
  Ride ride = makeRide(10.0);
  ride.run(5.0);
  rail::verify(
      {"1", "2D: speed after 5 s of free rolling", "exact", "m/s", 10.0, ride.answer.speed_mps, 1e-9, "round-off"});
  EXPECT_NEAR(ride.answer.work_slip_J, 0.0, 1e-9);
}

TEST(Loco2dTest, ItsCentreOfGravityKeepsTheSpeedOfLtdToRoundOff) {
  Ride ride = makeRide(4.4);
  ride.force.traction_reference_N = 490e3;
  ride.force.coupler_rear_N = -380e3;
  ride.force.grade_N = -2e3;
  ride.force.propulsion_resistance_N = -1e3;
  for (int i = 0; i < 2500; ++i) {
    ride.step();
    ASSERT_NEAR(ride.answer.speed_mps, ride.ltd_speed, 1e-10) << i;
  }
}

TEST(Loco2dTest, UnderTractionLoadMovesToTheRearByTheMomentOfTheCoupler) {
  Ride ride = makeRide(4.4);
  ride.force.traction_reference_N = 200e3;
  for (int i = 0; i < 15000; ++i) {  // the coupler takes up what the wheels gave in the step before: steady speed
    ride.step();
    ride.force.coupler_rear_N = -ride.answer.traction_N;
  }
  double moment = 0.0;
  const loco::LocoStructure s = paperParameters().structure;
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle)
    moment += ride.answer.adhesion.axles[axle].normal_force_N * s.bodies[BodyLayout::wheelset(axle)].p_T.x();
  EXPECT_NEAR(ride.answer.traction_N, 200e3, 1.0);
  EXPECT_NEAR(moment, -0.885 * 200e3, 10.0);  // sum N x = -F h; what is left moves below 1 mm/s^2
  EXPECT_NEAR(sumOfLoads(ride.answer), kWeight_N, 1.0);
}

TEST(Loco2dTest, ItsOwnEnergyAccountClosesUnderControl) {
  Ride ride = makeRide(4.4);
  ride.force.traction_reference_N = 490e3;
  ride.force.coupler_rear_N = -350e3;
  double motors = 0.0, residual = 0.0;
  for (int i = 0; i < 5000; ++i) {
    ride.step();
    motors += ride.locomotive.account().motors;
    residual += ride.locomotive.account().residual();
  }
  EXPECT_GT(motors, 1e7);
  EXPECT_LT(std::abs(residual), 1e-6 * motors);
}

TEST(Loco2dTest, AWheelsetThatDropsLosesItsEnergyToTheDampingOfItsContacts) {
  loco::Loco2d::Parameters p = paperParameters();
  p.micro_step = 2000;  // 2 us: what the contact's bent spring leaves over falls with h^2, to 1e-7 here
  Ride ride(p, 0.0);
  ride.state[3 * BodyLayout::wheelset(2) + 1] += 5e-5;  // lifted by 0.05 mm, still on the rail
  double damped = 0.0, contact = 0.0, residual = 0.0;
  for (int i = 0; i < 50; ++i) {
    ride.step();
    const Loco2d::Account& account = ride.locomotive.account();
    contact += account.contact_damping;
    damped += account.contact_damping + account.dampers;
    residual += account.residual();
  }
  EXPECT_GT(contact, 0.5 * damped);
  EXPECT_LT(std::abs(residual), 1e-6 * damped);
}

TEST(Loco2dTest, UnderControlItSlipsAtSevenPerCentAndNothingOscillates) {
  Ride ride = makeRide(4.42);
  ride.force.traction_reference_N = 490e3;
  double sum = 0.0, square = 0.0;
  const int n = 2000;
  for (int i = 0; i < 10000 + n; ++i) {
    ride.step();
    ride.force.coupler_rear_N = -ride.answer.traction_N;  // steady speed
    if (i < 10000) continue;
    sum += ride.answer.traction_N;
    square += ride.answer.traction_N * ride.answer.traction_N;
  }
  const double mean = sum / n;
  EXPECT_NEAR(mean, 399.7e3, 1e3);                                      // an independent prototype's force at 4.42 m/s
  EXPECT_LT(std::sqrt(std::max(square / n - mean * mean, 0.0)), 10.0);  // no limit cycle: 1e-5 of the force
  for (const loco::AxleAdhesion& axle : ride.answer.adhesion.axles) {
    EXPECT_NEAR(axle.creep, 0.07, 1e-4);
    EXPECT_LT(axle.force_N / axle.normal_force_N, axle.friction);  // adhesion used stays below what the rail offers
  }
}

TEST(Loco2dTest, AtSteadySpeedTheRimsPayTheRailsWorkAndTheSlip) {
  Ride ride = makeRide(4.42);
  ride.force.traction_reference_N = 490e3;
  for (int i = 0; i < 10000; ++i) {
    ride.step();
    ride.force.coupler_rear_N = -ride.answer.traction_N;
  }
  const double H = 0.002, v = ride.answer.speed_mps;
  double slip_J = 0.0, rim_J = 0.0;
  for (const loco::AxleAdhesion& axle : ride.answer.adhesion.axles) {
    slip_J += axle.frictional_power_W * H;
    rim_J += axle.torque_N_m * v * (1.0 + axle.creep) / 0.5335 * H;
  }
  // settled to 1e-5 of the force: the last micro step stands for all
  EXPECT_NEAR(ride.answer.work_slip_J, slip_J, 1e-4 * slip_J);
  EXPECT_NEAR(ride.answer.work_rim_J, rim_J, 1e-4 * rim_J);
  EXPECT_NEAR(ride.answer.work_rim_J, ride.answer.traction_N * v * H + ride.answer.work_slip_J, 1e-4 * rim_J);
}

TEST(Loco2dTest, WithoutControlTheWheelsRaceAndOnlyKineticFrictionIsLeft) {
  Loco2d::Parameters p = fixtures::paperParameters("none");
  p.control.rim_power_limit = false;
  Ride ride(p, 2.0);
  ride.force.traction_reference_N = 560e3;
  ride.force.coupler_rear_N = -184.04e3;
  ride.run(30.0);
  EXPECT_GT(ride.answer.adhesion.axles[0].creep * ride.answer.speed_mps, 32.0);
  rail::verify({"4", "no control, beyond 32 m/s of slip: A mu0 m g", "exact", "N", 184.04e3, ride.answer.traction_N,
                30.0, "exp(-B w) still gives 1e-4"});
}

TEST(Loco2dTest, IsAPureFunctionOfStateAndForce) {
  Ride ride = makeRide(4.4);
  ride.force.traction_reference_N = 490e3;
  ride.force.coupler_rear_N = -350e3;
  ride.run(2.0);
  Loco2d fresh(paperParameters());
  loco::LocoTraction again;
  const std::vector<double> before = ride.state;
  const loco::LocoForce force = ride.force;
  ride.step();
  fresh.step(before, force, again);
  EXPECT_TRUE(loco::samePayload(ride.answer, again));
}

TEST(Loco2dTest, CreepForceNeverPassesWhatFrictionOffersHoweverStiffTheCreep) {
  Loco2d::Parameters p = fixtures::paperParameters("none");
  p.rail.elsewhere.reduction.k0 = 1.0;  // clean steel: the straight line of the implicit step passes mu N
  p.rail.elsewhere.friction.mu0 = 0.05;
  Ride ride(p, 0.0);
  ride.force.traction_reference_N = 560e3;
  double largest_use = 0.0;
  for (int i = 0; i < 1000; ++i) {
    ride.step();
    for (const loco::AxleAdhesion& axle : ride.answer.adhesion.axles) {
      largest_use = std::max(largest_use, std::abs(axle.force_N) / (axle.friction * axle.normal_force_N));
      ASSERT_GE(axle.frictional_power_W, -1e-3) << i;  // round-off of a wheel that sticks
    }
  }
  EXPECT_LE(largest_use, 1.0 + 1e-12);
  EXPECT_GT(largest_use, 0.99);
}

TEST(Loco2dTest, BodiesStandAtTheHeightsOfTheirFileInEquilibrium) {
  const loco::LocoStructure s = fixtures::paperStructure();
  const Loco2d locomotive(fixtures::paperParameters());
  const std::vector<loco::BodyPose> poses = locomotive.computePoses(locomotive.equilibriumState(3000.0, 5.0).state);
  ASSERT_EQ(poses.size(), 9u);
  const char* const names[] = {"car_body", "bogie_frame_1", "bogie_frame_2"};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(poses[i].name, names[i]);
  EXPECT_EQ(poses[8].name, "wheelset_6");
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_NEAR(poses[i].z_m, s.bodies[i].p_T.z(), 1e-9) << poses[i].name;
    EXPECT_NEAR(poses[i].location_m, 3000.0 + s.bodies[i].p_T.x(), 1e-6) << poses[i].name;
    EXPECT_NEAR(poses[i].pitch_rad, 0.0, 1e-9) << poses[i].name;
  }
}

}  // namespace
