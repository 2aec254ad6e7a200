#pragma once

#include <random>
#include <vector>

#include "adhesion_control/adhesion_controller.hpp"

/// The paper's Co-Co with micro steps of 1 ms.
inline adhesion::Setup coCo() { return {1000000, 0.5335, {0, 0, 0, 1, 1, 1}}; }

/// A controller with its state and the vectors that step() needs.
struct Driven {
  Driven(const adhesion::AdhesionController& c, const adhesion::Setup& s)
      : controller(c), setup(s), state(c.initialState()), axles(s.axles()), commands(s.axles()) {}

  void setReference(double torque_N_m) {
    for (auto& axle : axles) axle.torque_reference_N_m = torque_N_m;
  }
  /// Sets the spin of one axle so that its slip is `slip` at speed v_mps >= 0.5.
  void setSlip(std::size_t axle, double slip) { axles[axle].omega_radps = (1.0 + slip) * v_mps / setup.wheel_radius_m; }
  void setSlip(double slip) {
    for (std::size_t i = 0; i < axles.size(); ++i) setSlip(i, slip);
  }
  void step() { controller.step(v_mps, axles, state.data(), commands); }

  const adhesion::AdhesionController& controller;
  adhesion::Setup setup;
  double v_mps = 10.0;
  std::vector<double> state;
  std::vector<adhesion::AxleMeasurement> axles;
  std::vector<adhesion::AxleCommand> commands;
};

/// Random measurements around the slip limit, in traction and in braking.
class RandomMeasurements {
 public:
  void next(Driven& driven) {
    for (std::size_t i = 0; i < driven.axles.size(); ++i) {
      driven.setSlip(i, slip_(random_));
      driven.axles[i].torque_reference_N_m = (count_ / 200 % 2 == 0 ? 1.0 : -1.0) * reference_(random_);
    }
    ++count_;
  }

 private:
  std::mt19937_64 random_{3};
  std::uniform_real_distribution<double> slip_{-0.2, 0.2}, reference_{20e3, 45e3};
  int count_ = 0;
};
