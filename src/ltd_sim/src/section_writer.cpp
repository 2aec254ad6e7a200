#include "ltd_sim/section_writer.hpp"

#include "rail_core/constants.hpp"

namespace ltd {

SectionWriter::SectionWriter(const Scenario& scenario, const std::string& path)
    : scenario_(scenario),
      file_(path, {"from_km", "to_km", "time_s", "final_speed_mps", "energy_rail_kWh", "energy_rim_kWh",
                   "energy_rail_kWh_per_1000_gross_t_km", "energy_rim_kWh_per_1000_gross_t_km"}),
      lead_(scenario.train.locomotives.front().vehicle),
      gross_mass_t_(scenario.train.grossMass_t()) {}

SectionWriter::Mark SectionWriter::markAt(double location_m, double w, const TrainState& before,
                                          const TrainState& after) const {
  const auto between = [w](double a, double b) { return a + w * (b - a); };
  const double H = rail::toSeconds(scenario_.macro_step);
  return {location_m, between(static_cast<double>(before.step), static_cast<double>(after.step)) * H,
          between(before.v_mps[lead_], after.v_mps[lead_]),
          between(before.account.traction_rail, after.account.traction_rail),
          between(before.account.traction_rim, after.account.traction_rim)};
}

void SectionWriter::onStart(const TrainState& state) {
  const std::vector<double>& boundaries_m = scenario_.output.section_boundaries_m;
  if (!boundaries_m.empty() && boundaries_m.front() <= state.s_m[lead_])
    marks_.push_back(markAt(boundaries_m.front(), 1.0, state, state));
}

void SectionWriter::onStep(const StepRecord& record) {
  const std::vector<double>& boundaries_m = scenario_.output.section_boundaries_m;
  const double s0 = record.before.s_m[lead_];
  const double s1 = record.after.s_m[lead_];
  while (marks_.size() < boundaries_m.size() && boundaries_m[marks_.size()] <= s1) {
    const double location_m = boundaries_m[marks_.size()];
    marks_.push_back(markAt(location_m, (location_m - s0) / (s1 - s0), record.before, record.after));
    if (marks_.size() > 1) writeRow(marks_[marks_.size() - 2], marks_.back());
  }
}

void SectionWriter::onEnd(const TrainState&, const Outcome&) {
  if (marks_.size() > 2) writeRow(marks_.front(), marks_.back());
  file_.flush();
}

void SectionWriter::writeRow(const Mark& from, const Mark& to) {
  const double rail_kWh = (to.rail_J - from.rail_J) / rail::kJoulesPerKilowattHour;
  const double rim_kWh = (to.rim_J - from.rim_J) / rail::kJoulesPerKilowattHour;
  const double distance_km = (to.location_m - from.location_m) / rail::kMetresPerKilometre;
  const double thousand_t_km = gross_mass_t_ / 1000.0 * distance_km;
  file_.row({allDigits(from.location_m / rail::kMetresPerKilometre),
             allDigits(to.location_m / rail::kMetresPerKilometre), allDigits(to.time_s - from.time_s),
             allDigits(to.speed_mps), allDigits(rail_kWh), allDigits(rim_kWh), allDigits(rail_kWh / thousand_t_km),
             allDigits(rim_kWh / thousand_t_km)});
}

}  // namespace ltd
