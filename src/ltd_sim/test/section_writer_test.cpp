#include "ltd_sim/section_writer.hpp"

#include <cstdlib>

#include "hand_made_run.hpp"
#include "scratch_directory.hpp"

namespace {

using Row = std::vector<std::string>;

class SectionWriterTest : public fixtures::ScratchDirectory {
 protected:
  /// Runs to `place_m` with the given energies of all locomotives there, in one step.
  void runTo(ltd::SectionWriter& writer, double place_m, double rail_J, double rim_J, double v_mps = 2.0) {
    ltd::TrainState next = run_.state;
    next.s_m[1] = place_m;
    next.v_mps[1] = v_mps;
    next.account.traction_rail = rail_J;
    next.account.traction_rim = rim_J;
    run_.stepTo(writer, next);
  }
  static double number(const std::string& cell) { return std::strtod(cell.c_str(), nullptr); }

  fixtures::HandMadeRun run_;
};

TEST_F(SectionWriterTest, GivesEnergyPerSectionAndPerThousandGrossTonneKilometres) {
  run_.scenario.output.section_boundaries_m = {3000.0, 3500.0, 5000.0};
  ltd::SectionWriter writer(run_.scenario, path("sections.csv"));
  run_.start(writer);
  runTo(writer, 3500.0, 36e6, 72e6, 8.0);     // 10 and 20 kWh
  runTo(writer, 5000.0, 144e6, 216e6, 16.0);  // 30 and 40 kWh more
  writer.onEnd(run_.state, {});
  const std::vector<Row> rows = cells("sections.csv");
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0], (Row{"from_km", "to_km", "time_s", "final_speed_mps", "energy_rail_kWh", "energy_rim_kWh",
                          "energy_rail_kWh_per_1000_gross_t_km", "energy_rim_kWh_per_1000_gross_t_km", "brake_rail_kWh",
                          "recovered_rim_kWh", "air_brake_kWh", "storage_net_out_kWh", "line_net_kWh",
                          "to_resistors_kWh", "fuel_kWh", "fuel_l", "fuel_l_per_1000_gross_t_km"}));
  // Gross mass 2 x 134 + 2 x 120 = 508 t; the sections are 0.5, 1.5 and, over all, 2 km long.
  const double expected[3][8] = {{3.0, 3.5, 0.002, 8.0, 10.0, 20.0, 10.0 / (0.508 * 0.5), 20.0 / (0.508 * 0.5)},
                                 {3.5, 5.0, 0.002, 16.0, 30.0, 40.0, 30.0 / (0.508 * 1.5), 40.0 / (0.508 * 1.5)},
                                 {3.0, 5.0, 0.004, 16.0, 40.0, 60.0, 40.0 / (0.508 * 2.0), 60.0 / (0.508 * 2.0)}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 8; ++j)
      EXPECT_NEAR(number(rows[i + 1][j]), expected[i][j], 1e-13 * expected[i][j]) << i << " " << rows[0][j];
  }
}

TEST_F(SectionWriterTest, TellsWhatBrakesTookAndWhatIsBehindTheRimsOfAllLocomotives) {
  run_.scenario.output.section_boundaries_m = {3000.0, 5000.0};
  ltd::SectionWriter writer(run_.scenario, path("sections.csv"));
  run_.start(writer);
  ltd::TrainState next = run_.state;
  next.s_m[1] = 5000.0;
  next.account.brake_rail = 3.6e6, next.account.recovered_rim = 7.2e6, next.account.air_brake = 10.8e6;
  for (ltd::PowerSupply::State& supply : next.supply) {
    supply.storage_in_J = 3.6e6, supply.storage_out_J = 5.4e6;
    supply.line_drawn_J = 9.0e6, supply.line_returned_J = 1.8e6;
    supply.to_resistors_J = 36.0e6, supply.fuel_J = 72.0e6;
  }
  run_.stepTo(writer, next);
  writer.onEnd(run_.state, {});
  const std::vector<Row> rows = cells("sections.csv");
  ASSERT_EQ(rows.size(), 2u);
  const double expected[] = {1.0, 2.0, 3.0, 1.0, 4.0, 20.0, 40.0};
  for (std::size_t j = 0; j < 7; ++j) EXPECT_NEAR(number(rows[1][8 + j]), expected[j], 1e-12) << rows[0][8 + j];
}

TEST_F(SectionWriterTest, InterpolatesLinearlyInPlaceAtABoundary) {
  run_.scenario.output.section_boundaries_m = {3000.0, 3002.5};
  ltd::SectionWriter writer(run_.scenario, path("sections.csv"));
  run_.start(writer);
  runTo(writer, 3010.0, 4 * 3.6e6, 8 * 3.6e6, 6.0);
  writer.onEnd(run_.state, {});
  const std::vector<Row> rows = cells("sections.csv");
  ASSERT_EQ(rows.size(), 2u);  // one section is also all of them: no row twice
  EXPECT_EQ(Row(rows[1].begin(), rows[1].begin() + 6), (Row{"3", "3.0025", "0.0005", "3", "1", "2"}));
}

TEST_F(SectionWriterTest, SeveralBoundariesMayLieInOneStep) {
  run_.scenario.output.section_boundaries_m = {3001.0, 3002.0, 3003.0};
  ltd::SectionWriter writer(run_.scenario, path("sections.csv"));
  run_.start(writer);
  runTo(writer, 3004.0, 4 * 3.6e6, 4 * 3.6e6);
  writer.onEnd(run_.state, {});
  const std::vector<Row> rows = cells("sections.csv");
  ASSERT_EQ(rows.size(), 4u);
  for (const std::size_t i : {1u, 2u}) EXPECT_NEAR(number(rows[i][4]), 1.0, 1e-12);
  EXPECT_NEAR(number(rows[3][4]), 2.0, 1e-12);
}

TEST_F(SectionWriterTest, AnUnfinishedSectionHasNoRowAndTheSumEndsAtTheLastBoundaryReached) {
  run_.scenario.output.section_boundaries_m = {3000.0, 3001.0, 3002.0, 3900.0};
  ltd::SectionWriter writer(run_.scenario, path("sections.csv"));
  run_.start(writer);
  runTo(writer, 3500.0, 3.6e6, 3.6e6);
  writer.onEnd(run_.state, {});
  const std::vector<Row> rows = cells("sections.csv");
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[3][0] + " " + rows[3][1], "3 3.002");
}

TEST_F(SectionWriterTest, WithoutBoundariesThereIsOnlyAHeader) {
  ltd::SectionWriter writer(run_.scenario, path("sections.csv"));
  run_.start(writer);
  runTo(writer, 3500.0, 3.6e6, 3.6e6);
  writer.onEnd(run_.state, {});
  EXPECT_EQ(cells("sections.csv").size(), 1u);
}

}  // namespace
