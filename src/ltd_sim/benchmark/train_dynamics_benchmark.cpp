// Nanoseconds per vehicle and macro step of LTD alone: forces, one step and its account, for trains of 10, 108 and 1000
// vehicles of which the first three are locomotives. No locomotive computes here; their answers are given.

#include <benchmark/benchmark.h>

#include <string>

#include "ltd_sim/scenario.hpp"
#include "ltd_sim/train_dynamics.hpp"

namespace {

void BM_TrainDynamicsStep(benchmark::State& state) {
  const auto vehicles = static_cast<int>(state.range(0));
  const ltd::Scenario scenario = ltd::Scenario::load(std::string(CONFIG_DIR) + "/scenarios/paper_1d.yaml",
                                                     {{"train.groups.1.count", std::to_string(vehicles - 3)},
                                                      {"track.start_km", "-20"},
                                                      {"track.grades.0.from_km", "-20"},
                                                      {"track.speed_limits.0.from_km", "-20"}});
  ltd::TrainDynamics dynamics(scenario.train, scenario.track, scenario.driver, scenario.air_brake, scenario.macro_step);
  ltd::TrainState train = dynamics.initialState(scenario.run.start_location_m, scenario.run.start_speed_mps);
  ltd::TrainForces forces;
  loco::LocoTraction pulling;
  pulling.traction_N = 200e3;
  const std::vector<const loco::LocoTraction*> answers(scenario.train.locomotives.size(), &pulling);
  const auto step = [&] {
    dynamics.computeForces(train, forces);
    std::string fault = dynamics.computeSpeeds(train, forces, answers);
    dynamics.advance(train, forces, answers);
    return fault;
  };
  for (int i = 0; i < 2000; ++i) step();  // into the slack, so that couplers pull
  for (auto _ : state) benchmark::DoNotOptimize(step());
  state.counters["per_vehicle_and_step"] = benchmark::Counter(
      static_cast<double>(vehicles), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(BM_TrainDynamicsStep)->Arg(10)->Arg(108)->Arg(1000);

}  // namespace

BENCHMARK_MAIN();
