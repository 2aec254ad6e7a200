// Simulation 1 of Wu et al. 2020, the whole run: 1D locomotives, config/scenarios/paper_1d.yaml.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "train_fixtures.hpp"

namespace {

const std::string kScenarioFile = std::string(CONFIG_DIR) + "/scenarios/paper_1d.yaml";

/// Notes the leading locomotive at every step's end.
class LeadingLoco : public ltd::RunObserver {
 public:
  struct Point {
    double s_m, v_mps, traction_N, energy_rail_J;
  };
  void onStep(const ltd::StepRecord& record) override {
    const ltd::TrainState& state = record.after;
    points_.push_back({state.s_m[0], state.v_mps[0], state.traction_N[0], state.loco_energy[0].rail});
    largest_drift_mps_ = std::max(largest_drift_mps_, std::abs(record.answers[0]->speed_mps - state.v_mps[0]));
    largest_step_use_ = std::max(largest_step_use_, record.forces.step_use);
  }
  /// At a place, linear between the steps around it.
  Point at(double s_m) const {
    const auto after = std::lower_bound(points_.begin(), points_.end(), s_m,
                                        [](const Point& point, double value) { return point.s_m < value; });
    const Point a = *(after - 1), b = *after;
    const double w = (s_m - a.s_m) / (b.s_m - a.s_m);
    const auto between = [w](double x, double y) { return x + w * (y - x); };
    return {s_m, between(a.v_mps, b.v_mps), between(a.traction_N, b.traction_N),
            between(a.energy_rail_J, b.energy_rail_J)};
  }
  double largestDrift() const { return largest_drift_mps_; }
  double largestStepUse() const { return largest_step_use_; }

