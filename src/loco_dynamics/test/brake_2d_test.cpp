// Brake shoes and sand under the 2D locomotive, against closed forms: force, standing, locked wheels, energy.

#include "loco_2d_fixtures.hpp"
#include "loco_dynamics/axle_step.hpp"
#include "rail_core/testing/verification.hpp"

namespace {

using fixtures::kMass_kg;
using fixtures::kWeight_N;
using fixtures::paperParameters;
using fixtures::Ride;
using loco::BodyLayout;

constexpr double kRadius_m = 0.5335, kSpin_kg_m2 = 1432.0;

struct Sums {
  double shoes_J = 0.0, least_shoes_J = 0.0, slip_J = 0.0, residual_J = 0.0, drift_mps = 0.0;
};

/// Runs and sums what the account says.
Sums runAndSum(Ride& ride, double seconds) {
  Sums sums;
  const auto steps = std::lround(seconds / 0.002);
  for (long i = 0; i < steps && !::testing::Test::HasFatalFailure(); ++i) {
    ride.step();
    EXPECT_EQ(ride.answer.work_shoes_J, ride.locomotive.account().shoes);
    sums.shoes_J += ride.answer.work_shoes_J;
    sums.least_shoes_J = std::min(sums.least_shoes_J, ride.answer.work_shoes_J);
    sums.slip_J += ride.answer.work_slip_J;
    sums.residual_J += ride.locomotive.account().residual();
    sums.drift_mps = std::max(sums.drift_mps, std::abs(ride.answer.speed_mps - ride.ltd_speed));
  }
  return sums;
}

double spin(const Ride& ride, std::size_t axle) { return ride.state[27 + 3 * BodyLayout::wheelset(axle) + 2]; }

/// Turning of a wheelset against its frame at the end of the step.
double turningAfter(const loco::AxleStep& step, double torque_N_m, double turning_radps, double largest_shoe_N_m) {
  const double T = torque_N_m + step.shoeTorque(torque_N_m, turning_radps, largest_shoe_N_m);
  return turning_radps + step.h / step.J * (T - step.r * step.creepForce(T));
}

TEST(Brake2dTest, ShoesThatCanStopTheTurningExactlyStopItWhateverTheContactDoes) {
  for (const double largest_N : {0.0, 5e3, 50e3, 5e6})  // no contact, friction passed by the straight line, not passed
    for (const double slope : {0.0, 1e4, 3e6, 1e9})
      for (const double torque_N_m : {-30e3, 0.0, 30e3})
        for (const double turning_radps : {-0.5, 0.0, 0.02, 3.0}) {
          const loco::AxleStep step{1e-3, kRadius_m, 3400.0, kSpin_kg_m2, 8e3, 0.9 * largest_N, slope, largest_N};
          EXPECT_NEAR(turningAfter(step, torque_N_m, turning_radps, 1e9), 0.0, 1e-9);
          EXPECT_EQ(step.shoeTorque(torque_N_m, turning_radps, 0.0), 0.0);
          // shoes that are too weak give all they have, against the turning that is left
          const double left_radps = turningAfter(step, torque_N_m, turning_radps, 1.0);
          if (std::abs(left_radps) > 1e-6) {
            EXPECT_EQ(step.shoeTorque(torque_N_m, turning_radps, 1.0), -std::copysign(1.0, left_radps));
          }
        }
}

TEST(Brake2dTest, ShoesRetardWithTheirForceLessWhatTheWheelsSpinGives) {
  Ride ride(paperParameters(), 20.0);
  ride.force.shoe_force_N = 100e3;
  ride.run(4.0);  // the slowest motion of the suspension has died out
  const double creep = ride.answer.adhesion.axles[2].creep;
  // m a = F,  F = -B - 6 J domega/dt / r,  omega = v (1 + s)/r
  const double spin_kg = 6.0 * kSpin_kg_m2 * (1.0 + creep) / (kRadius_m * kRadius_m);
  rail::verify({"14", "2D, brake shoes of 100 kN at 17.6 m/s: force", "-B - 6 J a (1 + s)/r^2", "N",
                -100e3 * kMass_kg / (kMass_kg + spin_kg), ride.answer.traction_N, 1.0,
                "creep itself changes as the speed falls"});
  for (const loco::AxleAdhesion& axle : ride.answer.adhesion.axles)
    EXPECT_NEAR(axle.shoe_torque_N_m, -100e3 * kRadius_m / 6.0, 1e-9);
}

/// Slip speed at which creep alone carries this force, wheels standing.
double standingSlip(const loco::Loco2d::Parameters& p, double force_N) {
  const loco::PlanarContact contact(p.contact, p.rail);
  double low = 0.0, high = 0.01;
  for (int i = 0; i < 60; ++i) {
    const double w = 0.5 * (low + high);
    (6.0 * contact.computeAxleForce(kWeight_N / 12.0, w, 0.0, 3000.0).force_N < force_N ? low : high) = w;
  }
  return high;
}

TEST(Brake2dTest, ShoesStopItAndHoldItOnAGradeToCreep) {
  const loco::Loco2d::Parameters p = paperParameters();
  Ride ride(p, 5.0);
  ride.force.shoe_force_N = 100e3;
  ride.force.grade_N = -20e3;  // 15 permille
  const Sums sums = runAndSum(ride, 16.0);
  // wheels stand and the rail's creep carries: below the creepages' floor of 0.5 m/s it is viscous
  const double w = standingSlip(p, 20e3);
  rail::verify({"14", "2D, held on 15 permille by shoes: speed", "creep carries the grade", "mm/s", -1e3 * w,
                1e3 * ride.answer.speed_mps, 1e-3 * w * 1e3, "axle loads differ by the grade's moment"});
  EXPECT_NEAR(ride.answer.traction_N, 20e3, 1.0);
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) EXPECT_NEAR(spin(ride, axle), 0.0, 1e-6);
  EXPECT_GT(sums.least_shoes_J, -0.1);  // a held wheel follows its frame a micro step late: 32 W
  EXPECT_LT(sums.drift_mps, 1e-10);
  const double start_J = 0.5 * (kMass_kg + 6.0 * kSpin_kg_m2 / (kRadius_m * kRadius_m)) * 25.0;
  const double dissipated_J = sums.shoes_J + sums.slip_J;
  EXPECT_NEAR(dissipated_J, start_J - 20e3 * (ride.answer.location_m - 3000.0), 0.005 * start_J);  // the rest: dampers
  rail::verify({"14", "2D, stop by shoes from 5 m/s: residual over the work of shoes and slip", "exact", "1", 0.0,
                sums.residual_J / dissipated_J, 1e-6, "asked for; works use the mean of a step's speeds"});
}

