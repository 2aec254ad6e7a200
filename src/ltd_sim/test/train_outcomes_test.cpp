// Energies of trains that pull and brake, how their runs end, and what a scenario refuses of its driver.

#include <cmath>

#include "brake_fixtures.hpp"
#include "ltd_sim/scenario.hpp"
#include "scratch_directory.hpp"
#include "supply_texts.hpp"

namespace {

using Kind = ltd::Outcome::Kind;

ltd::Driver scheduled(const std::string& lines) {
  return fixtures::readMap(lines + "\ngroups: {lead: {follows: lead}}\n", [](rail::YamlReader reader) {
    return ltd::Driver::read(reader, {"lead"}, {8}, {8}, 2000000, {});
  });
}

/// Two locomotives with a dynamic brake and a supply, ten wagons, all with shoes and resistances.
ltd::TrainModel fullTrain(const std::string& supply) {
  std::vector<rail::Vehicle> vehicles(12, fixtures::paperWagon());
  vehicles[0] = vehicles[6] = fixtures::paperLoco();
  ltd::TrainModel train = fixtures::makeTrain(vehicles, {0, 6}, fixtures::draftGear());
  train.dynamic_brakes = {fixtures::readMap(
      "{law: limits, notches: 8, largest_force_N: 364.0e3, power_at_rail_W: 3.69e6, fade_from_kmph: 10, "
      "fade_to_kmph: 2, rise_N_per_s: 40.0e3, fall_N_per_s: 160.0e3}",
      ltd::DynamicBrake::read)};
  train.supplies = {
      fixtures::readMap(supply, [](rail::YamlReader reader) { return ltd::PowerSupply::read(reader, 0.0); })};
  for (const rail::Vehicle& vehicle : vehicles) train.brakes.push_back(fixtures::tenthOfWeight(vehicle));
  return train;
}

std::string batteryText() { return fixtures::supplyHead("storage") + fixtures::storageText(); }

/// From 3 km at 36 km/h with the scenario's air brake.
ltd::Scenario trip(const std::string& driver, const rail::Track& track, double seconds,
                   const std::string& supply = batteryText()) {
  ltd::Scenario scenario = fixtures::makeScenario(fullTrain(supply), track, scheduled(driver));
  scenario.air_brake = fixtures::makeAirBrake({}, scenario.train);
  scenario.run.start_speed_mps = 10.0;
  scenario.run.end_location_m = 9900.0;
  scenario.run.end_time = rail::wholeNanoseconds(seconds).value();
  return scenario;
}

TEST(BrakingEnergyTest, AccountClosesFromTractionThroughDynamicBrakeToStandstill) {
  const std::string driver = "over: time\nnotches: [[0, 8], [40, 0]]\nbrake_notches: [[40, 8]]\npipe_bar: [[60, 3.5]]";
  std::string supply = fixtures::changed(batteryText(), "capacity_J: 1.0e7", "capacity_J: 1.0e9");
  supply = fixtures::changed(supply, "discharge_power_W: 5.0e5", "discharge_power_W: 2.0e7");
  const ltd::Scenario scenario = trip(driver, fixtures::uniformGrade(-4.0), 200.0, supply);
  const ltd::TrainState end = fixtures::run(scenario).state;
  const rail::EnergyAccount& a = end.account;
  EXPECT_GT(a.traction_rail, 20e6);
  EXPECT_GT(a.brake_rail, 20e6);
  EXPECT_GT(a.air_brake, 20e6);
  EXPECT_LT(std::abs(a.residual()), 1e-6 * (a.brake_rail + a.air_brake));
  EXPECT_LT(std::abs(a.residualRelative()), 1e-6);
  // 1D: no slip, so what the rail takes is given to the motors or heats the shoes.
  EXPECT_NEAR(a.recovered_rim + a.shoes, a.brake_rail, 1e-6 * a.brake_rail);
  double into_links_J = 0.0;
  for (const ltd::PowerSupply::State& s : end.supply) into_links_J += s.storage_in_J + s.to_resistors_J;
  EXPECT_GT(into_links_J, 0.5 * a.recovered_rim);
  EXPECT_LT(into_links_J, 0.8 * a.recovered_rim);  // the drivetrain's efficiency
}

TEST(BrakingEnergyTest, TheResidualFallsWithTheStep) {
  const std::string driver = "over: time\nnotches: [[0, 0]]\npipe_bar: [[5, 3.5]]";
  double residual_J[2];
  for (int k = 0; k < 2; ++k) {
    ltd::Scenario scenario = trip(driver, fixtures::makeTrack(), 60.0);
    scenario.macro_step = scenario.micro_step = k == 0 ? 2000000 : 1000000;
    residual_J[k] = fixtures::run(scenario).state.account.residual();
  }
  EXPECT_LT(std::abs(residual_J[1]), 0.6 * std::abs(residual_J[0]));
}

TEST(OutcomeTest, RunawayFailsWithPlaceSpeedAndLimit) {
  ltd::Scenario scenario = trip("over: time\nnotches: [[0, 0]]", fixtures::uniformGrade(-30.0), 600.0);
  scenario.run.runaway_margin_mps = 5.0 / 3.6;
  const fixtures::FinishedRun run = fixtures::run(scenario);
  EXPECT_EQ(run.outcome.kind, Kind::kFailed);
  EXPECT_TRUE(fixtures::contains(run.outcome.reason, "runaway at ")) << run.outcome.reason;
  EXPECT_TRUE(fixtures::contains(run.outcome.reason, " km: 85.0 km/h where 80.0 are allowed")) << run.outcome.reason;
  EXPECT_TRUE(fixtures::contains(run.outcome.reason, "run.runaway_above_limit_kmph")) << run.outcome.reason;
  EXPECT_NEAR(run.state.v_mps[0] * 3.6, 85.0, 0.01);
}

TEST(OutcomeTest, AnyDriversExcessAboveALimitIsOneNoteWithTheWorst) {
  // above 36.3 km/h soon, then free until 40 km/h: above a limit twice
  const std::string line =
      "{name: test line, start_km: 0, end_km: 10, grades: [{from_km: 0, grade_permille: -30}], curves: [], "
      "speed_limits: [{from_km: 0, limit_kmph: 36.3}, {from_km: 3.2, limit_kmph: 80}, {from_km: 3.6, limit_kmph: 40}]}";
  const ltd::Scenario scenario =
      trip("over: time\nnotches: [[0, 0]]", fixtures::readMap(line, rail::Track::read), 60.0);
  double worst_mps = 0.0;
  struct Watch : ltd::RunObserver {
    explicit Watch(double& most) : worst_mps(most) {}
    void onStep(const ltd::StepRecord& r) override {
      worst_mps = std::max(worst_mps, r.forces.view.speed_mps - r.forces.view.speed_limit_mps);
    }
    double& worst_mps;
  } watch(worst_mps);
  const fixtures::FinishedRun run = fixtures::run(scenario, {&watch});
  ASSERT_EQ(run.outcome.notes.size(), 1u) << fixtures::joined(run.outcome.notes);
  const std::string note = run.outcome.notes.front();
  EXPECT_TRUE(fixtures::contains(note, "speed limit exceeded 2 times, worst at ")) << note;
  EXPECT_TRUE(fixtures::contains(note, " are allowed")) << note;
  const double speed_kmph = std::stod(note.substr(note.find("km: ") + 4));
  const double limit_kmph = std::stod(note.substr(note.find("where ") + 6));
  EXPECT_EQ(limit_kmph, 40.0);
  EXPECT_NEAR(speed_kmph - limit_kmph, worst_mps * 3.6, 0.06);  // the note has one decimal
}

TEST(OutcomeTest, WithinHalfAKilometreAnHourOfTheLimitNothingIsSaid) {
  ltd::LimitWatch watch;
  ltd::DriverView view;
  view.speed_limit_mps = 10.0;
  view.speed_mps = 10.0 + 0.49 / 3.6;
  watch.look(view);
  EXPECT_EQ(watch.note(), "");
  view.speed_mps = 10.0 + 0.51 / 3.6;
  watch.look(view);
  EXPECT_EQ(watch.note(), "speed limit exceeded 1 time, worst at 0.000 km: 36.5 km/h where 36.0 are allowed");
}

TEST(OutcomeTest, EndsWhenTheTrainHasStoodForSoLong) {
  ltd::Scenario scenario = trip("over: time\nnotches: [[0, 0]]\npipe_bar: [[1, 3.5]]", fixtures::makeTrack(), 600.0);
  scenario.run.standstill_time = 7 * rail::kNanosecondsPerSecond;
  double last_moving_s = 0.0;
  struct Watch : ltd::RunObserver {
    explicit Watch(double& at) : last_moving_s(at) {}
    void onStep(const ltd::StepRecord& r) override {
      if (r.after.v_mps[0] > 0.005) last_moving_s = 0.002 * static_cast<double>(r.after.step);
    }
    double& last_moving_s;
  } watch(last_moving_s);
  const fixtures::FinishedRun run = fixtures::run(scenario, {&watch});
  EXPECT_EQ(run.outcome.kind, Kind::kFinished);
  EXPECT_TRUE(fixtures::contains(run.outcome.reason, "stands at 3.")) << run.outcome.reason;
  EXPECT_NEAR(0.002 * static_cast<double>(run.state.step), last_moving_s + 7.0, 0.0041);
}

TEST(OutcomeTest, AStandAtTheStartIsNoEnd) {
  ltd::Scenario scenario = trip("over: time\nnotches: [[30, 8]]", fixtures::makeTrack(), 50.0);
  scenario.run.start_speed_mps = 0.0;
  scenario.run.standstill_time = 7 * rail::kNanosecondsPerSecond;
  EXPECT_EQ(fixtures::run(scenario).outcome.reason, "reached the end time 50 s");
}

TEST(OutcomeTest, AnEmptyStoreIsNotedWithLocomotiveAndTimeAndEndsTraction) {
  const ltd::Scenario scenario = trip("over: time\nnotches: [[0, 8]]", fixtures::makeTrack(), 120.0);
  const fixtures::FinishedRun run = fixtures::run(scenario);
  EXPECT_EQ(run.outcome.kind, Kind::kFinished);
  ASSERT_EQ(run.outcome.notes.size(), 2u) << fixtures::joined(run.outcome.notes);
  EXPECT_TRUE(fixtures::contains(run.outcome.notes[0], "loco_1: its store was empty, first at "))
      << run.outcome.notes[0];
  EXPECT_TRUE(fixtures::contains(run.outcome.notes[1], "loco_2: ")) << run.outcome.notes[1];
  // 4 MJ at 0.95 and 0.5 MW at most: 7.6 s at the link's power; then the auxiliaries' 10 kW stay unfed.
  EXPECT_GT(run.state.store_empty_at[0], 7 * rail::kNanosecondsPerSecond);
  EXPECT_LT(run.state.store_empty_at[0], 9 * rail::kNanosecondsPerSecond);
  EXPECT_EQ(run.state.traction_N[0], 0.0);
  for (const ltd::PowerSupply::State& s : run.state.supply) {  // the power is cut with the store, (T4) or not
    EXPECT_GT(s.motored_rim_J, 2e6);
    EXPECT_NEAR(s.unserved_J, 0.0, 1e-7);  // round-off of 1 kJ a step, 4000 steps
    const double starving_s = 120.0 - rail::toSeconds(run.state.store_empty_at[0]);
    EXPECT_NEAR(s.auxiliaries_unfed_J, 1e4 * starving_s, 1e4 * 0.01);  // the two do not run out in the same step
    EXPECT_NEAR(s.residual(), 0.0, 1e-6);
  }
}

TEST(OutcomeTest, AStoresPowerBoundsTheWorkOfEachStepThoughTheTrainGathersSpeedInIt) {
  const ltd::Scenario scenario = trip("over: time\nnotches: [[0, 8]]", fixtures::makeTrack(), 7.0);
  for (const ltd::PowerSupply::State& s : fixtures::run(scenario).state.supply) {
    EXPECT_GT(s.storage_out_J, 0.9 * 0.5e6 * 7.0);  // less while the motors respond
    EXPECT_NEAR(s.auxiliaries_unfed_J, 0.0, 1e-7);  // with the speed at a step's start alone: 10 J
    EXPECT_EQ(s.unserved_J, 0.0);
  }
}

/// What a copy of config/ refuses.
class DriverRefusalTest : public fixtures::ScratchDirectory {
 protected:
  DriverRefusalTest() { std::filesystem::copy(CONFIG_DIR, path("config"), std::filesystem::copy_options::recursive); }
  std::vector<std::string> faults(const std::string& scenario) const {
    try {
      ltd::Scenario::load(path("config/scenarios/" + scenario), {});
    } catch (const rail::ConfigError& error) {
      return error.lines();
    }
    return {};
  }
  /// One fault for each line of parts.
  void expectFaults(const std::string& scenario, const std::vector<std::vector<std::string>>& parts) const {
    const std::vector<std::string> lines = faults(scenario);
    EXPECT_EQ(lines.size(), parts.size()) << fixtures::joined(lines);
    for (const auto& p : parts)
      EXPECT_TRUE(fixtures::anyHas(lines, p)) << p[0] << " not in\n" << fixtures::joined(lines);
  }
};

const char* const kNotches = "  notches: [[0, 1],";

TEST_F(DriverRefusalTest, AirBrakeThatTheScenarioHasNot) {
  replace("config/scenarios/paper_1d.yaml", kNotches,
          "  pipe_bar: [[0, 5.0], [90, 4.2]]\n  independent_brake: [[0, 0], [95, 0.5]]\n  emergency_from: 200\n" +
              std::string(kNotches));
  expectFaults(
      "paper_1d.yaml",
      {{"scenarios/paper_1d.yaml: driver.pipe_bar.1.1 = 4.2: must be 5, or the scenario must have an air_brake"},
       {"scenarios/paper_1d.yaml: driver.independent_brake.1.1 = 0.5: must be 0, or the scenario must have"},
       {"scenarios/paper_1d.yaml: driver.emergency_from = 200: must be left out, or the scenario must have"}});
}

TEST_F(DriverRefusalTest, AirBrakeInAnExternalDriversSilence) {
  replace("config/scenarios/paper_1d.yaml", "  over: time", "  kind: external");
  const std::string text = read("config/scenarios/paper_1d.yaml");
  const std::size_t from = text.find("  notches: "), to = text.find("  groups:");
  write("config/scenarios/paper_1d.yaml", text.substr(0, from) +
                                              "  period_s: 0.1\n  answer_deadline_s: 1\n  on_silence: {pipe_bar: 3.5, "
                                              "independent_brake: 1, emergency: true}\n" +
                                              text.substr(to));
  expectFaults("paper_1d.yaml", {{"driver.on_silence.pipe_bar = 3.5: must be 5"},
                                 {"driver.on_silence.independent_brake = 1: must be 0"},
                                 {"driver.on_silence.emergency = true: must be false"}});
}

TEST_F(DriverRefusalTest, SandWithoutSandedAdhesionWhereWheelsRoll) {
  replace("config/scenarios/paper_2d.yaml", kNotches, "  sanding: [[0, 1], [5, 0]]\n" + std::string(kNotches));
  replace("config/scenarios/paper_1d.yaml", kNotches, "  sanding: [[0, 1], [5, 0]]\n" + std::string(kNotches));
  expectFaults("paper_2d.yaml",
               {{"scenarios/paper_2d.yaml: driver.sanding.0.1 = 1: must be 0: the scenario has no sanded_adhesion"}});
  expectFaults("paper_1d.yaml", {});  // does nothing there, but a driver may be shared
  replace("config/scenarios/paper_2d.yaml",
          "adhesion_file:", "sanded_adhesion_file: ../adhesion/polach_dry.yaml\nadhesion_file:");
  expectFaults("paper_2d.yaml", {});
}

TEST_F(DriverRefusalTest, SandedAdhesionOf1DLocomotives) {
  replace("config/scenarios/paper_1d.yaml",
          "rotary_inertia:", "sanded_adhesion_file: ../adhesion/polach_dry.yaml\nrotary_inertia:");
  expectFaults("paper_1d.yaml", {{"sanded_adhesion", "is of no use to 1D locomotives"}});
}

/// Without the comments at its head, its name, and lines that hold `but`.
std::string rest(const std::string& text, const std::vector<std::string>& but) {
  std::string kept;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const bool skip =
        line.substr(0, 1) == "#" || line.substr(0, 5) == "name:" ||
        std::any_of(but.begin(), but.end(), [&](const std::string& b) { return fixtures::contains(line, b); });
    if (!skip) kept += line + "\n";
  }
  return kept;
}

TEST_F(DriverRefusalTest, CopiedFilesDifferInWhatTheySayAndNothingElse) {
  EXPECT_EQ(rest(read("config/locomotives/co_co_134t.yaml"), {}),
            rest(read("config/locomotives/co_co_134t_storage.yaml"), {"supply_file:"}));
  const std::string goods = rest(read("config/brakes/uic_g.yaml"), {"start:", "remote_"});
  EXPECT_EQ(goods, rest(read("config/brakes/uic_g_applied.yaml"), {"start:", "remote_"}));
  EXPECT_EQ(goods, rest(read("config/brakes/uic_g_remote.yaml"), {"start:", "remote_"}));
}

}  // namespace
