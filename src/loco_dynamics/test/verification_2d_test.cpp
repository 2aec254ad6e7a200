// Verification of the 2D locomotive by what must hold exactly, whatever the parameters: momentum, moments, forces of
// racing wheels, steps. At rest, free rolling, CoG and energy account: loco_2d_test. Modes: modes_test.

#include "loco_2d_fixtures.hpp"
#include "rail_core/testing/verification.hpp"

namespace {

using fixtures::kWeight_N;
using fixtures::paperParameters;
using fixtures::Ride;
using loco::BodyLayout;

constexpr double kRacingPower_W = 4.18e6;

/// Wheels without control, power limited at the rim: force that is left once the race has stopped.
double racingForce(double v_mps, double B_s_per_m) {
  loco::Loco2d::Parameters p = paperParameters("none");
  p.rail.elsewhere.friction.B_s_per_m = B_s_per_m;
  p.control.rim_power_limit = true;
  Ride ride(p, v_mps);
  ride.force.rim_power_limit_W = kRacingPower_W;
  ride.force.traction_reference_N = 560e3;
  ride.runAtSteadySpeed(60.0);
  EXPECT_NEAR(ride.ltd_speed, v_mps, 0.05);
  return ride.answer.traction_N;
}

/// F = m g mu0 (A + (1 - A) exp(-B w)) with F (v + w) = P: where power meets friction in full slip.
double racingForceInClosedForm(double v_mps, double B_s_per_m) {
  double F = 0.14 * kWeight_N;
  for (int i = 0; i < 100; ++i)
    F = kWeight_N * 0.35 * (0.4 + 0.6 * std::exp(-B_s_per_m * (kRacingPower_W / F - v_mps)));
  return F;
}

/// Tolerance: the closed form takes all axle loads for equal.
TEST(Verification2dTest, WithTheRimPowerLimitTheRaceStopsWherePowerMeetsFriction) {
  for (const double B : {0.25, 0.275})
    for (const double v : {2.0, 4.4, 8.0})
      EXPECT_NEAR(racingForce(v, B), racingForceInClosedForm(v, B), 2e-4 * kWeight_N) << "v " << v << ", B " << B;
}

/// An independent prototype's figures, 4.18 MW. They belong to B = 0.25 s/m, not to the 0.275 of paper_table1.yaml.
TEST(Verification2dTest, WithTheRimPowerLimitTheRaceEndsAsInAnIndependentModel) {
  const auto check = [](double v_mps, double expected_N) {
    char what[64];
    std::snprintf(what, sizeof what, "rim power 4.18 MW, B = 0.25 s/m, at %g m/s", v_mps);
    rail::verify({"4", what, "independent model", "N", expected_N, racingForce(v_mps, 0.25), 0.001 * expected_N,
                  "0.1 % is given"});
  };
  check(2.0, 185.7e3);
  check(4.4, 187.2e3);
  check(8.0, 193.2e3);
}

/// Velocities in a state vector (positions of 27 coordinates come first).
double velocityOf(const std::vector<double>& state, std::size_t body, std::size_t k) {
  return state[27 + 3 * body + k];
}

struct Balance {
  double moment_N_m;  ///< about the point of the track below the locomotive's centre, of all that must cancel
  double vertical_N;
  double sum_N;
};

/// One micro step. Loads act in it at the nominal places and give exactly (v_new - v_old)/h, so the balance is exact.
Balance stepAndBalance(Ride& ride, const loco::LocoStructure& s) {
  const std::vector<double> before = ride.state;
  const loco::LocoForce f = ride.force;
  ride.step();
  const double h = rail::toSeconds(f.step_length);
  const auto rate = [&](std::size_t body, std::size_t k) {
    return (velocityOf(ride.state, body, k) - velocityOf(before, body, k)) / h;
  };
  Balance b{0.0, -kWeight_N, 0.0};
  // sum N x = -(F_c h_c + sum m a h + 6 J domega/dt + sum R h_R) + sum m x zddot + sum I thetaddot, pitch up positive
  for (const loco::AxleAdhesion& axle : ride.answer.adhesion.axles) b.sum_N += axle.normal_force_N;
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle)
    b.moment_N_m += ride.answer.adhesion.axles[axle].normal_force_N * s.bodies[BodyLayout::wheelset(axle)].p_T.x();
  b.moment_N_m -= (f.coupler_front_N + f.coupler_rear_N) * s.coupler_z_m;
  b.moment_N_m -= (f.propulsion_resistance_N + f.curving_resistance_N) * s.bodies[BodyLayout::kCar].p_T.z();
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {
    const loco::Body& body = s.bodies[i];
    const double grade_N = f.grade_N * body.mass_kg / fixtures::kMass_kg;
    b.moment_N_m += (body.mass_kg * rate(i, 0) - grade_N) * body.p_T.z();
    b.moment_N_m -= body.mass_kg * body.p_T.x() * rate(i, 1);
    b.moment_N_m += body.inertia_kg_m2.y() * rate(i, 2);  // pitch is nose down in the model, spin of wheelsets forward
    b.vertical_N -= body.mass_kg * rate(i, 1);
  }
  b.vertical_N += b.sum_N;
  return b;
}

