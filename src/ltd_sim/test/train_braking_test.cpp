// Brakes in a train: shoes, pipe, dynamic brake, emergency, energies.

#include <cmath>
#include <functional>

#include "brake_fixtures.hpp"
#include "ltd_sim/train_ability.hpp"
#include "rail_core/testing/verification.hpp"

namespace {

using fixtures::freeVehicle;
using fixtures::makeTrack;
using rail::kGravity_mps2;
using rail::kNanosecondsPerSecond;

/// The paper's train without resistances: its 105 wagons have shoes, its three locomotives none.
ltd::TrainModel unresistedPaperTrain() {
  std::vector<rail::Vehicle> vehicles(108, freeVehicle(120e3));
  for (std::size_t i = 0; i < 3; ++i) vehicles[i] = freeVehicle(134e3);
  ltd::TrainModel train = fixtures::makeTrain(vehicles, {0, 1, 2}, fixtures::draftGear());
  train.brakes.resize(3);
  for (std::size_t i = 3; i < 108; ++i) train.brakes.push_back(fixtures::tenthOfWeight(vehicles[i]));
  return train;
}

/// A driver's schedule: its lines without groups. Eight notches of both kinds.
ltd::Driver scheduled(const std::string& lines) {
  return fixtures::readMap(lines + "\ngroups: {lead: {follows: lead}}\n", [](rail::YamlReader reader) {
    return ltd::Driver::read(reader, {"lead"}, {8}, {8}, 2000000, {});
  });
}

ltd::DynamicBrake paperDynamicBrake() {
  return fixtures::readMap(
      "{law: limits, notches: 8, largest_force_N: 364.0e3, power_at_rail_W: 3.69e6, fade_from_kmph: 10, "
      "fade_to_kmph: 2, rise_N_per_s: 40.0e3, fall_N_per_s: 160.0e3}",
      ltd::DynamicBrake::read);
}

/// From 5 km, so that a long train stands on the line; without the end at standstill.
ltd::Scenario braked(const ltd::TrainModel& train, const rail::Track& track, const std::string& driver,
                     double speed_mps, double seconds, const std::string& start = "released") {
  ltd::Scenario scenario = fixtures::makeScenario(train, track, scheduled(driver));
  fixtures::BrakeText text;
  text.start = start;
  if (!train.brakes.empty()) scenario.air_brake = fixtures::makeAirBrake(text, train);
  scenario.run.start_location_m = 5000.0;
  scenario.run.end_location_m = 9900.0;
  scenario.run.start_speed_mps = speed_mps;
  scenario.run.end_time = rail::wholeNanoseconds(seconds).value();
  return scenario;
}

/// Calls for every step.
class Watch : public ltd::RunObserver {
 public:
  explicit Watch(std::function<void(const ltd::StepRecord&)> call) : call_(std::move(call)) {}
  void onStep(const ltd::StepRecord& record) override { call_(record); }

