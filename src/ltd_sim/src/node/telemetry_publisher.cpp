#include "telemetry_publisher.hpp"

#include <rosgraph_msgs/Clock.h>
#include <train_msgs/RunConfiguration.h>

#include "conversions.hpp"
#include "loco_dynamics/loco_factory.hpp"

namespace ltd {

TelemetryPublisher::TelemetryPublisher(const Scenario& scenario, std::uint64_t run_id)
    : scenario_(scenario), run_id_(run_id), frames_(scenario) {
  configuration_ = node_.advertise<train_msgs::RunConfiguration>("train/configuration", 1, true);
  state_ = node_.advertise<train_msgs::TrainState>("train/state", 100, true);
  energy_ = node_.advertise<train_msgs::TrainEnergy>("train/energy", 100, true);
  for (std::size_t i = 0; i < scenario.train.locomotives.size(); ++i) {
    adhesion_.emplace_back();
    if (loco::hasContacts(scenario.train.locomotives[i].model))
      adhesion_[i] = node_.advertise<train_msgs::Adhesion>("loco_" + std::to_string(i + 1) + "/adhesion", 100, true);
  }
  // Latched, although /tf seldom is: all frames of this node are in one message, so who comes late gets them all.
  tf_ = node_.advertise<tf2_msgs::TFMessage>("/tf", 10, true);
  clock_ = node_.advertise<rosgraph_msgs::Clock>("/clock", 100);
}

void TelemetryPublisher::onStart(const TrainState& state) {
  configuration_.publish(toMsg(scenario_, run_id_));
  toMsg(scenario_, state, forcesAtStart(scenario_, state), state_msg_);
  state_.publish(state_msg_);
  publishClock(0);
  tf_.publish(frames_.computeStart(state));
}

void TelemetryPublisher::onStep(const StepRecord& record) {
  const rail::Nanoseconds t = static_cast<rail::Nanoseconds>(record.after.step) * scenario_.macro_step;
  if (t % scenario_.output.telemetry_interval != 0) return;
  toMsg(scenario_, record.after, energy_msg_);
  energy_.publish(energy_msg_);
  publishState(record);
  constexpr std::chrono::milliseconds kFrameInterval(33);
  if (std::chrono::steady_clock::now() - frames_sent_ >= kFrameInterval) publishFrames(record);
}

/// No energies: the stored ones are up to date on the telemetry's grid only.
void TelemetryPublisher::onHold(const StepRecord& record) {
  if (record.after.step != shown_step_) publishState(record);
  if (record.after.step != frames_step_) publishFrames(record);
}

void TelemetryPublisher::publishState(const StepRecord& record) {
  const rail::Nanoseconds t = static_cast<rail::Nanoseconds>(record.after.step) * scenario_.macro_step;
  shown_step_ = record.after.step;
  toMsg(scenario_, record.after, record.forces, state_msg_);
  state_.publish(state_msg_);
  for (std::size_t i = 0; i < adhesion_.size(); ++i) {
    if (!adhesion_[i]) continue;
    toMsg(t, *record.answers[i], adhesion_msg_);
    adhesion_[i].publish(adhesion_msg_);
  }
  publishClock(t);
}

void TelemetryPublisher::publishFrames(const StepRecord& record) {
  frames_sent_ = std::chrono::steady_clock::now();
  frames_step_ = record.after.step;
  tf_.publish(frames_.compute(record));
}

void TelemetryPublisher::publishClock(rail::Nanoseconds t) {
  rosgraph_msgs::Clock msg;
  msg.clock = toStamp(t);
  clock_.publish(msg);
}

}  // namespace ltd
