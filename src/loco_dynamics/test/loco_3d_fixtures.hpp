#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "loco_dynamics/contact/contact_config.hpp"
#include "loco_dynamics/loco_3d.hpp"
#include "simple_contacts.hpp"

namespace fixtures {

inline constexpr double kWeight_N = 134000.0 * 9.81;
inline constexpr rail::Nanoseconds kMicro = 500000;

template <typename Read>
auto readFile(const std::string& file, Read read, const std::vector<rail::Override>& overrides = {}) {
  rail::Problems problems;
  const rail::Document document = rail::Document::load(std::string(CONFIG_DIR) + file, overrides, problems);
  const auto result = read(rail::YamlReader(document, problems));
  problems.throwIfAny();
  return result;
}

/// Straight from 0, a transition from 3.3 km, R300 to 3.55 km and back to straight.
inline std::shared_ptr<const rail::Track> makeTrack(const std::string& direction = "left", double cant_mm = 0.0,
                                                    double transition_m = 50.0, double radius_m = 300.0) {
  const std::string text =
      "name: curve\nstart_km: 0\nend_km: 10\ngrades: [{from_km: 0, grade_permille: 0}]\n"
      "curves: [{start_km: 3.3, radius_m: " +
      std::to_string(radius_m) + ", direction: " + direction + ", transition_in_m: " + std::to_string(transition_m) +
      ", circular_m: 200, transition_out_m: " + std::to_string(transition_m) + ", cant_mm: " + std::to_string(cant_mm) +
      "}]\nspeed_limits: [{from_km: 0, limit_kmph: 80}]\n";
  rail::Problems problems;
  const rail::Document document = rail::Document::parse(text, "track.yaml", problems);
  auto track = std::make_shared<const rail::Track>(rail::Track::read(rail::YamlReader(document, problems)));
  problems.throwIfAny();
  return track;
}

template <typename Search>
std::shared_ptr<const loco::ContactFinder> finderOf(Search search) {
  return std::make_shared<const loco::ContactFinderOf<Search>>(search);
}

/// The paper's locomotive on coned wheels, on straight track.
inline loco::Loco3d::Parameters paperParameters3d(const std::string& control = "pi_per_axle") {
  loco::Loco3d::Parameters p;
  p.structure = readFile("/bodies/co_co_134t.yaml", loco::LocoStructure::read);
  p.finder = finderOf(ConedWheel{});
  p.contact = {0.5335, 100e3, {210e9, 0.28}, 82e9};
  p.rail.elsewhere = readFile("/adhesion/paper_table1.yaml", loco::readCreepLaw);
  p.control = readFile("/control/" + control + ".yaml",
                       [](rail::YamlReader reader) { return adhesion::readController(reader, kMicro); });
  p.adhesion_limit = 0.35;
  p.micro_step = kMicro;
  return p;
}

/// A locomotive and the train that it feels as a force at its rear coupler, stepped together as LTD does it.
struct Ride3d {
  Ride3d(const loco::Loco3d::Parameters& parameters, double v_mps, double location_m = 3000.0)
      : locomotive(parameters), state(locomotive.equilibriumState(location_m, v_mps).state), ltd_speed(v_mps) {
    force.step_length = 2000000;
    force.speed_mps = v_mps;
    force.rim_power_limit_W = 4.1e6;
  }
  void step() {
    locomotive.step(state, force, answer);
    ASSERT_TRUE(answer.failure.empty()) << answer.failure;
    state = answer.state;
    ltd_speed += 0.002 *
                 (answer.traction_N + force.coupler_front_N + force.coupler_rear_N + force.grade_N +
                  force.propulsion_resistance_N) /
                 134000.0;
    force.speed_mps = ltd_speed;
    const loco::Loco3d::Account& a = locomotive.account();
    sum.motors += a.motors;
    sum.outer += a.outer;
    sum.frames += a.frames;
    sum.dampers += a.dampers;
    sum.slip += a.slip;
    sum.shoes += a.shoes;
    sum.contact_damping += a.contact_damping;
    sum.kinetic += a.kinetic;
    sum.stored += a.stored;
    ++force.step;
  }
  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds / 0.002) && !::testing::Test::HasFatalFailure(); ++i) step();
  }
  loco::BodyState bodies() const {
    loco::BodyState out;
    locomotive.dynamics().unpack(state.data(), out);
    return out;
  }
  loco::Loco3d locomotive;
  std::vector<double> state;
  loco::LocoForce force;
  loco::LocoTraction answer;
  loco::Loco3d::Account sum;
  double ltd_speed;
};

}  // namespace fixtures
