// Simulation 2 of Wu et al. 2020, the whole run: 2D locomotives, config/scenarios/paper_2d.yaml. Verification cases 7
// and 8.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "loco_dynamics/loco_2d.hpp"
#include "loco_dynamics/loco_factory.hpp"
#include "rail_core/testing/verification.hpp"
#include "train_fixtures.hpp"

namespace {

const std::string kScenarioFile = std::string(CONFIG_DIR) + "/scenarios/paper_2d.yaml";

/// A 2D locomotive in this process whose own account is kept.
class AccountPort : public loco::LocoPort {
 public:
  explicit AccountPort(std::unique_ptr<loco::Locomotive> made)
      : locomotive_(std::move(made)), model_(dynamic_cast<loco::Loco2d&>(*locomotive_)) {}
  void send(const loco::LocoForce& force, const std::vector<double>& state) override {
    locomotive_->step(state.empty() ? locomotive_->equilibriumState(force.location_m, force.speed_mps).state : state,
                      force, answer_);
    motors_J += model_.account().motors;
    residual_J += model_.account().residual();
  }
  const loco::LocoTraction* answer() override { return &answer_; }
  double motors_J = 0.0, residual_J = 0.0;

 private:
  std::unique_ptr<loco::Locomotive> locomotive_;
  loco::Loco2d& model_;
  loco::LocoTraction answer_;
};

/// What the leading locomotive did at the ends of the steps.
class LeadingLoco : public ltd::RunObserver {
 public:
  struct Point {
    double s_m, traction_N, rail_J, rim_J;
  };
  void onStep(const ltd::StepRecord& record) override {
    const ltd::TrainState& state = record.after;
    points.push_back({state.s_m[0], state.traction_N[0], state.loco_energy[0].rail, state.loco_energy[0].rim});
    if (axle_loads_N[0] > 0.0 || state.s_m[0] < 3150.0) return;
    for (std::size_t i = 0; i < 6; ++i) axle_loads_N[i] = record.answers[0]->adhesion.axles[i].normal_force_N;
  }
  Point at(double s_m) const {
    return *std::lower_bound(points.begin(), points.end(), s_m, [](const Point& p, double s) { return p.s_m < s; });
  }
  std::vector<Point> points;
  std::array<double, 6> axle_loads_N{};  ///< at 3.15 km
};

struct PaperRun {
  LeadingLoco lead;
  ltd::Outcome outcome;
  ltd::TrainState state;
  double drift_mps = 0.0, motors_J = 0.0, residual_J = 0.0;
};

PaperRun runPaper(const std::vector<rail::Override>& overrides) {
  PaperRun run;
  const ltd::Scenario scenario = ltd::Scenario::load(kScenarioFile, overrides);
  rail::Problems problems;
  std::vector<std::unique_ptr<AccountPort>> owned;
  std::vector<loco::LocoPort*> ports;
  for (const ltd::LocoUnit& unit : scenario.train.locomotives) {
    owned.push_back(std::make_unique<AccountPort>(loco::makeLocomotive(scenario.document, unit.key, problems)));
    ports.push_back(owned.back().get());
  }
  problems.throwIfAny();
  ltd::Cosimulation cosimulation(scenario, ports, {&run.lead});
  fixtures::runToEnd(cosimulation);
  run.outcome = cosimulation.outcome();
  run.state = cosimulation.state();
  run.drift_mps = cosimulation.largestDrift();
  run.motors_J = owned[0]->motors_J;
  run.residual_J = owned[0]->residual_J;
  return run;
}

const PaperRun& atTheDefaultSteps() {
  static const PaperRun run = runPaper({});
  return run;
}

TEST(Paper2dTest, ForcesBeforeAndInTheCurveAreThePapers) {
  const LeadingLoco& lead = atTheDefaultSteps().lead;
  EXPECT_NEAR(lead.at(3150.0).traction_N, 399.7e3, 0.1e3);  // an independent prototype's; the paper: 400
  EXPECT_NEAR(lead.at(3450.0).traction_N, 386.0e3, 0.1e3);  // 386
}

TEST(Paper2dTest, EnergiesAtRailAndRimAreThoseOfAnIndependentModel) {
  // 1D: 244.880 and 536.493 MJ (paper_1d_test)
  const LeadingLoco& lead = atTheDefaultSteps().lead;
  EXPECT_NEAR(244.880e6 / lead.at(3600.0).rail_J, 1.131, 0.001);
  EXPECT_NEAR(536.493e6 / lead.at(4500.0).rail_J, 1.043, 0.001);
  EXPECT_NEAR(lead.at(3600.0).rim_J / 244.880e6 - 1.0, -0.052, 0.001);
  EXPECT_NEAR(lead.at(4500.0).rim_J / 536.493e6 - 1.0, 0.016, 0.001);
}

TEST(Paper2dTest, AccountsOfTrainAndLocomotiveCloseAndTheirSpeedsAgree) {
  const PaperRun& run = atTheDefaultSteps();
  EXPECT_EQ(run.outcome.reason, "reached 4.500 km");
  rail::verify({"7", "paper_2d: residual of the train's account over the traction work", "exact", "1", 0.0,
                run.state.account.residualRelative(), 1e-7, "1e-6 is asked for"});
  rail::verify({"7", "paper_2d: residual of the locomotive's account over the motors' work", "exact", "1", 0.0,
                run.residual_J / run.motors_J, 1e-9, "1e-6 is asked for"});
  rail::verify({"7", "paper_2d: largest difference of a CoG's speed from LTD's", "exact", "m/s", 0.0, run.drift_mps,
                1e-11, "1e-10 is asked for"});
}

TEST(Paper2dTest, LoadMovesToTheRearOfEachBogieAndOfTheLocomotive) {
  const std::array<double, 6>& N = atTheDefaultSteps().lead.axle_loads_N;
  const double x_m[] = {8.495, 6.645, 4.795, -4.795, -6.645, -8.495};
  double sum = 0.0, moment = 0.0;
  for (std::size_t i = 0; i < 6; ++i) sum += N[i], moment += N[i] * x_m[i];
  EXPECT_NEAR(sum, 1314.54e3, 10.0);
  // pull of 386.15 kN at 0.885 m, inertia 19.0 kN m, spin 1.6 kN m, resistances 2.0 kN m; exact in verification_2d_test
  EXPECT_NEAR(moment, -364.3e3, 0.5e3);
  EXPECT_LT(N[0], N[1]);
  EXPECT_LT(N[1], N[2]);
  EXPECT_GT(N[5], N[2]);
}

TEST(Paper2dTest, OnceSettledTheForceFollowsTheSpeedSmoothly) {
  // 3.17 to 3.18 km, notch 7: deviation from a straight line, which curvature alone makes 0.1 N
  double n = 0.0, s = 0.0, f = 0.0, ss = 0.0, sf = 0.0, ff = 0.0;
  for (const LeadingLoco::Point& p : atTheDefaultSteps().lead.points) {
    if (p.s_m < 3170.0 || p.s_m > 3180.0) continue;
    const double x = p.s_m - 3175.0, y = p.traction_N - 398e3;
    n += 1.0, s += x, f += y, ss += x * x, sf += x * y, ff += y * y;
  }
  const double slope = (sf - s * f / n) / (ss - s * s / n);
  const double variance = (ff - f * f / n - slope * (sf - s * f / n)) / n;
  EXPECT_LT(std::sqrt(std::max(variance, 0.0)), 5.0);  // 1e-5 of the force: no limit cycle
}

TEST(Paper2dTest, ShorterStepsLeaveTheForcesAlone) {
  const LeadingLoco& coarse = atTheDefaultSteps().lead;
  const PaperRun fine =
      runPaper({{"steps.macro_step_s", "0.001"}, {"steps.micro_step_s", "0.0005"}, {"run.end_location_km", "3.46"}});
  for (const auto& [s_m, km] : {std::pair{3150.0, "3.15"}, {3450.0, "3.45"}})
    rail::verify({"8", std::string("paper_2d: force at ") + km + " km, steps 2 and 1 ms", "1 and 0.5 ms", "N",
                  fine.lead.at(s_m).traction_N, coarse.at(s_m).traction_N, 100.0, "0.1 kN is asked for"});
}

TEST(Paper2dTest, OneControllerForEachBogieCostsAFewPerCentOfTheForce) {
  const PaperRun run = runPaper({{"control.grouping", "bogie"}, {"run.end_location_km", "3.16"}});
  EXPECT_NEAR(run.lead.at(3150.0).traction_N / atTheDefaultSteps().lead.at(3150.0).traction_N, 0.955, 0.002);
}

}  // namespace
