#include "loco_dynamics/contact/elastic_pressure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using loco::ContactSection;
using loco::Elasticity;

/// Hertz's bodies, overlapping as deep as their approach, as wide as they overlap then.
ContactSection parabola(double along_1pm, double across_1pm, double approach_m) {
  constexpr int kColumns = 36;
  const double half_width_m = std::sqrt(2.0 * approach_m / across_1pm);
  ContactSection section{2.0 * half_width_m / kColumns, {}, along_1pm};
  for (int i = 0; i < kColumns; ++i) {
    const double y_m = (i + 0.5) * section.step_m - half_width_m;
    section.overlap_m.push_back(approach_m - 0.5 * across_1pm * y_m * y_m);
  }
  return section;
}

double largest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

TEST(ElasticPressureTest, HertzsBodiesHaveHertzsPressure) {
  constexpr double kNormal_N = 100e3;
  for (const double across_1pm : {0.5, 2.0, 8.0, 30.0}) {
    const loco::HertzContact hertz({2.0, across_1pm}, Elasticity{});
    const loco::HertzContact::Ellipse ellipse = hertz.computeEllipse(kNormal_N);
    const double expected_Pa = 1.5 * kNormal_N / (3.14159265358979 * ellipse.a_m * ellipse.b_m);
    const auto pressure_Pa =
        loco::computeElasticPressure(parabola(2.0, across_1pm, hertz.computeApproach(kNormal_N)), kNormal_N, {});
    EXPECT_NEAR(largest(pressure_Pa), expected_Pa, 0.015 * expected_Pa) << across_1pm;  // cells 1/12 of the patch
    EXPECT_NEAR(pressure_Pa.front(), 0.0, 1.0);  // the bodies overlap wider than they touch
    for (std::size_t i = 0; i < pressure_Pa.size(); ++i) {
      EXPECT_NEAR(pressure_Pa[i], pressure_Pa[pressure_Pa.size() - 1 - i], 1e-3 * expected_Pa);
    }
  }
}

TEST(ElasticPressureTest, LevelOfTheOverlapDoesNotCount) {
  ContactSection section = parabola(2.0, 3.0, 1e-4);
  const double pressure_Pa = largest(loco::computeElasticPressure(section, 50e3, {}));
  for (double& overlap_m : section.overlap_m) overlap_m += 0.2e-4;
  EXPECT_NEAR(largest(loco::computeElasticPressure(section, 50e3, {})), pressure_Pa,
              0.02 * pressure_Pa);  // other cells
}

TEST(ElasticPressureTest, AJointOfArcsIsPressedMost) {
  ContactSection section = parabola(2.0, 3.0, 1e-4);
  const double smooth_Pa = largest(loco::computeElasticPressure(section, 50e3, {}));
  for (std::size_t i = 0; i < section.overlap_m.size(); ++i) {  // one side ten times as curved
    const double y_m = (static_cast<double>(i) - 17.5) * section.step_m;
    if (y_m > 0.0) section.overlap_m[i] -= 0.5 * 27.0 * y_m * y_m;
  }
  EXPECT_GT(largest(loco::computeElasticPressure(section, 50e3, {})), 1.2 * smooth_Pa);
}

}  // namespace
