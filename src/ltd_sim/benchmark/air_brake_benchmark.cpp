// Time per macro step of the air brake of the paper's train (108 vehicles): while cylinders fill and release, at rest,
// and the shoes' forces of all vehicles.

#include <benchmark/benchmark.h>

#include <string>

#include "ltd_sim/air_brake.hpp"
#include "ltd_sim/scenario.hpp"

namespace {

ltd::TrainModel paperTrain() {
  return ltd::Scenario::load(std::string(CONFIG_DIR) + "/scenarios/paper_1d.yaml", {}).train;
}

ltd::AirBrake uicBrake(const ltd::TrainModel& train) {
  rail::Problems problems;
  const std::string file = std::string(CONFIG_DIR) + "/brakes/uic_g.yaml";
  const rail::Document document = rail::Document::load(file, {}, problems);
  const ltd::AirBrake brake = ltd::AirBrake::read(rail::YamlReader(document, problems), train);
  problems.throwIfAny();
  return brake;
}

constexpr rail::Nanoseconds kStep = 2000000;  // the paper's runs: 2 ms
constexpr std::int64_t kChange = 20000;       // steps: 40 s on, 40 s off
constexpr double kFullService_Pa = 3.5e5;

void BM_AirBrakeMoving(benchmark::State& state) {
  const ltd::AirBrake brake = uicBrake(paperTrain());
  ltd::AirBrake::State memory = brake.initialState();
  ltd::DriverCommand command;
  std::int64_t step = 0;
  for (auto _ : state) {
    command.pipe_pressure_Pa = step / kChange % 2 == 0 ? kFullService_Pa : ltd::kChargedPipe_Pa;
    brake.step(command, kStep, memory);
    ++step;
  }
}
BENCHMARK(BM_AirBrakeMoving);

void BM_AirBrakeAtRest(benchmark::State& state) {
  const ltd::AirBrake brake = uicBrake(paperTrain());
  ltd::AirBrake::State memory = brake.initialState();
  for (std::int64_t step = 0; step < kChange; ++step) brake.step({}, kStep, memory);
  for (auto _ : state) brake.step({}, kStep, memory);
}
BENCHMARK(BM_AirBrakeAtRest);

void BM_ShoeForces(benchmark::State& state) {
  const ltd::TrainModel train = paperTrain();
  const ltd::AirBrake brake = uicBrake(train);
  ltd::AirBrake::State memory = brake.initialState();
  ltd::DriverCommand command;
  command.pipe_pressure_Pa = kFullService_Pa;
  for (std::int64_t step = 0; step < kChange; ++step) brake.step(command, kStep, memory);
  for (auto _ : state) {
    double sum_N = 0.0;
    for (std::size_t i = 0; i < train.vehicles.size(); ++i) sum_N += brake.shoeForce(i, 10.0, memory);
    benchmark::DoNotOptimize(sum_N);
  }
}
BENCHMARK(BM_ShoeForces);

}  // namespace

BENCHMARK_MAIN();
