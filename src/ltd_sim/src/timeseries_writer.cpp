#include "ltd_sim/timeseries_writer.hpp"

#include <algorithm>
#include <limits>

#include "rail_core/constants.hpp"

namespace ltd {

TimeseriesWriter::TimeseriesWriter(const Scenario& scenario, const std::string& path)
    : scenario_(scenario),
      file_(path,
            {"location_km", "time_s", "speed_mps", "notch", "traction_force_N", "traction_force_train_N",
             "power_rail_train_W", "energy_rail_train_J", "energy_rim_train_J", "largest_draft_N",
             "largest_draft_coupler", "largest_buff_N", "largest_buff_coupler", "speed_limit_mps", "brake_notch",
             "pipe_pressure_bar", "air_brake_force_N", "energy_brake_rail_train_J", "energy_recovered_rim_train_J"}) {}

void TimeseriesWriter::onStart(const TrainState& state) {
  const std::size_t lead = scenario_.train.locomotives.front().vehicle;
  Told told;
  told.speed_limit_mps = std::numeric_limits<double>::infinity();
  for (const double s_m : state.s_m)
    told.speed_limit_mps = std::min(told.speed_limit_mps, scenario_.track.at(s_m).speed_limit_mps);
  told.pipe_pressure_Pa =
      scenario_.air_brake.present() ? scenario_.air_brake.pipePressure(lead, state.air) : kChargedPipe_Pa;
  writeRow(state, told);
}

void TimeseriesWriter::onStep(const StepRecord& record) {
  noteCouplers(record.forces);
  const rail::Nanoseconds t = static_cast<rail::Nanoseconds>(record.after.step) * scenario_.macro_step;
  if (t % scenario_.output.timeseries_interval != 0) return;
  const TrainForces& f = record.forces;
  writeRow(record.after, {f.notch.front(), f.brake_notch.front(), f.view.speed_limit_mps, f.view.pipe_pressure_Pa,
                          f.view.air_brake_N});
}

void TimeseriesWriter::onEnd(const TrainState&, const Outcome&) { file_.flush(); }

void TimeseriesWriter::noteCouplers(const TrainForces& forces) {
  for (std::size_t i = 0; i < forces.coupler.size(); ++i) {
    const double F = forces.coupler[i].force_N;
    if (F > draft_.force_N) draft_ = {F, i + 1};
    if (F < buff_.force_N) buff_ = {F, i + 1};
  }
}

void TimeseriesWriter::writeRow(const TrainState& state, const Told& told) {
  double force_N = 0.0, power_W = 0.0;
  for (std::size_t i = 0; i < state.traction_N.size(); ++i) {
    force_N += state.traction_N[i];
    power_W += state.traction_N[i] * state.v_mps[scenario_.train.locomotives[i].vehicle];
  }
  const std::size_t lead = scenario_.train.locomotives.front().vehicle;
  const auto coupler = [](const Extreme& e) { return e.coupler > 0 ? std::to_string(e.coupler) : std::string(); };
  file_.row({allDigits(state.s_m[lead] / rail::kMetresPerKilometre),
             allDigits(static_cast<double>(state.step) * rail::toSeconds(scenario_.macro_step)),
             allDigits(state.v_mps[lead]), std::to_string(told.notch), allDigits(state.traction_N.front()),
             allDigits(force_N), allDigits(power_W), allDigits(state.account.traction_rail),
             allDigits(state.account.traction_rim), allDigits(draft_.force_N), coupler(draft_),
             allDigits(0.0 - buff_.force_N), /* 0 - x: 0, not -0 */ coupler(buff_), allDigits(told.speed_limit_mps),
             std::to_string(told.brake_notch), allDigits(told.pipe_pressure_Pa / kPascalsPerBar),
             allDigits(told.air_brake_N), allDigits(state.account.brake_rail), allDigits(state.account.recovered_rim)});
  draft_ = {};
  buff_ = {};
}

}  // namespace ltd
