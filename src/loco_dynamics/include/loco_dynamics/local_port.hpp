#pragma once

#include <memory>

#include "loco_dynamics/loco_port.hpp"
#include "loco_dynamics/locomotive.hpp"

namespace loco {

/// A locomotive in the same process: computes at once.
class LocalPort : public LocoPort {
 public:
  explicit LocalPort(std::unique_ptr<Locomotive> locomotive) : locomotive_(std::move(locomotive)) {}

  void send(const LocoForce& force, const std::vector<double>& state) override {
    if (!state.empty()) {
      locomotive_->step(state, force, answer_);
      return;
    }
    const LocoStart start = locomotive_->equilibriumState(force.location_m, force.speed_mps);
    if (start.failure.empty()) {
      locomotive_->step(start.state, force, answer_);
    } else {
      answer_ = failedAnswer(force, start.failure);
    }
  }
  const LocoTraction* answer() override { return &answer_; }

 private:
  std::unique_ptr<Locomotive> locomotive_;
  LocoTraction answer_;
};

}  // namespace loco
