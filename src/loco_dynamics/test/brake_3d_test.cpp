// Brakes of the 3D locomotive: shoes, dynamic brake under slide control. The 2D locomotive's tests have more cases.

#include "loco_3d_fixtures.hpp"
#include "rail_core/testing/verification.hpp"

namespace {

using fixtures::kWeight_N;
using fixtures::Ride3d;
using loco::BodyLayout;

constexpr double kMass_kg = 134000.0, kSpin_kg_m2 = 1432.0;
constexpr double kLoadedRadius_m = 0.53339;  // of the coned wheel under its load

loco::Loco3d::Parameters onRail(const std::string& file, const std::string& control = "pi_per_axle") {
  loco::Loco3d::Parameters p = fixtures::paperParameters3d(control);
  p.rail.elsewhere = fixtures::readFile("/adhesion/" + file, loco::readCreepLaw);
  return p;
}

/// Keeps the speed by the coupler. @return largest drift of the CoG against LTD
double runAtSteadySpeed(Ride3d& ride, double seconds) {
  double drift_mps = 0.0;
  for (int i = 0; i < static_cast<int>(seconds / 0.002) && !::testing::Test::HasFatalFailure(); ++i) {
    ride.step();
    ride.force.coupler_rear_N = -ride.answer.traction_N;
    drift_mps = std::max(drift_mps, std::abs(ride.answer.speed_mps - ride.ltd_speed));
  }
  return drift_mps;
}

double largestLateral(const Ride3d& ride) {
  double largest = 0.0;
  for (const auto& q : ride.bodies().q)
    largest = std::max({largest, std::abs(q[loco::kY]), std::abs(q[loco::kRoll]), std::abs(q[loco::kYaw])});
  return largest;
}

TEST(Brake3dTest, ShoesRetardWithTheirForceLessWhatTheWheelsSpinGivesAndNothingLateralArises) {
  Ride3d ride(fixtures::paperParameters3d(), 20.0);
  ride.force.shoe_force_N = 100e3;
  ride.run(4.0);
  const double creep = ride.answer.adhesion.axles[2].creep, r = kLoadedRadius_m;
  const double spin_kg = 6.0 * kSpin_kg_m2 * (1.0 + creep) / (r * r);
  rail::verify({"14", "3D, brake shoes of 100 kN at 17.6 m/s: force", "-B - 6 J a (1 + s)/r^2", "N",
                -100e3 * 0.5335 / r * kMass_kg / (kMass_kg + spin_kg), ride.answer.traction_N, 10.0,
                "rolling radius to 5e-5, creep itself changes as the speed falls"});
  rail::verify({"14", "3D, braked by shoes for 4 s: largest lateral motion of a body", "exact", "m or rad", 0.0,
                largestLateral(ride), 1e-9, "round-off, as under traction"});
  EXPECT_LT(std::abs(ride.answer.speed_mps - ride.ltd_speed), 1e-10);
}

TEST(Brake3dTest, ShoesStopItAndHoldItOnAGradeToCreep) {
  Ride3d ride(fixtures::paperParameters3d(), 5.0);
  ride.force.shoe_force_N = 100e3;
  ride.force.grade_N = -20e3;
  ride.run(16.0);
  EXPECT_NEAR(ride.answer.traction_N, 20e3, 1.0);
  EXPECT_LT(ride.answer.speed_mps, 0.0);
  EXPECT_GT(ride.answer.speed_mps, -1e-3);
  const loco::BodyState bodies = ride.bodies();
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle)
    EXPECT_NEAR(bodies.v[BodyLayout::wheelset(axle)][loco::kPitch], 0.0, 1e-6);
  rail::verify({"14", "3D, stop by shoes from 5 m/s: residual over the work of shoes and slip", "exact", "1", 0.0,
                ride.sum.residual() / (ride.sum.shoes + ride.sum.slip), 1e-5,
                "asked for; works use the mean of a step's speeds"});
  EXPECT_LT(std::abs(ride.answer.speed_mps - ride.ltd_speed), 1e-10);
}

TEST(Brake3dTest, ShoesBeyondAdhesionLockTheWheelsUntilTheyAreReleased) {
  Ride3d ride(fixtures::paperParameters3d(), 20.0);
  ride.force.shoe_force_N = 700e3;
  ride.run(4.0);
  const double v = ride.answer.speed_mps, mu = 0.35 * (0.4 + 0.6 * std::exp(-0.275 * v));
  double largest_N = 0.0;
  for (const loco::AxleAdhesion& axle : ride.answer.adhesion.axles) {
    EXPECT_NEAR(axle.creep, -1.0, 1e-4);
    largest_N = std::max(largest_N, std::abs(axle.force_N + mu * axle.normal_force_N));
  }
  rail::verify({"14", "3D, locked wheels at 13.9 m/s: largest deviation of an axle's force", "mu(v) N", "N", 0.0,
                largest_N, 1.0, "speeds of wheelsets and CoG differ by mm/s"});
  EXPECT_LT(largestLateral(ride), 1e-6);
  EXPECT_LT(std::abs(ride.sum.residual()), 1e-5 * (ride.sum.shoes + ride.sum.slip));
  ride.force.shoe_force_N = 0.0;
  ride.run(10.0);
  for (const loco::AxleAdhesion& axle : ride.answer.adhesion.axles) EXPECT_NEAR(axle.creep, 0.0, 1e-3);
  EXPECT_NEAR(ride.answer.traction_N, 0.0, 20.0);
}