 private:
  std::vector<Point> points_;
  double largest_drift_mps_ = 0.0, largest_step_use_ = 0.0;
};

/// A finished run with what its leading locomotive did.
struct PaperRun {
  LeadingLoco lead;
  fixtures::FinishedRun end;
};
PaperRun runPaper(const std::vector<rail::Override>& overrides) {
  PaperRun run;
  const ltd::Scenario scenario = ltd::Scenario::load(kScenarioFile, overrides);
  run.end = fixtures::run(scenario, {&run.lead});
  return run;
}

class Paper1dTest : public ::testing::Test {
 protected:
  static const PaperRun& atTheDefaultStep() {
    static const PaperRun run = runPaper({});
    return run;
  }
  static const PaperRun& atHalfTheStep() {
    static const PaperRun run = runPaper({{"steps.macro_step_s", "0.001"}});
    return run;
  }
};

TEST_F(Paper1dTest, PullsAtTheAdhesionLimitOf460Point1kNBeforeAndInTheCurve) {
  const LeadingLoco& lead = atTheDefaultStep().lead;
  EXPECT_NEAR(lead.at(3150.0).traction_N, 460.1e3, 0.05e3);  // rounding of the quoted figure
  EXPECT_NEAR(lead.at(3450.0).traction_N, 460.1e3, 0.05e3);
  EXPECT_NEAR(lead.at(3150.0).traction_N, 0.35 * 134e3 * 9.81, 1e-6);
}

TEST_F(Paper1dTest, LeavesTheAdhesionLimitForThePowerLimitBetween3Point45And3Point46Km) {
  const LeadingLoco& lead = atTheDefaultStep().lead;
  const double limit_N = 0.35 * 134e3 * 9.81;
  EXPECT_LT(lead.at(3450.0).v_mps, 4.10e6 / limit_N);  // 8.911 m/s
  EXPECT_GT(lead.at(3460.0).v_mps, 4.10e6 / limit_N);
  EXPECT_LT(lead.at(3460.0).traction_N, limit_N - 500.0);
  EXPECT_NEAR(lead.at(3460.0).traction_N * lead.at(3460.0).v_mps, 4.10e6, 1e3);  // the speed of the step before
}

TEST_F(Paper1dTest, EnergiesTimeAndCouplerLossAreThoseOfTheReference) {
  // Regression reference: this run at H = 2 ms, given to 1 kJ, 10 ms and 1 kJ. It changes only with the physics or the
  // numbers of the scenario; another step changes the energies by less than 1e-5 of them.
  const PaperRun& run = atTheDefaultStep();
  EXPECT_EQ(run.end.outcome.reason, "reached 4.500 km");
  EXPECT_NEAR(run.lead.at(3600.0).energy_rail_J, 244.880e6, 1e3);
  EXPECT_NEAR(run.lead.at(4500.0).energy_rail_J, 536.493e6, 1e3);
  EXPECT_NEAR(static_cast<double>(run.end.state.step) * 0.002, 193.61, 0.005);
  EXPECT_NEAR(run.end.state.account.coupler_loss, 0.383e6, 0.001e6);
}

TEST_F(Paper1dTest, AllThreeLocomotivesWorkAlikeAndRimEqualsRail) {
  const ltd::TrainState& state = atTheDefaultStep().end.state;
  EXPECT_NEAR(state.loco_energy[1].rail / state.loco_energy[0].rail, 1.0,
              1e-4);  // they follow one another in the curve
  EXPECT_NEAR(state.loco_energy[2].rail / state.loco_energy[0].rail, 1.0, 1e-4);
  EXPECT_NEAR(state.account.traction_rim, state.account.traction_rail, 1e-10 * state.account.traction_rail);
  EXPECT_EQ(state.account.slip_loss, 0.0);
}

TEST_F(Paper1dTest, AccountClosesAndHalvingTheStepQuartersItsResidual) {
  const double at_2ms = std::abs(atTheDefaultStep().end.state.account.residualRelative());
  const double at_1ms = std::abs(atHalfTheStep().end.state.account.residualRelative());
  EXPECT_LT(at_2ms, 1e-7);                 // 3.0e-8; 1e-5 is what was asked for
  EXPECT_NEAR(at_2ms / at_1ms, 4.0, 1.0);  // 3.0e-8 to 6.6e-9: second order
}

TEST_F(Paper1dTest, HalvingTheStepChangesForcesBelow0Point1kNAndEnergyBelowOneInAHundredThousand) {
  const LeadingLoco& coarse = atTheDefaultStep().lead;
  const LeadingLoco& fine = atHalfTheStep().lead;
  for (const double s_m : {3150.0, 3450.0, 3600.0})
    EXPECT_NEAR(coarse.at(s_m).traction_N, fine.at(s_m).traction_N, 100.0) << s_m;
  for (const double s_m : {3600.0, 4500.0})
    EXPECT_NEAR(coarse.at(s_m).energy_rail_J / fine.at(s_m).energy_rail_J, 1.0, 1e-5) << s_m;
}

TEST_F(Paper1dTest, TwoRunsExchangeTheSameBits) {
  const PaperRun again = runPaper({});
  EXPECT_EQ(again.end.outcome.exchange_digest, atTheDefaultStep().end.outcome.exchange_digest);
  EXPECT_EQ(again.end.state.step, atTheDefaultStep().end.state.step);
}

TEST_F(Paper1dTest, LocomotiveAndLtdKeepTheSameSpeedAndTheStepIsWithinItsBound) {
  EXPECT_LT(atTheDefaultStep().lead.largestDrift(), 1e-10);
  EXPECT_GT(atTheDefaultStep().lead.largestStepUse(), 0.3);  // 2 of 3.2 ms at the largest coupler force
  EXPECT_LT(atTheDefaultStep().lead.largestStepUse(), 1.0);
}

TEST_F(Paper1dTest, RotaryInertiaIsOffAndWouldSlowTheTrain) {
  const PaperRun rotary = runPaper({{"rotary_inertia", "true"}});
  EXPECT_LT(rotary.lead.at(3600.0).v_mps, atTheDefaultStep().lead.at(3600.0).v_mps * 0.995);
}

}  // namespace
