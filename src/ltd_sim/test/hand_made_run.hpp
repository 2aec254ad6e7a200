#pragma once

#include <vector>

#include "train_fixtures.hpp"

namespace fixtures {

/// A run made by hand, to be shown to observers: wagon, locomotive, wagon, locomotive; H = 2 ms. Every step is given as
/// the state after it.
class HandMadeRun {
 public:
  HandMadeRun()
      : scenario(makeScenario(makeTrain({paperWagon(), paperLoco(), paperWagon(), paperLoco()}, {1, 3}, draftGear()),
                              makeTrack())) {
    state.s_m = {3018.5, 3000.0, 2981.5, 2963.0};
    state.v_mps = {1.0, 2.0, 3.0, 4.0};
    state.traction_N = {0.0, 0.0};
    state.loco_energy.resize(2);
    forces.coupler.resize(3);
    forces.notch = {5, 3};
    forces.brake_notch = {0, 0};
    state.supply.resize(2);
    state.store_empty_at = {-1, -1};
  }

  void start(ltd::RunObserver& observer) const { observer.onStart(state); }

  /// Shows the step to `next`, which becomes the state.
  void stepTo(ltd::RunObserver& observer, ltd::TrainState next) {
    next.step = state.step + 1;
    observer.onStep({state, next, forces, {}, {}});
    state = next;
  }

  /// Shows a step in which the leading locomotive moves by `distance_m` and nothing else changes.
  void moveBy(ltd::RunObserver& observer, double distance_m) {
    ltd::TrainState next = state;
    next.s_m[1] += distance_m;
    stepTo(observer, next);
  }

  ltd::Scenario scenario;
  ltd::TrainState state;
  ltd::TrainForces forces;
};

}  // namespace fixtures
