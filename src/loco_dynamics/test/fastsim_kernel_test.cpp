#include "../src/contact/fastsim_kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

/// One strip, computed alone, with the kernel's operations in the kernel's order.
void marchOneStrip(const loco::FastsimMarch& march, int l, double& sum_x, double& sum_y) {
  const double step_x = march.step_x[l], step_y = march.step_y[l];
  const double spin_cell = march.step_spin * (2.0 / march.cells),
               spin_half_cell = march.step_spin * (1.0 / march.cells);
  double q_x = 0.5 * step_x, q_y = 0.5 * (step_y + march.step_spin * (march.place[0] + 0.5 / march.cells));
  const double first = q_x * q_x + q_y * q_y;
  if (first > march.bound[0] * march.bound[0]) {
    const double scale = march.bound[0] / std::sqrt(first);
    q_x *= scale;
    q_y *= scale;
  }
  sum_x = q_x;
  sum_y = q_y;
  for (int i = 1; i < march.cells; ++i) {
    const double bound = march.bound[i], here_y = step_y + march.step_spin * march.place[i];
    const double a_y = here_y + spin_half_cell;
    const double stick_x = q_x + step_x, stick_y = q_y + a_y;
    if (stick_x * stick_x + stick_y * stick_y > bound * bound) {
      const double along = q_x * step_x + q_y * a_y;
      const double r = (along + std::abs(along)) * (0.5 / (bound * bound));
      const double lag = 0.5 + r * (1.0 / 6.0), growth = 1.0 + r * lag;
      const double slip_x = q_x + growth * step_x, slip_y = q_y + (growth * here_y + lag * spin_cell);
      const double scale = bound / std::sqrt(slip_x * slip_x + slip_y * slip_y);
      q_x = slip_x * scale;
      q_y = slip_y * scale;
    } else {
      q_x = stick_x;
      q_y = stick_y;
    }
    sum_x += q_x;
    sum_y += q_y;
  }
}

/// Whatever registers this processor has: one lane at a time gives the same bits.
TEST(FastsimKernelTest, GivesTheBitsOfOneStripAtATime) {
  constexpr int kCells = 23, kLanes = 24;
  std::vector<double> place, bound, step_x, step_y;
  for (int i = 0; i < kCells; ++i) {
    place.push_back((kCells - 2 * i - 1) / static_cast<double>(kCells));
    bound.push_back(1.0 - place.back() * place.back());
  }
  for (int l = 0; l < kLanes; ++l) {  // from sticking nearly everywhere to slipping nearly everywhere
    step_x.push_back(0.01 * std::exp(0.3 * l));
    step_y.push_back(-0.02 * (l - 9));
  }
  for (const double spin : {0.0, 0.07, -3.0}) {
    std::vector<double> sum_x(kLanes), sum_y(kLanes);
    const loco::FastsimMarch march{kCells,        place.data(), bound.data(), kLanes,      step_x.data(),
                                   step_y.data(), spin,         sum_x.data(), sum_y.data()};
    loco::marchStrips(march);
    for (int l = 0; l < kLanes; ++l) {
      double x = 0.0, y = 0.0;
      marchOneStrip(march, l, x, y);
      EXPECT_EQ(sum_x[static_cast<std::size_t>(l)], x);
      EXPECT_EQ(sum_y[static_cast<std::size_t>(l)], y);
    }
  }
}

}  // namespace
