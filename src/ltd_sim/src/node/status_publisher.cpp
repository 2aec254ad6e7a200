#include "status_publisher.hpp"

#include <diagnostic_msgs/DiagnosticArray.h>

#include "conversions.hpp"
#include "rail_core/constants.hpp"
#include "rail_core/message_number.hpp"

namespace ltd {

StatusPublisher::StatusPublisher(const Scenario& scenario) : scenario_(scenario) {
  status_ = node_.advertise<train_msgs::TrainStatus>("train/status", 10, true);
  diagnostics_ = node_.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 10);
}

void StatusPublisher::publish(std::uint8_t phase, const loco::ExchangeId& id, const std::string& waits_for,
                              const Cosimulation& cosimulation, const StepLock& lock, const Progress& progress) {
  train_msgs::TrainStatus msg;
  msg.header.stamp = toStamp(cosimulation.time());
  msg.run_id = id.run_id;
  msg.epoch = id.epoch;
  msg.phase = phase;
  msg.reason = cosimulation.outcome().ended() ? cosimulation.outcome().reason : waits_for;
  if (msg.reason.empty() && phase == train_msgs::TrainStatus::HELD) {
    msg.reason = "holds at " + rail::fixedNumber(cosimulation.leadingLocation() / rail::kMetresPerKilometre, 3) + " km";
  }
  msg.notes = cosimulation.outcome().ended() ? cosimulation.outcome().notes : cosimulation.notes();
  msg.step = cosimulation.state().step;
  msg.time = rail::toSeconds(cosimulation.time());
  msg.location = cosimulation.leadingLocation();
  msg.real_time_factor = progress.real_time_factor;
  msg.time_left = phase == train_msgs::TrainStatus::RUNNING ? progress.time_left_s : -1.0;
  for (std::size_t i = 0; i < lock.size(); ++i) {
    msg.joined.push_back(static_cast<std::uint8_t>(lock.joined(i)));
    msg.incarnation.push_back(lock.incarnation(i));
  }
  msg.resent = lock.counters().resent;
  msg.repeated = lock.counters().repeated;
  msg.refused = lock.counters().refused;
  msg.last_refused = lock.counters().last_refused;
  status_.publish(msg);
  publishDiagnostics(waits_for, cosimulation, lock);
}

void StatusPublisher::publishDiagnostics(const std::string& waits_for, const Cosimulation& cosimulation,
                                         const StepLock& lock) {
  const auto value = [](const std::string& key, const std::string& text) {
    diagnostic_msgs::KeyValue pair;
    pair.key = key;
    pair.value = text;
    return pair;
  };
  diagnostic_msgs::DiagnosticStatus exchange;
  exchange.name = "train: step lock";
  exchange.hardware_id = scenario_.name;
  exchange.level = waits_for.empty() ? diagnostic_msgs::DiagnosticStatus::OK : diagnostic_msgs::DiagnosticStatus::WARN;
  exchange.message = waits_for.empty() ? "all locomotives answer" : waits_for;
  exchange.values = {
      value("step", std::to_string(cosimulation.state().step)), value("resent", std::to_string(lock.counters().resent)),
      value("repeated", std::to_string(lock.counters().repeated)),
      value("refused", std::to_string(lock.counters().refused)), value("last refused", lock.counters().last_refused)};
  diagnostic_msgs::DiagnosticStatus dynamics;
  const double use = cosimulation.forces().step_use;
  dynamics.name = "train: longitudinal dynamics";
  dynamics.hardware_id = scenario_.name;
  dynamics.level = use <= 1.0 ? diagnostic_msgs::DiagnosticStatus::OK : diagnostic_msgs::DiagnosticStatus::WARN;
  dynamics.message = use <= 1.0 ? "the step bears the coupler forces" : "macro step too long for the coupler forces";
  dynamics.values = {
      value("share of the largest step", std::to_string(use)),
      value("vehicle", std::to_string(cosimulation.forces().step_use_vehicle + 1)),
      value("largest speed difference to a locomotive [m/s]", std::to_string(cosimulation.largestDrift()))};
  diagnostic_msgs::DiagnosticArray msg;
  msg.header.stamp = ros::Time(ros::WallTime::now().sec, ros::WallTime::now().nsec);
  msg.status = {exchange, dynamics};
  diagnostics_.publish(msg);
}

}  // namespace ltd
