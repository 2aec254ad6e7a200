// What the 2D locomotive reports of its contacts, field by field against its formula.

#include "loco_dynamics/adhesion_report.hpp"

#include "loco_2d_fixtures.hpp"

namespace {

using fixtures::kWeight_N;
using fixtures::paperParameters;
using fixtures::Ride;
using loco::AxleAdhesion;
using loco::BodyLayout;

constexpr double kRadius_m = 0.5335;

/// Velocities in a state vector (positions of 27 coordinates come first).
double velocityOf(const std::vector<double>& state, std::size_t axle, std::size_t k) {
  return state[27 + 3 * BodyLayout::wheelset(axle) + k];
}
double slipOf(const std::vector<double>& state, std::size_t axle) {
  return velocityOf(state, axle, 2) * kRadius_m - velocityOf(state, axle, 0);
}

/// A macro step of one micro step: the report belongs to the velocities with which the step began.
struct Reported {
  std::vector<double> before;
  loco::LocoTraction answer;
};

/// 20 s at steady speed.
Reported settle(const std::string& control, double v_mps, double force_reference_N) {
  Ride ride(paperParameters(control), v_mps, fixtures::kMicro);
  ride.force.traction_reference_N = force_reference_N;
  ride.runAtSteadySpeed(20.0);
  const std::vector<double> before = ride.state;
  ride.step();
  return {before, ride.answer};
}

/// What holds at every instant. Tolerances: round-off.
void expectFormulas(const Reported& run) {
  double sum_N = 0.0, traction_N = 0.0;
  ASSERT_EQ(run.answer.adhesion.axles.size(), BodyLayout::kAxles);
  for (std::size_t i = 0; i < BodyLayout::kAxles; ++i) {
    SCOPED_TRACE(i);
    const AxleAdhesion& axle = run.answer.adhesion.axles[i];
    const double v = velocityOf(run.before, i, 0), w = slipOf(run.before, i);
    const double N = axle.normal_force_N, F = axle.force_N;
    EXPECT_DOUBLE_EQ(axle.creep, w / std::max(v, 0.5));
    EXPECT_DOUBLE_EQ(axle.adhesion, F / N);
    EXPECT_DOUBLE_EQ(axle.friction, 0.35 * (0.6 * std::exp(-0.275 * std::abs(w)) + 0.4));  // Eq. (2)
    EXPECT_EQ(axle.static_friction, 0.35);
    const double power_W = F * 0.5 * (w + slipOf(run.answer.state, i));  // work of the micro step, as it is booked
    EXPECT_NEAR(axle.frictional_power_W, power_W, 1e-12 * power_W);
    EXPECT_DOUBLE_EQ(axle.t_gamma_N, std::abs(F) * std::abs(w) / std::max(std::abs(v), 0.5));
    for (int side = 0; side < 2; ++side) {
      EXPECT_DOUBLE_EQ(axle.vertical_force_N[side], 0.5 * N);
      EXPECT_EQ(axle.lateral_force_N[side], 0.0);
    }
    sum_N += N, traction_N += F;
  }
  EXPECT_NEAR(sum_N, kWeight_N, 10.0);  // it still bounces a little
  EXPECT_NEAR(traction_N, run.answer.traction_N, 1e-6);
  EXPECT_TRUE(run.answer.adhesion.contacts.empty());
}

TEST(AdhesionReportTest, AtTheSlipLimitEveryFieldFollowsItsFormula) {
  const Reported run = settle("pi_per_axle", 4.42, 490e3);
  expectFormulas(run);
  const double limited_N = 0.35 * kWeight_N;  // below what is asked for
  for (const AxleAdhesion& axle : run.answer.adhesion.axles) {
    EXPECT_NEAR(axle.creep, 0.07, 1e-4);
    EXPECT_DOUBLE_EQ(axle.torque_reference_N_m, kRadius_m * limited_N / 6.0);
    EXPECT_NEAR(axle.torque_N_m, kRadius_m * axle.force_N, 1e-4 * axle.torque_N_m);  // settled
    EXPECT_LT(axle.torque_N_m, 0.95 * axle.torque_reference_N_m);
    EXPECT_TRUE(axle.controlled);
    EXPECT_LT(axle.friction, 0.34);  // far enough from static friction to tell them apart
  }
}

TEST(AdhesionReportTest, WithoutNeedOfControlTheTorqueIsTheOneAskedFor) {
  const Reported run = settle("pi_per_axle", 4.42, 60e3);
  expectFormulas(run);
  for (const AxleAdhesion& axle : run.answer.adhesion.axles) {
    EXPECT_DOUBLE_EQ(axle.torque_reference_N_m, kRadius_m * 10e3);
    EXPECT_DOUBLE_EQ(axle.torque_N_m, axle.torque_reference_N_m);
    EXPECT_NEAR(axle.force_N, 10e3, 1.0);
    EXPECT_FALSE(axle.controlled);
  }
}

TEST(AdhesionReportTest, BelowHalfAMetrePerSecondTheCreepsFloorHolds) {
  const Reported run = settle("pi_per_axle", 0.2, 60e3);
  expectFormulas(run);
  EXPECT_NEAR(velocityOf(run.before, 0, 0), 0.2, 0.05);
}

/// Wet from 0.1 m behind `first` on: the border lies under the bogie, behind it.
void expectWetBehind(std::size_t first) {
  loco::Loco2d::Parameters p = paperParameters();
  const double border_m = 3000.0 + p.structure.bodies[BodyLayout::wheelset(first)].p_T.x() - 0.1;
  loco::CreepLawParameters wet = p.rail.elsewhere;
  wet.friction.mu0 = 0.2;
  p.rail.sections = {{2000.0, border_m, wet}};
  Ride ride(p, 0.0);
  ride.step();
  for (std::size_t i = 0; i < BodyLayout::kAxles; ++i) {
    EXPECT_EQ(ride.answer.adhesion.axles[i].static_friction, i <= first ? 0.35 : 0.2) << i << " of " << first;
    EXPECT_EQ(ride.answer.adhesion.axles[i].friction, i <= first ? 0.35 : 0.2) << i << " of " << first;
  }
}

TEST(AdhesionReportTest, EachWheelsetFeelsTheRailAtItsOwnPlace) {
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) expectWetBehind(axle);
}

}  // namespace
