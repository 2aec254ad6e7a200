#pragma once

#include <string>
#include <vector>

#include "ltd_sim/csv_file.hpp"
#include "ltd_sim/run_observer.hpp"

namespace ltd {

/// energy_sections.csv: energy of all locomotives between neighbouring section boundaries (place of the leading
/// locomotive) and over all of them, in kWh and in kWh per 1000 gross tonne kilometres (mass of the whole train,
/// locomotives included), at the rail (Eq. 4) and at the wheel rims, with the time taken and the speed at the end: less
/// energy is no saving when the train is slower. Then what the brakes took: at the rail, recovered at the rims, heat in
/// the wagons' shoes; and behind the rims, of locomotives with a supply: net from storages, lines, to resistors, fuel.
class SectionWriter : public RunObserver {
 public:
  SectionWriter(const Scenario& scenario, const std::string& path);
  void onStart(const TrainState& state) override;
  void onStep(const StepRecord& record) override;
  void onEnd(const TrainState& state, const Outcome& outcome) override;

 private:
  struct Mark {
    double location_m, time_s, speed_mps;
    std::vector<double> stages;  ///< cumulative energies in the order of kStages [J], litres last
  };
  std::vector<double> stagesOf(const TrainSnapshot& state) const;
  Mark markAt(double location_m, double w, const TrainSnapshot& before, const TrainSnapshot& after) const;
  void writeRow(const Mark& from, const Mark& to);

  const Scenario& scenario_;
  CsvFile file_;
  std::size_t lead_;
  double gross_mass_t_;
  std::vector<Mark> marks_;
};

}  // namespace ltd
