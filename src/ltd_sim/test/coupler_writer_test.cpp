#include "ltd_sim/coupler_writer.hpp"

#include "hand_made_run.hpp"
#include "scratch_directory.hpp"

namespace {

using Row = std::vector<std::string>;

class CouplerWriterTest : public fixtures::ScratchDirectory {
 protected:
  void stepWith(ltd::RunObserver& writer, double first_N, double second_N, double third_N) {
    run_.forces.coupler[0].force_N = first_N;
    run_.forces.coupler[1].force_N = second_N;
    run_.forces.coupler[2].force_N = third_N;
    run_.moveBy(writer, 1.0);
  }
  fixtures::HandMadeRun run_;
};

TEST_F(CouplerWriterTest, EveryCouplersLargestDraftAndBuffWithTimeAndPlaceOfTheStepsStart) {
  ltd::CouplerWriter writer(run_.scenario, path("couplers.csv"));
  run_.start(writer);
  stepWith(writer, 10.0, 50.0, -30.0);
  stepWith(writer, 20.0, -40.0, -31.0);
  stepWith(writer, 20.0, 49.0, 0.0);  // no larger than before: the first time counts
  writer.onEnd(run_.state, {});
  const std::vector<Row> rows = cells("couplers.csv");
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0], (Row{"coupler", "largest_draft_N", "draft_time_s", "draft_location_km", "largest_buff_N",
                          "buff_time_s", "buff_location_km"}));
  EXPECT_EQ(rows[1], (Row{"1", "20", "0.002", "3.001", "0", "", ""}));
  EXPECT_EQ(rows[2], (Row{"2", "50", "0", "3", "40", "0.002", "3.001"}));
  EXPECT_EQ(rows[3], (Row{"3", "0", "", "", "31", "0.002", "3.001"}));
}

}  // namespace
