#include "ltd_sim/summary_writer.hpp"

#include <algorithm>

#include "ltd_sim/supply_figures.hpp"
#include "rail_core/constants.hpp"

namespace ltd {

namespace {

/// What rim and shoes explain no better: spin of the wheelsets, motion of the bodies, dampers.
double insideLocomotives(const rail::EnergyAccount& a) {
  return a.traction_rim - a.recovered_rim - (a.traction_rail - a.brake_rail) - a.slip_loss - a.shoes;
}

}  // namespace

SummaryWriter::SummaryWriter(const Scenario& scenario, const std::string& path)
    : scenario_(scenario),
      file_(path, {"model", "vehicle", "quantity", "unit", "location_km", "value"}),
      lead_(scenario.train.locomotives.front().vehicle) {}

void SummaryWriter::onStart(const TrainState& state) {
  const std::vector<double>& locations_m = scenario_.output.report_locations_m;
  while (next_location_ < locations_m.size() && locations_m[next_location_] <= state.s_m[lead_])
    reportLocos(locations_m[next_location_++], 1.0, state, state);
}

void SummaryWriter::onStep(const StepRecord& record) {
  if (steps_ == 0) started_ = std::chrono::steady_clock::now();  // joining takes as long as it takes
  ++steps_;
  noteStepUse(record.forces);
  const std::vector<double>& locations_m = scenario_.output.report_locations_m;
  const double s0 = record.before.s_m[lead_];
  const double s1 = record.after.s_m[lead_];
  while (next_location_ < locations_m.size() && locations_m[next_location_] <= s1) {
    const double location_m = locations_m[next_location_++];
    reportLocos(location_m, (location_m - s0) / (s1 - s0), record.before, record.after);
  }
}

void SummaryWriter::noteStepUse(const TrainForces& forces) {
  largest_step_use_ = std::max(largest_step_use_, forces.step_use);
  for (const Coupler::Force& coupler : forces.coupler) {
    largest_draft_N_ = std::max(largest_draft_N_, coupler.force_N);
    largest_buff_N_ = std::max(largest_buff_N_, -coupler.force_N);
  }
}

void SummaryWriter::reportLocos(double location_m, double w, const TrainSnapshot& before, const TrainSnapshot& after) {
  const auto between = [w](double a, double b) { return a + w * (b - a); };
  const double H = rail::toSeconds(scenario_.macro_step);
  const double time_s = between(static_cast<double>(before.step), static_cast<double>(after.step)) * H;
  const std::string location_km = allDigits(location_m / rail::kMetresPerKilometre);
  for (std::size_t i = 0; i < scenario_.train.locomotives.size(); ++i) {
    const std::size_t v = scenario_.train.locomotives[i].vehicle;
    const auto row = [&](const char* quantity, const char* unit, double value) {
      file_.row(
          {scenario_.train.locomotives[i].model, std::to_string(v + 1), quantity, unit, location_km, allDigits(value)});
    };
    row("traction_force", "N", between(before.traction_N[i], after.traction_N[i]));
    row("speed", "m/s", between(before.v_mps[v], after.v_mps[v]));
    row("time", "s", time_s);
    row("energy_rail", "J", between(before.loco_energy[i].rail, after.loco_energy[i].rail));
    row("energy_rim", "J", between(before.loco_energy[i].rim, after.loco_energy[i].rim));
    row("energy_slip", "J", between(before.loco_energy[i].slip, after.loco_energy[i].slip));
    row("energy_brake_rail", "J", between(before.loco_energy[i].brake_rail, after.loco_energy[i].brake_rail));
    row("energy_recovered_rim", "J", between(before.loco_energy[i].recovered_rim, after.loco_energy[i].recovered_rim));
    row("energy_shoes", "J", between(before.loco_energy[i].shoes, after.loco_energy[i].shoes));
    const PowerSupply& supply = scenario_.train.supplies[scenario_.train.locomotives[i].type];
    if (supply.exists()) reportSupply(supply, before.supply[i], after.supply[i], w, row);
  }
}

void SummaryWriter::reportSupply(const PowerSupply& supply, const PowerSupply::State& b, const PowerSupply::State& a,
                                 double w, const RowOf& row) {
  const auto between = [w](double before, double after) { return before + w * (after - before); };
  for (const SupplyFigure& figure : kSupplyFigures) {
    if (!(supply.*figure.concerns)()) continue;
    row((std::string("energy_") + figure.name).c_str(), "J", between(b.*figure.energy_J, a.*figure.energy_J));
  }
  if (supply.hasEngine()) row("fuel", "l", between(supply.computeLitres(b), supply.computeLitres(a)));
  row("energy_supply_residual", "J", between(b.residual(), a.residual()));
}

void SummaryWriter::runRow(const std::string& quantity, const std::string& unit, double value) {
  file_.row({scenario_.locomotive_model, "", quantity, unit, "", allDigits(value)});
}

double SummaryWriter::realTimeFactor() const {
  if (steps_ < 2) return 0.0;
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - started_;
  return static_cast<double>(steps_ - 1) * rail::toSeconds(scenario_.macro_step) / wall.count();
}

void SummaryWriter::onEnd(const TrainState& state, const Outcome&) {
  const rail::EnergyAccount& a = state.account;
  runRow("account_traction_rail", "J", a.traction_rail);
  runRow("account_traction_rim", "J", a.traction_rim);
  runRow("account_slip_loss", "J", a.slip_loss);
  runRow("account_inside_locomotives", "J", insideLocomotives(a));
  runRow("account_brake_rail", "J", a.brake_rail);
  runRow("account_recovered_rim", "J", a.recovered_rim);
  runRow("account_shoes", "J", a.shoes);
  runRow("account_air_brake", "J", a.air_brake);
  runRow("account_propulsion_resistance", "J", a.propulsion_resistance);
  runRow("account_curving_resistance", "J", a.curving_resistance);
  runRow("account_grade", "J", a.grade);
  runRow("account_coupler_loss", "J", a.coupler_loss);
  runRow("account_coupler_stored", "J", a.coupler_stored - a.coupler_stored_start);
  runRow("account_kinetic", "J", a.kinetic - a.kinetic_start);
  runRow("account_potential", "J", a.potential - a.potential_start);
  runRow("account_residual", "J", a.residual());
  runRow("energy_residual_relative", "1", a.residualRelative());
  runRow("final_time", "s", static_cast<double>(state.step) * rail::toSeconds(scenario_.macro_step));
  runRow("final_speed", "m/s", state.v_mps[lead_]);
  runRow("final_location", "m", state.s_m[lead_]);
  runRow("largest_draft", "N", largest_draft_N_);
  runRow("largest_buff", "N", largest_buff_N_);
  runRow("largest_step_use", "1", largest_step_use_);
  runRow("rotary_inertia", "1", scenario_.rotary_inertia ? 1.0 : 0.0);
  runRow("real_time_factor", "1", realTimeFactor());
  file_.flush();
}

}  // namespace ltd
