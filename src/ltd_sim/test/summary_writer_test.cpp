#include "ltd_sim/summary_writer.hpp"

#include <map>

#include "hand_made_run.hpp"
#include "ltd_sim/supply_figures.hpp"
#include "scratch_directory.hpp"
#include "supply_texts.hpp"

namespace {

using Row = std::vector<std::string>;

class SummaryWriterTest : public fixtures::ScratchDirectory {
 protected:
  /// The rows of the locomotives, or those of the run by their quantity.
  std::vector<Row> locoRows() const {
    std::vector<Row> rows;
    for (const Row& row : cells("summary.csv")) {
      if (row[1] != "" && row[1] != "vehicle") rows.push_back(row);
    }
    return rows;
  }
  std::map<std::string, Row> runRows() const {
    std::map<std::string, Row> rows;
    for (const Row& row : cells("summary.csv")) {
      if (row[1].empty()) rows[row[2]] = row;
    }
    return rows;
  }

  fixtures::HandMadeRun run_;
};

TEST_F(SummaryWriterTest, BeginsWithItsHeaderAndHasSixColumnsEverywhere) {
  run_.scenario.output.report_locations_m = {3000.0};
  ltd::SummaryWriter writer(run_.scenario, path("summary.csv"));
  run_.start(writer);
  writer.onEnd(run_.state, {});
  EXPECT_EQ(cells("summary.csv").front(), (Row{"model", "vehicle", "quantity", "unit", "location_km", "value"}));
  for (const Row& row : cells("summary.csv")) EXPECT_EQ(row.size(), 6u);
}

TEST_F(SummaryWriterTest, InterpolatesLinearlyInPlaceForEveryLocomotive) {
  // From 3000 to 3010 m, 3002.5 m is a quarter of the way: so is every value, exactly (all are dyadic).
  run_.scenario.output.report_locations_m = {3002.5};
  ltd::SummaryWriter writer(run_.scenario, path("summary.csv"));
  run_.start(writer);
  ltd::TrainState next = run_.state;
  next.s_m = {3028.5, 3010.0, 2991.5, 2973.0};
  next.v_mps = {9.0, 6.0, 9.0, 8.0};
  next.traction_N = {400.0, 800.0};
  next.loco_energy[0] = {1000.0, 2000.0, 4000.0, 64.0, 128.0, 256.0};
  next.loco_energy[1] = {8000.0, 16000.0, 32000.0, 512.0, 1024.0, 2048.0};
  run_.stepTo(writer, next);
  writer.onEnd(run_.state, {});
  const std::vector<Row> expected = {{"1d", "2", "traction_force", "N", "3.0025", "100"},
                                     {"1d", "2", "speed", "m/s", "3.0025", "3"},
                                     {"1d", "2", "time", "s", "3.0025", "0.0005"},
                                     {"1d", "2", "energy_rail", "J", "3.0025", "250"},
                                     {"1d", "2", "energy_rim", "J", "3.0025", "500"},
                                     {"1d", "2", "energy_slip", "J", "3.0025", "1000"},
                                     {"1d", "2", "energy_brake_rail", "J", "3.0025", "16"},
                                     {"1d", "2", "energy_recovered_rim", "J", "3.0025", "32"},
                                     {"1d", "2", "energy_shoes", "J", "3.0025", "64"},
                                     {"1d", "4", "traction_force", "N", "3.0025", "200"},
                                     {"1d", "4", "speed", "m/s", "3.0025", "5"},
                                     {"1d", "4", "time", "s", "3.0025", "0.0005"},
                                     {"1d", "4", "energy_rail", "J", "3.0025", "2000"},
                                     {"1d", "4", "energy_rim", "J", "3.0025", "4000"},
                                     {"1d", "4", "energy_slip", "J", "3.0025", "8000"},
                                     {"1d", "4", "energy_brake_rail", "J", "3.0025", "128"},
                                     {"1d", "4", "energy_recovered_rim", "J", "3.0025", "256"},
                                     {"1d", "4", "energy_shoes", "J", "3.0025", "512"}};
  EXPECT_EQ(locoRows(), expected);
}

TEST_F(SummaryWriterTest, OfASupplyItShowsWhatNobodyGaveAndWhatTheChainDoesNotExplain) {
  const std::string text = fixtures::supplyHead("storage") + fixtures::storageText();
  const ltd::PowerSupply battery =
      fixtures::readMap(text, [](rail::YamlReader reader) { return ltd::PowerSupply::read(reader, 0.0); });
  for (ltd::PowerSupply& supply : run_.scenario.train.supplies) supply = battery;
  run_.scenario.output.report_locations_m = {3002.5};
  ltd::SummaryWriter writer(run_.scenario, path("summary.csv"));
  run_.start(writer);
  ltd::TrainState next = run_.state;
  next.s_m[1] += 10.0;
  next.supply[0].motored_rim_J = 400.0;
  next.supply[0].unserved_J = 160.0;
  run_.stepTo(writer, next);
  writer.onEnd(run_.state, {});
  std::map<std::string, std::string> of_first;
  for (const Row& row : locoRows())
    if (row[1] == "2") of_first[row[2] + " " + row[3]] = row[5];
  EXPECT_EQ(of_first["energy_unserved J"], "40");
  EXPECT_EQ(of_first["energy_supply_residual J"], "-60");  // (F12): a quarter of 160 - 400
  EXPECT_EQ(of_first.count("energy_fuel J"), 0u);
  for (const ltd::SupplyFigure& figure : ltd::kSupplyFigures)
    EXPECT_EQ(of_first.count(std::string("energy_") + figure.name + " J"), (battery.*figure.concerns)() ? 1u : 0u)
        << figure.name;
}

TEST_F(SummaryWriterTest, WhatIsAskedBeyondItsRatedPowerIsTheEnginesOnly) {
  using fixtures::supplyHead;
  const std::map<std::string, bool> has_engine = {
      {supplyHead("diesel") + fixtures::engineText(), true},
      {supplyHead("diesel_storage") + fixtures::engineText() + fixtures::storageText(), true},
      {supplyHead("storage") + fixtures::storageText(), false},
      {supplyHead("overhead_line") + fixtures::lineText(true), false}};
  for (const auto& [text, has] : has_engine) {
    fixtures::HandMadeRun run;
    run.scenario.output.report_locations_m = {3002.5};
    const ltd::PowerSupply read =
        fixtures::readMap(text, [](rail::YamlReader reader) { return ltd::PowerSupply::read(reader, 0.0); });
    for (ltd::PowerSupply& supply : run.scenario.train.supplies) supply = read;
    ltd::SummaryWriter writer(run.scenario, path("summary.csv"));
    run.start(writer);
    ltd::TrainState next = run.state;
    next.s_m[1] += 10.0;
    next.supply[0].overload_J = 8.0;
    run.stepTo(writer, next);
    writer.onEnd(run.state, {});
    std::vector<std::string> values;
    for (const Row& row : locoRows())
      if (row[1] == "2" && row[2] == "energy_overload") values.push_back(row[5]);
    EXPECT_EQ(values, has ? std::vector<std::string>{"2"} : std::vector<std::string>{}) << text;
  }
}

TEST_F(SummaryWriterTest, ReportsEveryLocationOnceHoweverManyLieInAStepAndNoneThatIsNotReached) {
  run_.scenario.output.report_locations_m = {3000.0, 3001.0, 3002.0, 3002.5, 3004.0};
  ltd::SummaryWriter writer(run_.scenario, path("summary.csv"));
  run_.start(writer);                                                               // 3000.0
  for (const double by_m : {0.5, 2.0, -1.0, 1.0, 0.25}) run_.moveBy(writer, by_m);  // 3002.5 exactly in the second
  writer.onEnd(run_.state, {});
  std::vector<std::string> locations;
  for (const Row& row : locoRows()) {
    if (row[1] == "2" && row[2] == "time") locations.push_back(row[4] + " " + row[5]);
  }
  EXPECT_EQ(locations, (std::vector<std::string>{"3 0", "3.001 0.0025", "3.002 0.0035", "3.0025 0.004"}));
}

TEST_F(SummaryWriterTest, RunRowsHaveNeitherVehicleNorPlaceAndChangesSinceTheStart) {
  ltd::SummaryWriter writer(run_.scenario, path("summary.csv"));
  run_.start(writer);
  run_.moveBy(writer, 5.0);
  rail::EnergyAccount& a = run_.state.account;
  a.traction_rail = 1000.0, a.traction_rim = 1100.0, a.slip_loss = 90.0, a.propulsion_resistance = 80.0;
  a.curving_resistance = 70.0, a.grade = 65.0, a.coupler_loss = 60.0;
  a.brake_rail = 7.0, a.recovered_rim = 5.0, a.shoes = 1.0, a.air_brake = 3.0;
  a.kinetic_start = 300.0, a.kinetic = 350.0;
  a.potential_start = 200.0, a.potential = 240.0;
  a.coupler_stored_start = 10.0, a.coupler_stored = 40.0;
  writer.onEnd(run_.state, {});
  const std::map<std::string, std::pair<std::string, std::string>> expected = {
      {"account_traction_rail", {"J", "1000"}},
      {"account_traction_rim", {"J", "1100"}},
      {"account_slip_loss", {"J", "90"}},
      {"account_inside_locomotives", {"J", "11"}},  // 1100 - 5 - (1000 - 7) - 90 - 1
      {"account_brake_rail", {"J", "7"}},
      {"account_recovered_rim", {"J", "5"}},
      {"account_shoes", {"J", "1"}},
      {"account_air_brake", {"J", "3"}},
      {"account_propulsion_resistance", {"J", "80"}},
      {"account_curving_resistance", {"J", "70"}},
      {"account_grade", {"J", "65"}},
      {"account_coupler_loss", {"J", "60"}},
      {"account_coupler_stored", {"J", "30"}},
      {"account_kinetic", {"J", "50"}},
      {"account_potential", {"J", "40"}},
      {"account_residual", {"J", "660"}},
      {"energy_residual_relative", {"1", "0.66"}},
      {"final_time", {"s", "0.002"}},
      {"final_speed", {"m/s", "2"}},
      {"final_location", {"m", "3005"}},
      {"rotary_inertia", {"1", "0"}}};
  const std::map<std::string, Row> rows = runRows();
  for (const auto& [quantity, unit_and_value] : expected) {
    ASSERT_EQ(rows.count(quantity), 1u) << quantity;
    EXPECT_EQ(rows.at(quantity), (Row{"1d", "", quantity, unit_and_value.first, "", unit_and_value.second}));
  }
  EXPECT_EQ(rows.count("real_time_factor"), 1u);
}

TEST_F(SummaryWriterTest, KeepsTheLargestDraftBuffAndStepUseOfTheWholeRun) {
  ltd::SummaryWriter writer(run_.scenario, path("summary.csv"));
  run_.start(writer);
  run_.forces.coupler[0].force_N = 500.0;
  run_.forces.coupler[2].force_N = -900.0;
  run_.forces.step_use = 0.25;
  run_.moveBy(writer, 1.0);
  run_.forces.coupler[0].force_N = 100.0;
  run_.forces.coupler[2].force_N = 450.0;
  run_.forces.step_use = 0.125;
  run_.moveBy(writer, 1.0);
  writer.onEnd(run_.state, {});
  EXPECT_EQ(runRows().at("largest_draft").back(), "500");
  EXPECT_EQ(runRows().at("largest_buff").back(), "900");
  EXPECT_EQ(runRows().at("largest_step_use").back(), "0.25");
}

TEST_F(SummaryWriterTest, SaysThatRotaryInertiaWasCounted) {
  run_.scenario.rotary_inertia = true;
  ltd::SummaryWriter writer(run_.scenario, path("summary.csv"));
  run_.start(writer);
  writer.onEnd(run_.state, {});
  EXPECT_EQ(runRows().at("rotary_inertia").back(), "1");
}

}  // namespace
