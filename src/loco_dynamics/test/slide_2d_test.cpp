// Dynamic brake of the 2D locomotive with and without slide control. Braking at steady speed is traction's mirror
// image.

#include "loco_2d_fixtures.hpp"
#include "rail_core/testing/verification.hpp"

namespace {

using fixtures::kWeight_N;
using fixtures::paperParameters;
using fixtures::Ride;
using loco::BodyLayout;
using loco::Loco2d;

Loco2d::Parameters onRail(const std::string& file, const std::string& control = "pi_per_axle") {
  Loco2d::Parameters p = paperParameters(control);
  p.rail.elsewhere = fixtures::readFile("/adhesion/" + file, loco::readCreepLaw);
  return p;
}

Ride steadyRide(const Loco2d::Parameters& p, double reference_N, double v_mps = 4.42, double seconds = 20.0) {
  Ride ride(p, v_mps);
  ride.force.traction_reference_N = reference_N;
  ride.runAtSteadySpeed(seconds);
  return ride;
}

double momentOfLoads(const loco::LocoTraction& answer) {
  const loco::LocoStructure s = fixtures::paperStructure();
  double moment_N_m = 0.0;
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle)
    moment_N_m += answer.adhesion.axles[axle].normal_force_N * s.bodies[BodyLayout::wheelset(axle)].p_T.x();
  return moment_N_m;
}

TEST(Slide2dTest, BelowAdhesionTheDynamicBrakeGivesWhatIsAskedAndTheRimsRecoverTheRest) {
  for (const std::string rail : {"paper_table1.yaml", "wet.yaml"}) {
    const Ride ride = steadyRide(onRail(rail), -200e3);
    const double creep = ride.answer.adhesion.axles[2].creep;
    rail::verify({"14", "2D, dynamic brake of 200 kN on " + rail, "asked for", "N", -200e3, ride.answer.traction_N,
                  0.01, "settled"});
    EXPECT_LT(creep, 0.0);
    EXPECT_GT(creep, -0.07);
    double recovered_J = 0.0;  // F v (1 - |s|), axle by axle
    for (const loco::AxleAdhesion& axle : ride.answer.adhesion.axles) {
      EXPECT_FALSE(axle.controlled);
      recovered_J += axle.force_N * ride.answer.speed_mps * (1.0 - std::abs(axle.creep)) * 0.002;
    }
    EXPECT_NEAR(ride.answer.work_rim_J, recovered_J, 1e-4 * std::abs(recovered_J)) << rail;
    EXPECT_NEAR(ride.answer.traction_N * ride.answer.speed_mps * 0.002 + ride.answer.work_slip_J, recovered_J,
                1e-4 * std::abs(recovered_J));
    EXPECT_NEAR(momentOfLoads(ride.answer), 0.885 * 200e3, 10.0);  // sum N x = -F h: on to the front
  }
}

TEST(Slide2dTest, BeyondAdhesionCreepSettlesAtMinusSevenPerCentAndNothingOscillates) {
  for (const std::string rail : {"paper_table1.yaml", "wet.yaml"}) {
    Ride ride = steadyRide(onRail(rail), -460e3);
    double sum = 0.0, square = 0.0;
    const int n = 1000;
    const double reference_N = ride.answer.traction_N;
    for (int i = 0; i < n; ++i) {
      ride.step();
      ride.force.coupler_rear_N = -ride.answer.traction_N;
      const double off_N = ride.answer.traction_N - reference_N;
      sum += off_N;
      square += off_N * off_N;
    }
    const double deviation_N = std::sqrt(std::max(square / n - sum / n * sum / n, 0.0));
    rail::verify({"14", "2D, slide control on " + rail + ": standard deviation of the force", "no limit cycle", "N",
                  0.0, deviation_N, 0.01, "settled to round-off of wheel loads"});
    for (const loco::AxleAdhesion& axle : ride.answer.adhesion.axles) {
      EXPECT_NEAR(axle.creep, -0.07, 1e-5);
      EXPECT_TRUE(axle.controlled);
      EXPECT_GT(axle.torque_N_m, axle.torque_reference_N_m);
    }
  }
}

