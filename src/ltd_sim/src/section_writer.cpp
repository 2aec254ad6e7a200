#include "ltd_sim/section_writer.hpp"

#include <array>

#include "ltd_sim/energy_figures.hpp"
#include "rail_core/constants.hpp"

namespace ltd {

namespace {

/// Stages of the energy whose sums over the train are told, in the order of the columns.
constexpr std::array<const char*, 8> kStages = {"energy_rail", "energy_rim",      "brake_rail", "recovered_rim",
                                                "air_brake",   "storage_net_out", "line_net",   "to_resistors"};

std::vector<std::string> columns() {
  std::vector<std::string> names = {"from_km", "to_km", "time_s", "final_speed_mps"};
  for (const char* unit : {"_kWh", "_kWh_per_1000_gross_t_km"})
    for (std::size_t i = 0; i < 2; ++i) names.push_back(std::string(kStages[i]) + unit);
  for (std::size_t i = 2; i < kStages.size(); ++i) names.push_back(std::string(kStages[i]) + "_kWh");
  for (const char* name : {"fuel_kWh", "fuel_l", "fuel_l_per_1000_gross_t_km"}) names.emplace_back(name);
  return names;
}

}  // namespace

SectionWriter::SectionWriter(const Scenario& scenario, const std::string& path)
    : scenario_(scenario),
      file_(path, columns()),
      lead_(scenario.train.locomotives.front().vehicle),
      gross_mass_t_(scenario.train.grossMass_t()) {}

/// Cumulative sums over the train: kStages, fuel [J], litres.
std::vector<double> SectionWriter::stagesOf(const TrainSnapshot& state) const {
  const rail::EnergyAccount& a = state.account;
  double storage_J = 0.0, line_J = 0.0, resistors_J = 0.0, fuel_J = 0.0, litres = 0.0;
  for (std::size_t i = 0; i < state.supply.size(); ++i) {
    const PowerSupply::State& s = state.supply[i];
    storage_J += s.storage_out_J - s.storage_in_J;
    line_J += s.line_drawn_J - s.line_returned_J;
    resistors_J += s.to_resistors_J;
    fuel_J += s.fuel_J;
    litres += scenario_.train.supplies[scenario_.train.locomotives[i].type].computeLitres(s);
  }
  return {a.traction_rail, a.traction_rim, a.brake_rail, a.recovered_rim, a.air_brake,
          storage_J,       line_J,         resistors_J,  fuel_J,          litres};
}

SectionWriter::Mark SectionWriter::markAt(double location_m, double w, const TrainSnapshot& before,
                                          const TrainSnapshot& after) const {
  const auto between = [w](double a, double b) { return a + w * (b - a); };
  const double H = rail::toSeconds(scenario_.macro_step);
  Mark mark{location_m, between(static_cast<double>(before.step), static_cast<double>(after.step)) * H,
            between(before.v_mps[lead_], after.v_mps[lead_]), stagesOf(before)};
  const std::vector<double> then = stagesOf(after);
  for (std::size_t i = 0; i < then.size(); ++i) mark.stages[i] = between(mark.stages[i], then[i]);
  return mark;
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
  std::vector<double> spent;
  for (std::size_t i = 0; i < to.stages.size(); ++i) spent.push_back(to.stages[i] - from.stages[i]);
  const double distance_km = (to.location_m - from.location_m) / rail::kMetresPerKilometre;
  const double fuel_J = spent[kStages.size()], litres = spent[kStages.size() + 1];
  std::vector<std::string> row = {allDigits(from.location_m / rail::kMetresPerKilometre),
                                  allDigits(to.location_m / rail::kMetresPerKilometre),
                                  allDigits(to.time_s - from.time_s), allDigits(to.speed_mps)};
  for (std::size_t i = 0; i < 2; ++i) row.push_back(allDigits(spent[i] / rail::kJoulesPerKilowattHour));
  for (std::size_t i = 0; i < 2; ++i)
    row.push_back(allDigits(computeKilowattHoursPer1000TonneKm(spent[i], gross_mass_t_, distance_km)));
  for (std::size_t i = 2; i < kStages.size(); ++i) row.push_back(allDigits(spent[i] / rail::kJoulesPerKilowattHour));
  row.push_back(allDigits(fuel_J / rail::kJoulesPerKilowattHour));
  row.push_back(allDigits(litres));
  row.push_back(allDigits(computeLitresPer1000TonneKm(litres, gross_mass_t_, distance_km)));
  file_.row(row);
}

}  // namespace ltd