TEST(Brake2dTest, ShoesBeyondAdhesionLockTheWheelsAndOnlyFrictionRetards) {
  Ride ride(paperParameters(), 20.0);
  ride.force.shoe_force_N = 700e3;
  const Sums locking = runAndSum(ride, 4.0);
  const double v = ride.answer.speed_mps;
  double largest_N = 0.0;
  for (const loco::AxleAdhesion& axle : ride.answer.adhesion.axles) {
    EXPECT_NEAR(axle.creep, -1.0, 1e-4);  // the frame's own pitching carries the wheel with it
    const double mu = 0.35 * (0.4 + 0.6 * std::exp(-0.275 * v));
    largest_N = std::max(largest_N, std::abs(axle.force_N + mu * axle.normal_force_N));
  }
  rail::verify({"14", "2D, locked wheels at 13.9 m/s: largest deviation of an axle's force", "mu(v) N", "N", 0.0,
                largest_N, 1.0, "speeds of wheelsets and CoG differ by mm/s"});
  const Sums locked = runAndSum(ride, 1.0);
  EXPECT_LT(std::abs(locked.shoes_J), 1e-4 * locked.slip_J);  // a shoe that holds makes no heat, the rail does
  EXPECT_LT(std::abs(locking.residual_J + locked.residual_J), 1e-6 * (locking.shoes_J + locking.slip_J));
  EXPECT_LT(std::max(locking.drift_mps, locked.drift_mps), 1e-10);
}

TEST(Brake2dTest, ReleasedShoesLetLockedWheelsSpinUpAgain) {
  Ride ride(paperParameters(), 20.0);
  ride.force.shoe_force_N = 700e3;
  ride.run(4.0);
  ride.force.shoe_force_N = 0.0;
  ride.run(10.0);
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    EXPECT_NEAR(ride.answer.adhesion.axles[axle].creep, 0.0, 1e-6);
    EXPECT_EQ(ride.answer.adhesion.axles[axle].shoe_torque_N_m, 0.0);
  }
  EXPECT_NEAR(ride.answer.traction_N, 0.0, 10.0);
}

TEST(Brake2dTest, ShoesThatHoldAgainstTheMotorsKeepItStanding) {
  Ride ride(paperParameters(), 0.0);
  ride.force.shoe_force_N = 150e3;
  ride.force.traction_reference_N = 100e3;
  ride.run(3.0);
  for (const loco::AxleAdhesion& axle : ride.answer.adhesion.axles)
    EXPECT_NEAR(axle.shoe_torque_N_m, -100e3 * kRadius_m / 6.0, 1.0);
  EXPECT_NEAR(ride.answer.speed_mps, 0.0, 1e-6);
}

/// Wet rail, or sand on it: force under control at 4.42 m/s.
double forceOnWetRail(bool sanding, double sanded_mu0) {
  loco::Loco2d::Parameters p = paperParameters();
  p.rail.sanded = p.rail.elsewhere;
  p.rail.sanded->friction.mu0 = sanded_mu0;
  p.rail.elsewhere = fixtures::readFile("/adhesion/wet.yaml", loco::readCreepLaw);
  Ride ride(p, 4.42);
  ride.force.traction_reference_N = 490e3;
  ride.force.sanding = sanding;
  ride.runAtSteadySpeed(10.0);
  return ride.answer.traction_N;
}

TEST(Brake2dTest, SandRaisesTheForceToThatOfItsOwnLawAndNeverLowersIt) {
  const double wet_N = forceOnWetRail(false, 0.35);
  Ride dry(paperParameters(), 4.42);
  dry.force.traction_reference_N = 490e3;
  dry.runAtSteadySpeed(10.0);
  EXPECT_LT(wet_N, 0.7 * dry.answer.traction_N);
  EXPECT_EQ(forceOnWetRail(true, 0.35), dry.answer.traction_N);
  EXPECT_EQ(forceOnWetRail(true, 0.15), wet_N);  // worse than the wet rail: nothing changes, to the bit
}

}  // namespace
