// Chains of vehicles against their analytic oscillations, waves and step bound.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "train_fixtures.hpp"

namespace {

using fixtures::freeTrain;
using fixtures::Rig;

constexpr double kPi = 3.14159265358979323846;

// Semi-implicit Euler turns x'' = -w^2 x into x_k+1 - 2 x_k + x_k-1 = -(w H)^2 x_k. From rest at x_0 that is
//   x_k = x_0 cos((k + 1/2) q)/cos(q/2),   cos q = 1 - (w H)^2/2,
// so the analytic frequency can be checked to round-off whatever the step.
double oscillation(double omega, double H, int k) {
  const double q = std::acos(1.0 - 0.5 * omega * H * omega * H);
  return std::cos((k + 0.5) * q) / std::cos(0.5 * q);
}

TEST(TrainWavesTest, ChainOfSpringsSwingsInItsAnalyticModes) {
  constexpr int kMasses = 6, kSteps = 5000;
  constexpr double kMass = 80e3, kStiffness = 10e6, kAmplitude = 0.01, kStep = 0.002;
  for (int j = 1; j < kMasses; ++j) {
    Rig rig(freeTrain(kMasses, kMass, fixtures::linearSpring(kStiffness)), fixtures::makeTrack(), kStep, 100.0, 0.0);
    const std::vector<double> middle = rig.state.s_m;
    std::vector<double> shape;
    for (int i = 0; i < kMasses; ++i) shape.push_back(std::cos(j * kPi * (i + 0.5) / kMasses));
    for (std::size_t i = 0; i < shape.size(); ++i) rig.state.s_m[i] += kAmplitude * shape[i];
    const double omega = 2.0 * std::sqrt(kStiffness / kMass) * std::sin(j * kPi / (2 * kMasses));
    for (int k = 1; k <= kSteps; ++k) {
      ASSERT_EQ(rig.step(), "");
      for (std::size_t i = 0; i < shape.size(); ++i) {
        // s is near 100 m: 1.4e-14 m of round-off in each of 5000 steps, amplified by the phase; 1e-9 of the amplitude.
        ASSERT_NEAR(rig.state.s_m[i] - middle[i], kAmplitude * shape[i] * oscillation(omega, kStep, k), 1e-11)
            << "mode " << j << " vehicle " << i << " step " << k;
      }
    }
  }
}

TEST(TrainWavesTest, TwoUnequalMassesSwingWithTheirReducedMass) {
  constexpr double kMass1 = 134e3, kMass2 = 22e3, kStiffness = 10e6, kStep = 0.002;
  ltd::TrainModel train = freeTrain(2, kMass1, fixtures::linearSpring(kStiffness));
  train.vehicles[1].mass_kg = train.inertial_mass_kg[1] = kMass2;
  Rig rig(train, fixtures::makeTrack(), kStep, 100.0, 0.0);
  rig.state.s_m[0] += 0.01;
  const double omega = std::sqrt(kStiffness * (1.0 / kMass1 + 1.0 / kMass2));
  for (int k = 1; k <= 2000; ++k) {
    ASSERT_EQ(rig.step(), "");
    const double elongation = rig.state.s_m[0] - rig.state.s_m[1] - 10.0;
    ASSERT_NEAR(elongation, 0.01 * oscillation(omega, kStep, k), 1e-11) << k;
  }
}

TEST(TrainWavesTest, AWaveRunsThroughTheSlackAtTheTimesThatGeometryAndElasticImpactsSay) {
  // A head that nothing can slow down runs at V; every gap is g, every spring k is stiff and without loss. The head
  // reaches vehicle 1 at g/V. Hit by it, vehicle 1 moves as s = V (t - sin(w t)/w), w^2 = k/m, and leaves at 2V: as if
  // it had done so from pi/(2w) on. It hits vehicle 2 and hands its whole speed on: s = V (t - sin(w' t)/w'),
  // w'^2 = 2k/m, and so on down the train. So the first motion of vehicle i is at
  //   t_1 = g/V,   t_2 = t_1 + pi/(2w) + g/(2V),   t_i+1 = t_i + pi/(2w') + g/(2V).
  constexpr double kV = 0.1, kGap = 0.010, kMass = 120e3, kStiffness = 4e10, kStep = 1e-5;
  constexpr std::size_t kVehicles = 7;
  ltd::TrainModel train = freeTrain(kVehicles, kMass, fixtures::linearSpring(kStiffness, 2.0 * kGap));
  train.inertial_mass_kg[0] = 1e15;
  Rig rig(train, fixtures::makeTrack(), kStep, 100.0, 0.0);
  rig.state.v_mps[0] = kV;

  std::vector<double> started_s(kVehicles, -1.0);
  for (int k = 0; k < 60000; ++k) {
    ASSERT_EQ(rig.step(), "");
    for (std::size_t i = 1; i < kVehicles; ++i) {
      if (started_s[i] < 0.0 && rig.state.v_mps[i] != 0.0) started_s[i] = k * kStep;
    }
  }
  const double w = std::sqrt(kStiffness / kMass);
  double expected_s = kGap / kV;
  for (std::size_t i = 1; i < kVehicles; ++i) {
    // A step late at each of i impacts, and impacts resolved to (w H)^2 = 3e-5: far below the 53 ms between vehicles.
    EXPECT_NEAR(started_s[i], expected_s, static_cast<double>(i) * 2.0 * kStep) << "vehicle " << i;
    expected_s += kPi / (2.0 * (i == 1 ? w : std::sqrt(2.0) * w)) + kGap / (2.0 * kV);
  }
}

TEST(TrainWavesTest, CouplerChattersAboveItsStepBoundAndSettlesBelow) {
  // Two wagons of 22 t pulled apart by 1.2 MN each come to rest relative to each other, with F = (L + U)/2. One coupler
  // between them: friction alone bounds H c 2/m < 2, c = (L - U)/(2 vs), so H = m vs/(0.275 L), L = 1.2 MN/0.725.
  const auto relativeSpeedAfter4s = [](double step_s) {
    ltd::TrainModel train = freeTrain(2, 22e3, fixtures::draftGear());
    train.locomotives.push_back({1, 0, 0, 0.35, "1d", "train"});
    Rig rig(train, fixtures::makeTrack(), step_s, 3000.0, 1.0);
    double largest_mps = 0.0;
    const int steps = static_cast<int>(4.0 / step_s);
    for (int k = 0; k < steps; ++k) {
      EXPECT_EQ(rig.step({1.2e6, -1.2e6}), "");
      if (k > steps - 100) largest_mps = std::max(largest_mps, std::abs(rig.state.v_mps[0] - rig.state.v_mps[1]));
    }
    return largest_mps;
  };
  EXPECT_NEAR(22e3 * 0.02 / (0.275 * 1.2e6 / 0.725), 0.967e-3, 1e-6);
  EXPECT_LT(relativeSpeedAfter4s(0.8e-3), 1e-3);  // settling goes on for longer than 4 s: vs/20
  EXPECT_GT(relativeSpeedAfter4s(1.2e-3), 0.01);  // swings by the order of vs
}

}  // namespace
