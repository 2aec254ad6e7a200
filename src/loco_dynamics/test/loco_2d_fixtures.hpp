#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "loco_dynamics/contact/contact_config.hpp"
#include "loco_dynamics/loco_2d.hpp"

/// The paper's locomotive from config/, and a train that it feels as a force at its rear coupler.
namespace fixtures {

using loco::Loco2d;

constexpr double kMass_kg = 134000.0, kWeight_N = kMass_kg * 9.81;
constexpr rail::Nanoseconds kMacro = 2000000, kMicro = 1000000;

template <typename Read>
auto readFile(const std::string& file, Read read, const std::vector<rail::Override>& overrides = {}) {
  rail::Problems problems;
  const rail::Document document = rail::Document::load(std::string(CONFIG_DIR) + file, overrides, problems);
  const auto result = read(rail::YamlReader(document, problems));
  problems.throwIfAny();
  return result;
}

inline loco::LocoStructure paperStructure(const std::vector<rail::Override>& overrides = {}) {
  return readFile("/bodies/co_co_134t.yaml", loco::LocoStructure::read, overrides);
}

/// The paper's locomotive on the paper's rail. @param control  file in config/control
inline Loco2d::Parameters paperParameters(const std::string& control = "pi_per_axle") {
  Loco2d::Parameters p;
  p.structure = paperStructure();
  p.contact = readFile("/locomotives/co_co_134t.yaml", [](rail::YamlReader reader) {
    return loco::PlanarContact::read(reader.map("contact"), 0.5335);
  });
  p.rail = {readFile("/adhesion/paper_table1.yaml", loco::readCreepLaw), {}};
  p.control = readFile("/control/" + control + ".yaml",
                       [](rail::YamlReader reader) { return adhesion::readController(reader, kMicro); });
  p.adhesion_limit = 0.35;
  p.micro_step = kMicro;
  return p;
}

/// A locomotive stepped together with LTD's idea of it.
struct Ride {
  Ride(const Loco2d::Parameters& parameters, double v_mps, rail::Nanoseconds macro_step = kMacro)
      : locomotive(parameters), state(locomotive.equilibriumState(3000.0, v_mps).state), ltd_speed(v_mps) {
    force.step_length = macro_step;
    force.speed_mps = v_mps;
    force.rim_power_limit_W = 4.1e6;
  }
  void step() {
    locomotive.step(state, force, answer);
    ASSERT_TRUE(answer.failure.empty()) << answer.failure;
    state = answer.state;
    ltd_speed += rail::toSeconds(force.step_length) *
                 (answer.traction_N + force.coupler_front_N + force.coupler_rear_N + force.grade_N +
                  force.propulsion_resistance_N + force.curving_resistance_N) /
                 kMass_kg;
    force.speed_mps = ltd_speed;
    ++force.step;
  }
  void run(double seconds) {
    const auto steps = std::lround(seconds / rail::toSeconds(force.step_length));
    for (long i = 0; i < steps && !::testing::Test::HasFatalFailure(); ++i) step();
  }
  /// The coupler takes up what the wheels gave in the step before, so that the speed stays.
  void runAtSteadySpeed(double seconds) {
    const auto steps = std::lround(seconds / rail::toSeconds(force.step_length));
    for (long i = 0; i < steps && !::testing::Test::HasFatalFailure(); ++i) {
      step();
      force.coupler_rear_N = -answer.traction_N;
    }
  }
  /// Steps until it stands still enough, or fails; @return why it failed, or empty.
  std::string runUntilFailure(int steps) {
    for (int i = 0; i < steps; ++i) {
      locomotive.step(state, force, answer);
      if (!answer.failure.empty()) return answer.failure;
      state = answer.state;
    }
    return {};
  }

  Loco2d locomotive;
  std::vector<double> state;
  loco::LocoForce force;
  loco::LocoTraction answer;
  double ltd_speed;
};

}  // namespace fixtures
