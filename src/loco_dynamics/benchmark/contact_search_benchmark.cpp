// Nanoseconds for the contacts of one wheel: what a right-hand side of the 3D locomotive needs twelve times.

#include <benchmark/benchmark.h>

#include "loco_dynamics/contact/hertz.hpp"
#include "loco_dynamics/profile/contact_search.hpp"
#include "loco_dynamics/profile/standard_profiles.hpp"

namespace {

/// A wheelset displaced to the right, its right wheel searched; 90 um deep, as loaded by 109.5 kN.
void search(benchmark::State& state, const char* wheel, double right_mm, double height_mm, double roll_mrad) {
  const loco::ContactSearch search(
      loco::WheelRailGeometry(loco::makeWheelPoints(wheel), loco::makeRailPoints("UIC60"), {}));
  loco::WheelsetPose pose{-1e-3 * right_mm, 1e-3 * height_mm, 1e-3 * roll_mrad, 2e-3};
  std::array<loco::ContactRegion, loco::kMostContacts> regions;
  std::size_t count = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(pose);
    count = search.find(loco::Side::kRight, pose, regions);
    benchmark::DoNotOptimize(regions);
  }
  state.counters["contacts"] = static_cast<double>(count);
}
BENCHMARK_CAPTURE(search, s1002_centred, "S1002", 0.0, -0.266, 0.0);
BENCHMARK_CAPTURE(search, s1002_right, "S1002", 4.0, -0.152, -0.254);
BENCHMARK_CAPTURE(search, s1002_flange, "S1002", 6.0, 0.113, -0.636);
BENCHMARK_CAPTURE(search, s1002_lifted, "S1002", 0.0, 5.0, 0.0);
BENCHMARK_CAPTURE(search, cone_two_points, "coned_1_20", 7.2, 0.1, 0.0);

}  // namespace

BENCHMARK_MAIN();