TEST(Verification2dTest, MomentsAndVerticalForcesBalanceAtEveryInstant) {
  Ride ride(paperParameters(), 4.42, fixtures::kMicro);  // a macro step of one micro step: every instant is seen
  ride.force.traction_reference_N = 490e3;
  ride.force.coupler_front_N = 20e3;
  ride.force.coupler_rear_N = -300e3;
  ride.force.grade_N = -5e3;
  ride.force.propulsion_resistance_N = -3e3;
  ride.force.curving_resistance_N = -2e3;
  const loco::LocoStructure s = paperParameters().structure;
  double sum_N = 0.0, largest_moment_N_m = 0.0, largest_vertical_N = 0.0;
  const int n = 4000;
  for (int i = 0; i < n; ++i) {
    if (i == n / 2) ride.force.coupler_rear_N = -450e3;  // a jerk of the train
    const Balance b = stepAndBalance(ride, s);
    largest_moment_N_m = std::max(largest_moment_N_m, std::abs(b.moment_N_m));
    largest_vertical_N = std::max(largest_vertical_N, std::abs(b.vertical_N));
    sum_N += b.sum_N / n;
  }
  rail::verify({"5", "largest imbalance of moments in 4 s with a jerk", "exact", "N m", 0.0, largest_moment_N_m, 1e-3,
                "round-off of 1e7 N m"});
  rail::verify(
      {"5", "largest imbalance of vertical forces", "exact", "N", 0.0, largest_vertical_N, 1e-3, "round-off of 1e6 N"});
  rail::verify({"5", "mean of the sum of wheel loads", "m g", "N", 1314.54e3, sum_N, 10.0,
                "bounce does not quite average out in 4 s"});
}

TEST(Verification2dTest, MicroAndMacroStepsLeaveTheForceAlone) {
  const auto forceWith = [](rail::Nanoseconds macro, rail::Nanoseconds micro) {
    loco::Loco2d::Parameters p = paperParameters();
    p.micro_step = micro;
    Ride ride(p, 4.42, macro);
    ride.force.traction_reference_N = 490e3;
    ride.runAtSteadySpeed(10.0);
    return ride.answer.traction_N;
  };
  const double reference_N = forceWith(500000, 100000);
  const auto check = [&](const std::string& what, rail::Nanoseconds macro, rail::Nanoseconds micro) {
    rail::verify({"8", "force at 4.42 m/s, macro and micro step " + what, "0.5 and 0.1 ms", "N", reference_N,
                  forceWith(macro, micro), 100.0, "0.1 kN is asked for"});
  };
  check("0.5 and 0.5 ms", 500000, 500000);
  check("2 and 1 ms", 2000000, 1000000);
  check("5 and 1 ms", 5000000, 1000000);
}

TEST(Verification2dTest, AStepThatIsTooLongEndsWithBodyAndDegreeOfFreedomNotWithNumbersThatAreNone) {
  loco::Loco2d::Parameters p = paperParameters();
  p.micro_step = 3000000;  // 3 ms; 1.84 are stable
  Ride ride(p, 4.42, 3000000);
  ride.force.traction_reference_N = 490e3;
  const std::string failure = ride.runUntilFailure(10000);
  EXPECT_EQ(failure.substr(0, 9), "wheelset ") << failure;
  EXPECT_NE(failure.find(": in z is "), std::string::npos) << failure;
  EXPECT_TRUE(loco::allFinite(ride.answer));
}

}  // namespace