 private:
  std::function<void(const ltd::StepRecord&)> call_;
};

fixtures::FinishedRun run(const ltd::Scenario& scenario, std::function<void(const ltd::StepRecord&)> call = {}) {
  Watch watch(call ? std::move(call) : [](const ltd::StepRecord&) {});
  fixtures::FinishedRun result = fixtures::run(scenario, {&watch});
  EXPECT_EQ(result.outcome.kind, ltd::Outcome::Kind::kFinished) << result.outcome.reason;
  return result;
}

double meanSpeed(const ltd::Scenario& scenario, const ltd::TrainState& state) {
  double momentum = 0.0, mass = 0.0;
  for (std::size_t i = 0; i < state.v_mps.size(); ++i) {
    momentum += scenario.train.inertial_mass_kg[i] * state.v_mps[i];
    mass += scenario.train.inertial_mass_kg[i];
  }
  return momentum / mass;
}

TEST(TrainBrakingTest, FullBrakeRetardsTheTrainByRatioTimesFriction) {
  const double a = 0.10 * 0.36 * kGravity_mps2 * 105 * 120.0 / 13002.0;  // 0.342 m/s2
  const double v = 80.0 / 3.6;
  double at_20_s = 0.0;
  const ltd::Scenario scenario =
      braked(unresistedPaperTrain(), makeTrack(), "over: time\npipe_bar: [[0, 3.5]]", v, 80.0, "full_service");
  const fixtures::FinishedRun stop = run(scenario, [&](const ltd::StepRecord& record) {
    if (record.after.step == 10000) at_20_s = meanSpeed(scenario, record.after);
  });
  rail::verify({"2", "brake ratio 0.10, mu 0.36 on 105 of the paper's 108 vehicles: retardation", "by hand", "m/s2",
                0.3422, (v - at_20_s) / 20.0, 5e-5, "last digit given"});
  EXPECT_NEAR(at_20_s, v - 20.0 * a, 1e-9);  // every wagon moves, so every shoe rubs: couplers cannot matter
  double moved_m = 0.0;                      // of the centre of mass, from places 10 m apart
  for (std::size_t i = 0; i < 108; ++i)
    moved_m +=
        scenario.train.vehicles[i].mass_kg / 13002e3 * (stop.state.s_m[i] - 5000.0 + 10.0 * static_cast<double>(i));
  rail::verify({"2", "the same train from 80 km/h: way of its centre of mass", "v^2/(2 a)", "m", 0.5 * v * v / a,
                moved_m, 0.3, "the vehicles do not stop all at once"});
  for (std::size_t i = 3; i < 108; ++i)
    EXPECT_LT(std::abs(stop.state.v_mps[i]), 1e-12) << i;  // the others swing in their slack
}

/// One locomotive and two wagons, all with shoes.
TEST(TrainBrakingTest, TheDriverSeesTheShoesOfAllVehiclesThatHisFullServiceCounts) {
  ltd::TrainModel train =
      fixtures::makeTrain({freeVehicle(134e3), freeVehicle(120e3), freeVehicle(120e3)}, {0}, fixtures::draftGear());
  for (const rail::Vehicle& v : train.vehicles) train.brakes.push_back(fixtures::tenthOfWeight(v));
  const ltd::Scenario scenario =
      braked(train, makeTrack(), "over: time\npipe_bar: [[0, 3.5]]", 20.0, 20.0, "full_service");
  const double full_N = ltd::computeAbility(train, scenario.air_brake).full_service_N(15.0);
  const double loco_N = 0.36 * 0.1 * 134e3 * kGravity_mps2;
  int seen = 0;
  run(scenario, [&](const ltd::StepRecord& record) {
    const ltd::DriverView& view = record.forces.view;
    if (record.before.step == 0) return;  // traction is that of the step before
    ++seen;
    ASSERT_NEAR(view.loco_shoes_N, -loco_N, 1e-9 * full_N);
    ASSERT_NEAR(view.air_brake_N + view.loco_shoes_N, -full_N, 1e-9 * full_N);
    ASSERT_NEAR(view.traction_N, view.loco_shoes_N, 1e-9 * full_N);
  });
  EXPECT_GT(seen, 9000);
}

TEST(TrainBrakingTest, AtAStandTheDriverSeesNoLocomotiveShoesRub) {
  ltd::TrainModel train =
      fixtures::makeTrain({freeVehicle(134e3), freeVehicle(120e3), freeVehicle(120e3)}, {0}, fixtures::draftGear());
  for (const rail::Vehicle& v : train.vehicles) train.brakes.push_back(fixtures::tenthOfWeight(v));
  run(braked(train, makeTrack(), "over: time\npipe_bar: [[0, 3.5]]", 0.0, 1.0, "full_service"),
      [&](const ltd::StepRecord& record) { ASSERT_EQ(record.forces.view.loco_shoes_N, 0.0); });
}

TEST(TrainBrakingTest, HoldsOnAGradeWithoutCreeping) {
  double held_N = 0.0;
  std::vector<double> s_at_60_s;
  const ltd::Scenario scenario = braked(unresistedPaperTrain(), fixtures::uniformGrade(10.0),
                                        "over: time\npipe_bar: [[0, 3.5]]", 0.0, 120.0, "full_service");
  const fixtures::FinishedRun stand = run(scenario, [&](const ltd::StepRecord& record) {
    if (record.after.step == 30000) s_at_60_s = record.after.s_m;
    held_N = record.forces.view.air_brake_N;
  });
  rail::verify({"2", "13 002 t on 1 %, held by the wagons' shoes", "m g i", "N", 13002e3 * kGravity_mps2 * 0.010,
                held_N, 1e3, "the unbraked locomotives swing in their couplers"});
  for (std::size_t i = 3; i < 108; ++i) {
    EXPECT_LT(std::abs(stand.state.v_mps[i]), 1e-15) << i;
    EXPECT_NEAR(stand.state.s_m[i], s_at_60_s[i], 1e-9) << i;
  }
  EXPECT_EQ(stand.state.account.traction_rail, 0.0);
}

TEST(TrainBrakingTest, HeldTrainLeavesWhenTheBrakeIsReleased) {
  const ltd::Scenario scenario = braked(unresistedPaperTrain(), fixtures::uniformGrade(-10.0),
                                        "over: time\npipe_bar: [[0, 3.5], [10, 5.0]]", 0.0, 200.0, "full_service");
  double at_10_s = -1.0, at_190_s = 0.0;
  const fixtures::FinishedRun free_run = run(scenario, [&](const ltd::StepRecord& record) {
    if (record.after.step == 5000) at_10_s = record.after.v_mps[60];
    if (record.after.step == 95000) at_190_s = meanSpeed(scenario, record.after);
  });
  EXPECT_LT(std::abs(at_10_s), 1e-15);
  EXPECT_NEAR(meanSpeed(scenario, free_run.state) - at_190_s, 10.0 * kGravity_mps2 * 0.010, 1e-9);
}

TEST(TrainBrakingTest, EmergencyReachesTheTailAtTheWavesSpeed) {
  std::vector<double> first_s(108, -1.0);
  const ltd::Scenario scenario =
      braked(fixtures::brakedTrain(), makeTrack(), "over: time\nemergency_from: 1", 20.0, 10.0);
  run(scenario, [&](const ltd::StepRecord& record) {
    for (std::size_t i = 1; i < 108; ++i)
      if (first_s[i] < 0.0 && record.forces.air_brake_N[i] < 0.0)
        first_s[i] = 0.002 * static_cast<double>(record.before.step);
  });
  // The valve opens with the step of 1 s; the cylinder has some pressure a step after the wave has come.
  EXPECT_NEAR(first_s[107], 1.0 + 1641.0 / 250.0, 0.0061);
  EXPECT_NEAR(first_s[54], 1.0 + 0.5 * 1641.0 / 250.0, 0.04);
  for (std::size_t i = 2; i < 108; ++i) EXPECT_GE(first_s[i], first_s[i - 1]);
}

/// Two locomotives with a dynamic brake and four wagons.
ltd::TrainModel dynamicBrakeTrain() {
  std::vector<rail::Vehicle> vehicles(6, fixtures::paperWagon());
  vehicles[0] = vehicles[3] = fixtures::paperLoco();
  ltd::TrainModel train = fixtures::makeTrain(vehicles, {0, 3}, fixtures::draftGear());
  train.dynamic_brakes = {paperDynamicBrake()};
  return train;
}

TEST(TrainBrakingTest, DynamicBrakeComesThroughZeroAtItsRates) {
  std::vector<double> reference_N;
  double at_5_s_mps = 0.0;
  run(braked(dynamicBrakeTrain(), makeTrack(), "over: time\nnotches: [[0, 4], [5, 0]]\nbrake_notches: [[5, 8], [9, 0]]",
             10.0, 12.0),
      [&](const ltd::StepRecord& record) {
        reference_N.push_back(record.forces.reference_N[0]);
        if (record.before.step == 2499) at_5_s_mps = record.before.v_mps[0];
      });
  const auto at = [&](double time_s) { return reference_N[static_cast<std::size_t>(std::lround(time_s / 0.002))]; };
  const double down_s = at(4.998) / 160e3;  // traction falls first ...
  EXPECT_NEAR(down_s, 0.25 * 4.10e6 / at_5_s_mps / 160e3, 1e-3);
  EXPECT_GT(at(5.0 + down_s - 0.01), 0.0);
  EXPECT_NEAR(at(7.0) - at(6.0), -40e3, 1.0);  // ... then the brake rises ...
  EXPECT_NEAR(at(7.0), -40e3 * (2.0 - down_s), 200.0);
  EXPECT_NEAR(at(9.5) - at(9.25), 0.25 * 160e3, 1.0);  // ... and falls
  EXPECT_EQ(at(11.9), 0.0);
}

TEST(TrainBrakingTest, EmergencyCutsTraction) {
  int notch_after = -1;
  double reference_at_15_s = -1.0, reference_at_10_s = 0.0;
  ltd::TrainModel train = dynamicBrakeTrain();
  for (const rail::Vehicle& vehicle : train.vehicles) train.brakes.push_back(fixtures::tenthOfWeight(vehicle));
  run(braked(train, makeTrack(), "over: time\nnotches: [[0, 8]]\nemergency_from: 10", 10.0, 16.0),
      [&](const ltd::StepRecord& record) {
        if (record.before.step == 4999) reference_at_10_s = record.forces.reference_N[0];
        if (record.before.step == 5000) notch_after = record.forces.notch[1];
        if (record.before.step == 7500) reference_at_15_s = record.forces.reference_N[0];
      });
  EXPECT_GT(reference_at_10_s, 250e3);
  EXPECT_EQ(notch_after, 0);
  EXPECT_EQ(reference_at_15_s, 0.0);
}

}  // namespace