TEST(Slide2dTest, BrakingIsTheMirrorImageOfTraction) {
  const Ride pulling = steadyRide(onRail("paper_table1.yaml"), 460e3);
  const double settling_mps = pulling.answer.speed_mps - 4.42;  // while it settles the coupler is late by a step
  const Ride braking = steadyRide(onRail("paper_table1.yaml"), -460e3, 4.42 + 2.0 * settling_mps);
  ASSERT_NEAR(braking.answer.speed_mps, pulling.answer.speed_mps, 1e-3);
  rail::verify({"14", "2D, slide control at 4.42 m/s: force", "traction under control, mirrored", "N",
                -pulling.answer.traction_N, braking.answer.traction_N, 0.1, "settled"});
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle)
    EXPECT_NEAR(braking.answer.adhesion.axles[axle].normal_force_N,
                pulling.answer.adhesion.axles[BodyLayout::kAxles - 1 - axle].normal_force_N, 5.0);
}

TEST(Slide2dTest, WithoutControlTheWheelsLock) {
  for (const std::string rail : {"paper_table1.yaml", "wet.yaml"}) {
    const Ride ride = steadyRide(onRail(rail, "none"), -460e3, 15.0, 10.0);
    const double v = ride.answer.speed_mps;
    const double mu0 = rail == "wet.yaml" ? 0.20 : 0.35;
    for (const loco::AxleAdhesion& axle : ride.answer.adhesion.axles) {
      // in balance T_ref u/(0.5 m/s) = r F: the wheel crawls at a rim speed u, because a generator needs one
      const double u = 0.5 * std::abs(axle.force_N) * 6.0 / 460e3;
      EXPECT_NEAR(axle.creep, -1.0 + u / v, 1e-3) << rail;
      EXPECT_NEAR(axle.friction, mu0 * (0.4 + 0.6 * std::exp(-0.275 * (v - u))), 1e-4);
      EXPECT_NEAR(axle.force_N, -axle.friction * axle.normal_force_N, 1.0);
    }
  }
}

TEST(Slide2dTest, ControlHoldsWhileTheTrainSlowsDownToASlowWalk) {
  for (const std::string rail : {"paper_table1.yaml", "wet.yaml"}) {
    Ride ride(onRail(rail), 6.0);
    ride.force.traction_reference_N = -460e3;
    ride.force.coupler_rear_N = rail == "wet.yaml" ? 150e3 : 300e3;  // the train pushes on: about 0.7 m/s^2
    ride.run(3.0);
    double lowest = 0.0, highest = -1.0;
    while (ride.answer.speed_mps > 0.56 && !HasFatalFailure()) {  // the rims' 0.5 m/s at 7 %, and some
      ride.step();
      for (const loco::AxleAdhesion& axle : ride.answer.adhesion.axles) {
        lowest = std::min(lowest, axle.creep);
        if (axle.controlled) highest = std::max(highest, axle.creep);  // a slow dry rail carries 460 kN below 7 %
      }
      ASSERT_LT(ride.force.step, 10000u);
    }
    EXPECT_GT(lowest, -0.072) << rail;
    EXPECT_LT(highest, -0.066) << rail;
    ride.force.coupler_rear_N = 0.0;
    ride.run(10.0);  // the brake fades (A11): it neither reverses nor runs on
    EXPECT_NEAR(ride.answer.speed_mps, 0.0, 0.005) << rail << ": what the springs gave back";
  }
}

TEST(Slide2dTest, RailsOfConfigStandInTheOrderOfTheirFriction) {
  double last_N = 0.0;
  for (const std::string rail : {"leaves", "greasy", "wet", "wet_sanded", "paper_table1"}) {
    const Ride ride = steadyRide(onRail(rail + ".yaml"), -460e3, 4.42, 15.0);
    EXPECT_LT(ride.answer.traction_N, last_N - 20e3) << rail;
    last_N = ride.answer.traction_N;
    for (const loco::AxleAdhesion& axle : ride.answer.adhesion.axles) EXPECT_NEAR(axle.creep, -0.07, 1e-4) << rail;
  }
}

}  // namespace
