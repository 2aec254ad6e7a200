#pragma once

#include <vector>

#include "ltd_sim/outcome.hpp"
#include "ltd_sim/scenario.hpp"
#include "ltd_sim/train_dynamics.hpp"

namespace ltd {

/// What happened in one committed step: from `before` (t_k) to `after` (t_k+1).
struct StepRecord {
  const TrainSnapshot& before;
  const TrainState& after;
  const TrainForces& forces;                              ///< at t_k
  const std::vector<loco::LocoForce>& loco_forces;        ///< per locomotive, as sent
  const std::vector<const loco::LocoTraction*>& answers;  ///< per locomotive
};

/// Looks on at a run and writes something down. Offline and graph have the same observers, so the same outputs.
/// The stored energies in a state's account are up to date at the start, at the end, and whenever the time is a whole
/// multiple of the scenario's telemetry or timeseries interval.
class RunObserver {
 public:
  virtual ~RunObserver() = default;
  virtual void onStart(const TrainState& state) { (void)state; }
  virtual void onStep(const StepRecord& record) { (void)record; }
  /// The run stands still after a step, held or at its end, maybe off the telemetry's grid. The step's record once
  /// more, and maybe again.
  virtual void onHold(const StepRecord& record) { (void)record; }
  virtual void onEnd(const TrainState& state, const Outcome& outcome) { (void)state, (void)outcome; }
};

}  // namespace ltd
