// Nanoseconds for one micro step of a locomotive, the leading one of a paper scenario, under control at 7 % creep.

#include <benchmark/benchmark.h>

#include <stdexcept>
#include <string>

#include "loco_dynamics/loco_factory.hpp"

namespace {

constexpr double kSpeed_mps = 4.42;

void runModel(benchmark::State& state, const std::string& scenario) {
  rail::Problems problems;
  const rail::Document document =
      rail::Document::load(std::string(CONFIG_DIR) + "/scenarios/" + scenario + ".yaml", {}, problems);
  const auto locomotive = loco::makeLocomotive(document, "train.groups.0.vehicle", problems);
  problems.throwIfAny();
  rail::YamlReader steps = rail::YamlReader(document, problems).map("steps");
  loco::LocoForce force;
  force.step_length = rail::wholeNanoseconds(steps.number("macro_step_s", rail::positive())).value();
  const auto micro_steps = force.step_length / *rail::wholeNanoseconds(steps.number("micro_step_s", rail::positive()));
  force.traction_reference_N = 490e3;
  force.rim_power_limit_W = 4.1e6;
  force.speed_mps = kSpeed_mps;
  loco::LocoTraction answer;
  std::vector<double> at = locomotive->equilibriumState(3000.0, kSpeed_mps).state;
  const auto step = [&] {
    locomotive->step(at, force, answer);
    if (!answer.failure.empty()) throw std::runtime_error(answer.failure);
    at.swap(answer.state);
    force.coupler_rear_N = -answer.traction_N;  // steady speed
    ++force.step;
  };
  for (int i = 0; i < 3000; ++i) step();  // until control has settled
  for (auto _ : state) step();
  state.counters["per_micro_step"] = benchmark::Counter(
      static_cast<double>(micro_steps), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["times_real_time"] =
      benchmark::Counter(rail::toSeconds(force.step_length), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK_CAPTURE(runModel, 2d, "paper_2d");
BENCHMARK_CAPTURE(runModel, 3d, "paper_3d");

}  // namespace

BENCHMARK_MAIN();
