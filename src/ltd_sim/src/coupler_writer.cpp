#include "ltd_sim/coupler_writer.hpp"

#include <cmath>

#include "rail_core/constants.hpp"

namespace ltd {

CouplerWriter::CouplerWriter(const Scenario& scenario, const std::string& path)
    : scenario_(scenario),
      file_(path, {"coupler", "largest_draft_N", "draft_time_s", "draft_location_km", "largest_buff_N", "buff_time_s",
                   "buff_location_km"}),
      draft_(scenario.train.coupler_type.size()),
      buff_(scenario.train.coupler_type.size()) {}

void CouplerWriter::onStep(const StepRecord& record) {
  for (std::size_t i = 0; i < draft_.size(); ++i) {
    const double F = record.forces.coupler[i].force_N;
    Extreme& extreme = F > 0.0 ? draft_[i] : buff_[i];
    if (std::abs(F) <= extreme.force_N) continue;
    extreme.force_N = std::abs(F);
    extreme.time_s = static_cast<double>(record.before.step) * rail::toSeconds(scenario_.macro_step);
    extreme.location_m = record.before.s_m[scenario_.train.locomotives.front().vehicle];
  }
}

void CouplerWriter::onEnd(const TrainState&, const Outcome&) {
  for (std::size_t i = 0; i < draft_.size(); ++i) {
    std::vector<std::string> row = {std::to_string(i + 1)};
    addCells(draft_[i], row);
    addCells(buff_[i], row);
    file_.row(row);
  }
  file_.flush();
}

void CouplerWriter::addCells(const Extreme& extreme, std::vector<std::string>& row) {
  const bool seen = extreme.force_N > 0.0;
  row.push_back(allDigits(extreme.force_N));
  row.push_back(seen ? allDigits(extreme.time_s) : "");
  row.push_back(seen ? allDigits(extreme.location_m / rail::kMetresPerKilometre) : "");
}

}  // namespace ltd
