#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "ltd_sim/step_lock.hpp"

namespace fixtures {

/// A lock for two locomotives whose messages are kept in a list.
class StepLockTest : public ::testing::Test {
 protected:
  StepLockTest()
      : lock_(
            settings(), [this](std::size_t i, const loco::ForceMessage& m) { sent_.emplace_back(i, m); },
            [this](std::size_t) { return connected_; }) {
    lock_.tick(0.0);
    lock_.setStart(0, 3000.0, 1.5);
    lock_.setStart(1, 2978.0, 1.5);
  }

  static ltd::StepLock::Settings settings() {
    ltd::StepLock::Settings s;
    s.id = {42, 1, 0, 0};
    s.build_id = "build";
    s.arithmetic_fingerprint = 7;
    s.configuration = "name: test";
    s.loco_keys = {"train.groups.0.vehicle", "train.groups.1.vehicle"};
    s.state_sizes = {2, 2};
    s.step_length = 2000000;
    s.join_deadline_s = 60.0;
    s.answer_deadline_s = 30.0;
    return s;
  }

  static loco::JoinRequest request(std::uint32_t locomotive, const std::string& node) {
    return {loco::kProtocolVersion, "build", 7, locomotive, node};
  }

  void joinBoth() {
    ASSERT_TRUE(lock_.onJoin(request(1, "/a"), 0.0).accepted);
    ASSERT_TRUE(lock_.onJoin(request(2, "/b"), 0.0).accepted);
  }

  /// Asks both for a step from the given states.
  void sendStep(std::uint64_t step) {
    for (std::size_t i = 0; i < 2; ++i) {
      loco::LocoForce force;
      force.step = step;
      force.location_m = 3000.0;
      states_[i] = {static_cast<double>(step), 1.0};
      lock_.port(i).send(force, states_[i]);
    }
  }

  loco::TractionMessage answer(std::uint32_t locomotive, std::uint64_t step, double traction_N) {
    loco::TractionMessage message;
    message.id = {42, 1, lock_.incarnation(locomotive - 1), locomotive};
    message.traction.step = step;
    message.traction.traction_N = traction_N;
    message.traction.state = {static_cast<double>(step) + 1.0, 2.0};
    return message;
  }

  std::vector<std::pair<std::size_t, loco::ForceMessage>> sent_;
  std::vector<double> states_[2];
  bool connected_ = true;
  ltd::StepLock lock_;
};

}  // namespace fixtures