TEST(Brake3dTest, BelowAdhesionTheDynamicBrakeGivesWhatIsAskedAndLoadMovesForward) {
  for (const std::string rail : {"paper_table1.yaml", "wet.yaml"}) {
    Ride3d ride(onRail(rail), 4.42);
    ride.force.traction_reference_N = -200e3;
    EXPECT_LT(runAtSteadySpeed(ride, 15.0), 1e-10);
    rail::verify({"14", "3D, dynamic brake of 200 kN on " + rail, "asked for, times nominal over loaded radius", "N",
                  -200e3 * 0.5335 / kLoadedRadius_m, ride.answer.traction_N, 4.0, "rolling radius to 2e-5"});
    double recovered_J = 0.0, moment_N_m = 0.0;
    const loco::LocoStructure s = onRail(rail).structure;
    for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
      const loco::AxleAdhesion& a = ride.answer.adhesion.axles[axle];
      EXPECT_FALSE(a.controlled);
      recovered_J += a.force_N * ride.answer.speed_mps * (1.0 - std::abs(a.creep)) * 0.002;
      moment_N_m += (a.vertical_force_N[0] + a.vertical_force_N[1]) * s.bodies[BodyLayout::wheelset(axle)].p_T.x();
    }
    EXPECT_NEAR(ride.answer.work_rim_J, recovered_J, 5e-4 * std::abs(recovered_J)) << rail;
    EXPECT_NEAR(ride.answer.traction_N * ride.answer.speed_mps * 0.002 + ride.answer.work_slip_J,
                ride.answer.work_rim_J, 1e-4 * std::abs(recovered_J));
    EXPECT_NEAR(moment_N_m, 0.885 * 200e3, 0.02 * 0.885 * 200e3);  // bodies' own displacements left out
  }
}

TEST(Brake3dTest, BeyondAdhesionCreepSettlesAtMinusSevenPerCentAndNothingOscillates) {
  for (const std::string rail : {"paper_table1.yaml", "wet.yaml"}) {
    Ride3d ride(onRail(rail), 4.42);
    ride.force.traction_reference_N = -460e3;
    runAtSteadySpeed(ride, 20.0);
    double sum = 0.0, square = 0.0;
    const int n = 1000;
    const double reference_N = ride.answer.traction_N;
    for (int i = 0; i < n; ++i) {
      runAtSteadySpeed(ride, 0.002);
      const double off_N = ride.answer.traction_N - reference_N;
      sum += off_N;
      square += off_N * off_N;
    }
    const double deviation_N = std::sqrt(std::max(square / n - sum / n * sum / n, 0.0));
    rail::verify({"14", "3D, slide control on " + rail + ": standard deviation of the force", "no limit cycle", "N",
                  0.0, deviation_N, 0.01, "settled to round-off of wheel loads"});
    for (const loco::AxleAdhesion& axle : ride.answer.adhesion.axles) {
      EXPECT_NEAR(axle.creep, -0.07, 5e-4);  // the controller knows the nominal radius
      EXPECT_TRUE(axle.controlled);
    }
    EXPECT_LT(largestLateral(ride), 1e-6);
  }
}

TEST(Brake3dTest, WithoutControlTheWheelsLock) {
  Ride3d ride(onRail("wet.yaml", "none"), 15.0);
  ride.force.traction_reference_N = -460e3;
  runAtSteadySpeed(ride, 10.0);
  for (const loco::AxleAdhesion& axle : ride.answer.adhesion.axles) {
    const double u = 0.5 * std::abs(axle.force_N) * 6.0 / 460e3;  // (A11): a generator needs some speed
    EXPECT_NEAR(axle.creep, -1.0 + u / ride.answer.speed_mps, 1e-3);
  }
}

TEST(Brake3dTest, SandRaisesTheForceToThatOfItsOwnLawAndNeverLowersIt) {
  const auto forceWith = [](bool sanding, double sanded_mu0) {
    loco::Loco3d::Parameters p = onRail("wet.yaml");
    p.rail.sanded = fixtures::readFile("/adhesion/paper_table1.yaml", loco::readCreepLaw);
    p.rail.sanded->friction.mu0 = sanded_mu0;
    Ride3d ride(p, 4.42);
    ride.force.traction_reference_N = -460e3;
    ride.force.sanding = sanding;
    runAtSteadySpeed(ride, 3.0);
    return ride.answer.traction_N;
  };
  const double wet_N = forceWith(false, 0.35);
  EXPECT_LT(forceWith(true, 0.35), 1.3 * wet_N);  // both < 0
  EXPECT_EQ(forceWith(true, 0.15), wet_N);        // to the bit
}

TEST(Brake3dTest, LockedWheelsComeToRestOnACleanSlipperyRailWithoutChatter) {
  loco::Loco3d::Parameters p = fixtures::paperParameters3d();
  p.rail.elsewhere.reduction.k0 = 1.0;  // stiff creep: the straight lines of (W5) pass what 0.05 of friction offers
  p.rail.elsewhere.friction.mu0 = 0.05;
  Ride3d ride(p, 1.0);
  ride.force.shoe_force_N = 700e3;
  ride.force.grade_N = -20e3;
  ride.run(8.0);
  const double speed_mps = ride.answer.speed_mps;
  EXPECT_NEAR(ride.answer.traction_N, 20e3, 1.0);
  EXPECT_LT(std::abs(speed_mps), 1e-3);
  double largest_mps = 0.0;
  for (int i = 0; i < 500; ++i) {
    ride.step();
    largest_mps = std::max(largest_mps, std::abs(ride.answer.speed_mps - speed_mps));
  }
  EXPECT_LT(largest_mps, 1e-6);
}

}  // namespace
