#include "loco_dynamics/loco_3d.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "loco_3d_fixtures.hpp"

namespace {

using fixtures::Ride3d;
using loco::BodyLayout;
using loco::Loco3d;

TEST(Loco3dTest, AtRestOnLevelTrackItStaysAtRest) {
  Ride3d ride(fixtures::paperParameters3d(), 0.0);
  ride.run(1.0);
  EXPECT_NEAR(ride.answer.speed_mps, 0.0, 1e-9);
  EXPECT_NEAR(ride.answer.traction_N, 0.0, 1e-3);
}

TEST(Loco3dTest, Explore) {
  Ride3d ride(fixtures::paperParameters3d(), 4.42);
  const loco::BodyState s = ride.bodies();
  for (std::size_t i = 0; i < 9; ++i)
    std::printf("%zu: %s\n", i, (std::ostringstream() << s.q[i].transpose() << " | " << s.v[i].transpose()).str().c_str());
  ride.force.traction_reference_N = 490e3;
  ride.force.coupler_rear_N = -350e3;
  for (int i = 0; i < 10; ++i) {
    ride.run(1.0);
    std::printf("F %.3f kN v %.12f %.3e motors %.4g frames %.4g residual %.3g\n", ride.answer.traction_N / 1e3,
                ride.answer.speed_mps, ride.answer.speed_mps - ride.ltd_speed, ride.sum.motors, ride.sum.frames,
                ride.sum.residual());
  }
}

TEST(Loco3dTest, ExploreCurve) {
  Loco3d::Parameters p = fixtures::paperParameters3d();
  p.track = fixtures::makeTrack();
  Ride3d ride(p, 8.85, 3450.0);
  const loco::BodyState s = ride.bodies();
  for (std::size_t i = 0; i < 9; ++i)
    std::printf("%zu: %s\n", i, (std::ostringstream() << s.q[i].transpose() << " | " << s.v[i].transpose()).str().c_str());
  const auto loads = ride.locomotive.computeStaticLoads(s);
  for (std::size_t i = 0; i < 9; ++i)
    std::printf("%zu: %s\n", i, (std::ostringstream() << loads[i].transpose()).str().c_str());
}

}  // namespace
