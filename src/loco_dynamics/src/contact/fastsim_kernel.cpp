#include "fastsim_kernel.hpp"

#include <cmath>

// Compiled for wider registers too where the loader can choose at start. Additions, products, quotients and roots round
// the same way in all of them, -ffp-contract=off keeps them apart, and sums never cross lanes: the bits do not depend
// on the choice. Sanitizers do not bear the resolver.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define FASTSIM_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define FASTSIM_CLONES
#endif

namespace loco {

namespace {

/// From the leading edge it is half a cell to the first midpoint; there is no stress yet that could lag.
inline void marchFirstCell(const FastsimMarch& march, double* __restrict q_x, double* __restrict q_y,
                           double* __restrict sum_x, double* __restrict sum_y) {
  const double* const __restrict step_x = march.step_x;
  const double* const __restrict step_y = march.step_y;
  const double bound = march.bound[0];
  const double spin_between = march.step_spin * (march.place[0] + 0.5 / march.cells);
  for (int block = 0; block < march.lanes; block += kFastsimLanes) {
    for (int l = block; l < block + kFastsimLanes; ++l) {
      const double x = 0.5 * step_x[l];
      const double y = 0.5 * (step_y[l] + spin_between);
      const double squared = x * x + y * y;
      const double scale = bound / std::sqrt(squared);
      const bool slips = squared > bound * bound;
      q_x[l] = slips ? x * scale : x;
      q_y[l] = slips ? y * scale : y;
      sum_x[l] = q_x[l];
      sum_y[l] = q_y[l];
    }
  }
}

}  // namespace

FASTSIM_CLONES
void marchStrips(const FastsimMarch& march) {
  alignas(64) double q_x[kFastsimMostLanes];
  alignas(64) double q_y[kFastsimMostLanes];
  const double* const __restrict step_x = march.step_x;
  const double* const __restrict step_y = march.step_y;
  double* const __restrict sum_x = march.sum_x;
  double* const __restrict sum_y = march.sum_y;
  marchFirstCell(march, q_x, q_y, sum_x, sum_y);

  const double spin_cell = march.step_spin * (2.0 / march.cells);
  const double spin_half_cell = march.step_spin * (1.0 / march.cells);
  for (int i = 1; i < march.cells; ++i) {
    const double bound = march.bound[i];
    const double bound_squared = bound * bound;
    const double half_over_bound_squared = 0.5 / bound_squared;
    const double spin_here = march.step_spin * march.place[i];
    for (int block = 0; block < march.lanes; block += kFastsimLanes) {
      for (int l = block; l < block + kFastsimLanes; ++l) {
        const double a_x = step_x[l];
        const double here_y = step_y[l] + spin_here;
        const double a_y = here_y + spin_half_cell;
        const double stick_x = q_x[l] + a_x;
        const double stick_y = q_y[l] + a_y;
        const bool slips = stick_x * stick_x + stick_y * stick_y > bound_squared;

        // (C9): r, step over the distance in which the direction relaxes, 0 where the step does not add to the stress
        const double along = q_x[l] * a_x + q_y[l] * a_y;
        const double r = (along + std::abs(along)) * half_over_bound_squared;
        const double lag = 0.5 + r * (1.0 / 6.0);
        const double growth = 1.0 + r * lag;
        const double slip_x = q_x[l] + growth * a_x;
        const double slip_y = q_y[l] + (growth * here_y + lag * spin_cell);
        const double scale = bound / std::sqrt(slip_x * slip_x + slip_y * slip_y);

        q_x[l] = slips ? slip_x * scale : stick_x;
        q_y[l] = slips ? slip_y * scale : stick_y;
        sum_x[l] += q_x[l];
        sum_y[l] += q_y[l];
      }
    }
  }
}

}  // namespace loco
