// Nanoseconds for the creep force of one contact: all that a right-hand side does for it, once patch and creepage are
// known. The contact is the 2D locomotive's at 7 % creep and 4.4 m/s; FASTSIM has some lateral creep and spin too.

#include <benchmark/benchmark.h>

#include "loco_dynamics/contact/creep_law.hpp"
#include "loco_dynamics/contact/hertz.hpp"

namespace {

loco::CreepLawParameters table1(loco::CreepMethod method, int n) {
  loco::CreepLawParameters parameters;
  parameters.method = method;
  parameters.friction = {0.35, 0.40, 0.275};
  parameters.reduction = {0.075, 0.0008, 0.30};
  parameters.polach = {0.3, 0.1};
  parameters.cells = parameters.strips = n;
  return parameters;
}

void compute(benchmark::State& state, const loco::CreepLawParameters& parameters, loco::Creepage creepage) {
  const loco::CreepLaw law(parameters);
  const loco::ContactPatch patch = loco::makeContactPatch(6.612e-3, 9.525e-3, 109.5e3, 82e9, 0.28);
  for (auto _ : state) {
    benchmark::DoNotOptimize(creepage);
    benchmark::DoNotOptimize(law.computeForce(patch, creepage));
  }
}

void BM_Fastsim(benchmark::State& state) {
  compute(state, table1(loco::CreepMethod::kModfastsim, static_cast<int>(state.range(0))), {-0.07, 0.01, 0.3, 0.31});
}
BENCHMARK(BM_Fastsim)->Arg(1)->Arg(10)->Arg(20)->Arg(32);

void BM_Closed(benchmark::State& state) {
  compute(state, table1(loco::CreepMethod::kClosed, 1), {-0.07, 0.0, 0.0, 0.308});
}
BENCHMARK(BM_Closed);

void BM_Polach(benchmark::State& state) {
  compute(state, table1(loco::CreepMethod::kPolach, 1), {-0.07, 0.01, 0.3, 0.31});
}
BENCHMARK(BM_Polach);

void BM_HertzEllipse(benchmark::State& state) {
  const loco::HertzContact contact({1.0 / 0.5335, 1.0 / 0.3 - 2.25}, {210e9, 0.28});
  double approach = 9e-5;
  for (auto _ : state) {
    benchmark::DoNotOptimize(approach);
    benchmark::DoNotOptimize(contact.computeEllipse(contact.computeNormalForce(approach)));
  }
}
BENCHMARK(BM_HertzEllipse);

}  // namespace

BENCHMARK_MAIN();
