#include "ltd_node.hpp"

#include <algorithm>
#include <chrono>
#include <random>
#include <stdexcept>

#include "bag_writer.hpp"
#include "conversions.hpp"
#include "rail_core/build_id.hpp"
#include "rail_core/constants.hpp"
#include "rail_core/digest.hpp"
#include "telemetry_publisher.hpp"

namespace ltd {

namespace {

constexpr double kHeartbeat_s = 1.0;
constexpr double kPatience_s = 1.0;      // before somebody who keeps the run waiting is named
constexpr double kLongestWait_s = 0.05;  // between two looks at the deadlines

double wallNow() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

std::uint64_t drawRunId() {
  std::random_device device;
  return (static_cast<std::uint64_t>(device()) << 32) | device();
}

std::vector<std::string> locoKeys(const TrainModel& train) {
  std::vector<std::string> keys;
  for (const LocoUnit& unit : train.locomotives) keys.push_back(unit.key);
  return keys;
}

}  // namespace

LtdNode::LtdNode(const Scenario& scenario, const Options& options)
    : scenario_(scenario),
      run_id_(drawRunId()),
      control_(options.hold),
      links_(scenario.train.locomotives.size(), [this](const train_msgs::LocoTraction& msg) { onTraction(msg); }),
      lock_(
          lockSettings(options), [this](std::size_t i, const loco::ForceMessage& m) { links_.send(i, m); },
          [this](std::size_t i) { return links_.connected(i); }),
      outputs_(scenario, options.out),
      progress_(scenario, 2.0, [](const Progress& p) { ROS_INFO("%s", toString(p).c_str()); }) {
  std::vector<RunObserver*> observers = {&progress_};
  owned_observers_.push_back(std::make_unique<TelemetryPublisher>(scenario, run_id_));
  if (options.record) owned_observers_.push_back(std::make_unique<BagWriter>(scenario, options.out, run_id_));
  for (const auto& observer : owned_observers_) observers.push_back(observer.get());
  observers.push_back(&outputs_);  // outcome.yaml comes last: when it is there, everything is
  std::vector<loco::LocoPort*> ports;
  for (std::size_t i = 0; i < lock_.size(); ++i) ports.push_back(&lock_.port(i));
  cosimulation_ = std::make_unique<Cosimulation>(scenario, ports, observers);
  for (std::size_t i = 0; i < lock_.size(); ++i) {
    const std::size_t vehicle = scenario.train.locomotives[i].vehicle;
    lock_.setStart(i, cosimulation_->state().s_m[vehicle], cosimulation_->state().v_mps[vehicle]);
  }
  status_publisher_ = node_.advertise<train_msgs::TrainStatus>("train/status", 10, true);
  diagnostics_publisher_ = node_.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 10);
  join_server_ = node_.advertiseService("train/join", &LtdNode::onJoin, this);
  step_lock_server_ = node_.advertiseService("train/step_lock", &LtdNode::onStepLock, this);
}

StepLock::Settings LtdNode::lockSettings(const Options&) const {
  StepLock::Settings settings;
  settings.id.run_id = run_id_;
  settings.id.epoch = 1;
  settings.build_id = rail::buildId();
  settings.arithmetic_fingerprint = rail::arithmeticFingerprint();
  settings.configuration = scenario_.document.text();
  settings.loco_keys = locoKeys(scenario_.train);
  settings.step_length = scenario_.macro_step;
  settings.join_deadline_s = scenario_.lock.join_deadline_s;
  settings.answer_deadline_s = scenario_.lock.answer_deadline_s;
  settings.heartbeat_deadline_s = scenario_.lock.answer_deadline_s;
  return settings;
}

bool LtdNode::onJoin(train_msgs::JoinTrain::Request& request, train_msgs::JoinTrain::Response& response) {
  const std::lock_guard<std::mutex> guard(mutex_);
  const loco::JoinAnswer answer = lock_.onJoin(fromMsg(request), wallNow());
  toMsg(answer, response);
  if (!answer.accepted) ROS_WARN("%s may not join: %s", request.node.c_str(), answer.reason.c_str());
  next_heartbeat_s_ = 0.0;
  news_.notify_one();
  return true;
}

bool LtdNode::onStepLock(train_msgs::StepLock::Request& request, train_msgs::StepLock::Response& response) {
  const std::lock_guard<std::mutex> guard(mutex_);
  const RunControl::Reply reply = control_.request(request.command, request.value, situation(), wallNow());
  response.accepted = static_cast<std::uint8_t>(reply.accepted);
  response.message = reply.message;
  response.step = cosimulation_->state().step;
  ROS_INFO("step_lock %s %g: %s", request.command.c_str(), request.value, reply.message.c_str());
  next_heartbeat_s_ = 0.0;
  news_.notify_one();
  return true;
}

void LtdNode::onTraction(const train_msgs::LocoTraction& msg) {
  const std::lock_guard<std::mutex> guard(mutex_);
  lock_.onTraction(fromMsg(msg));
  try {
    if (cosimulation_ && broken_.empty() && advance()) news_.notify_one();
  } catch (const std::exception& error) {  // an observer cannot write: run() ends with it, this thread is roscpp's
    broken_ = error.what();
    news_.notify_one();
  }
}

RunControl::Situation LtdNode::situation() const {
  return {cosimulation_->state().step, cosimulation_->time(), cosimulation_->leadingLocation()};
}

int LtdNode::run(const volatile std::sig_atomic_t& interrupted) {
  ros::AsyncSpinner services(1);
  services.start();
  std::unique_lock<std::mutex> guard(mutex_);
  cosimulation_->start();
  while (!cosimulation_->outcome().ended()) {
    if (!broken_.empty()) throw std::runtime_error(broken_);
    watch(interrupted);
    advance();
    if (cosimulation_->outcome().ended()) break;
    const double pace_s = control_.paceWait(situation(), wallNow());
    news_.wait_for(guard,
                   std::chrono::duration<double>(pace_s > 0.0 ? std::min(pace_s, kLongestWait_s) : kLongestWait_s));
  }
  publishStatus();
  const Outcome& outcome = cosimulation_->outcome();
  if (outcome.exitStatus() == 0) {
    ROS_INFO("%s: %s", toString(outcome.kind).c_str(), outcome.reason.c_str());
  } else {
    ROS_ERROR("%s: %s", toString(outcome.kind).c_str(), outcome.reason.c_str());
  }
  guard.unlock();
  links_.shutdown();
  ros::WallDuration(0.2).sleep();  // roscpp has no flush: the last status goes out
  return outcome.exitStatus();
}

/// Commits and begins steps as far as answers and commands allow. @return true if run() has something to do now.
bool LtdNode::advance() {
  while (!cosimulation_->outcome().ended()) {
    if (cosimulation_->stepUnderWay()) {
      if (!cosimulation_->tryCommit()) return false;
      continue;
    }
    const bool ready = first_step_wall_s_ >= 0.0 || lock_.allJoined();
    const double now_s = wallNow();
    if (!ready || !control_.mayBegin(situation(), now_s)) return true;
    if (first_step_wall_s_ < 0.0) {
      first_step_wall_s_ = now_s;
      ROS_INFO("all %zu locomotives have joined, %s starts", lock_.size(), scenario_.name.c_str());
    }
    cosimulation_->begin();
  }
  return true;
}

void LtdNode::watch(const volatile std::sig_atomic_t& interrupted) {
  const double now_s = wallNow();
  lock_.tick(now_s);
  const std::string waits_for = lock_.waitsFor(now_s, kPatience_s);
  if (!waits_for.empty()) sayOnce(waits_for.substr(0, waits_for.find(" for ")));
  if (interrupted != 0) {
    cosimulation_->end(Outcome::Kind::kStopped, "interrupted");
  } else if (!ros::ok()) {
    cosimulation_->end(Outcome::Kind::kStopped, "shut down through the ROS master");
  } else if (!lock_.fault().empty()) {
    cosimulation_->end(Outcome::Kind::kFailed, lock_.fault());
  } else if (control_.stopRequested() && !cosimulation_->stepUnderWay()) {
    cosimulation_->end(Outcome::Kind::kStopped, "stopped through /train/step_lock");
  }
  if (phase() != last_phase_ || now_s >= next_heartbeat_s_) {
    publishStatus();
    publishDiagnostics();
    next_heartbeat_s_ = now_s + kHeartbeat_s;
  }
}

std::uint8_t LtdNode::phase() const {
  using Status = train_msgs::TrainStatus;
  switch (cosimulation_->outcome().kind) {
    case Outcome::Kind::kFinished:
      return Status::FINISHED;
    case Outcome::Kind::kStopped:
      return Status::STOPPED;
    case Outcome::Kind::kFailed:
      return Status::FAILED;
    case Outcome::Kind::kRunning:
      break;
  }
  if (first_step_wall_s_ < 0.0 && !lock_.allJoined()) return Status::JOINING;
  return control_.held() && !cosimulation_->stepUnderWay() ? Status::HELD : Status::RUNNING;
}

void LtdNode::publishStatus() {
  last_phase_ = phase();
  train_msgs::TrainStatus msg;
  msg.header.stamp = toStamp(cosimulation_->time());
  msg.run_id = run_id_;
  msg.epoch = 1;
  msg.phase = last_phase_;
  msg.reason =
      cosimulation_->outcome().ended() ? cosimulation_->outcome().reason : lock_.waitsFor(wallNow(), kPatience_s);
  msg.step = cosimulation_->state().step;
  msg.time = rail::toSeconds(cosimulation_->time());
  msg.location = cosimulation_->leadingLocation();
  msg.real_time_factor = progress_.last().real_time_factor;
  msg.time_left = last_phase_ == train_msgs::TrainStatus::RUNNING ? progress_.last().time_left_s : -1.0;
  for (std::size_t i = 0; i < lock_.size(); ++i) {
    msg.joined.push_back(static_cast<std::uint8_t>(lock_.joined(i)));
    msg.incarnation.push_back(lock_.incarnation(i));
  }
  msg.resent = lock_.counters().resent;
  msg.repeated = lock_.counters().repeated;
  msg.refused = lock_.counters().refused;
  msg.last_refused = lock_.counters().last_refused;
  status_publisher_.publish(msg);
}

void LtdNode::publishDiagnostics() {
  const auto value = [](const std::string& key, const std::string& text) {
    diagnostic_msgs::KeyValue pair;
    pair.key = key;
    pair.value = text;
    return pair;
  };
  diagnostic_msgs::DiagnosticStatus lock;
  const std::string waits_for = lock_.waitsFor(wallNow(), kPatience_s);
  lock.name = "train: step lock";
  lock.hardware_id = scenario_.name;
  lock.level = waits_for.empty() ? diagnostic_msgs::DiagnosticStatus::OK : diagnostic_msgs::DiagnosticStatus::WARN;
  lock.message = waits_for.empty() ? "all locomotives answer" : waits_for;
  lock.values = {value("step", std::to_string(cosimulation_->state().step)),
                 value("resent", std::to_string(lock_.counters().resent)),
                 value("repeated", std::to_string(lock_.counters().repeated)),
                 value("refused", std::to_string(lock_.counters().refused)),
                 value("last refused", lock_.counters().last_refused)};
  diagnostic_msgs::DiagnosticStatus dynamics;
  const double use = cosimulation_->forces().step_use;
  dynamics.name = "train: longitudinal dynamics";
  dynamics.hardware_id = scenario_.name;
  dynamics.level = use <= 1.0 ? diagnostic_msgs::DiagnosticStatus::OK : diagnostic_msgs::DiagnosticStatus::WARN;
  dynamics.message = use <= 1.0 ? "the step bears the coupler forces" : "macro step too long for the coupler forces";
  dynamics.values = {
      value("share of the largest step", std::to_string(use)),
      value("vehicle", std::to_string(cosimulation_->forces().step_use_vehicle + 1)),
      value("largest speed difference to a locomotive [m/s]", std::to_string(cosimulation_->largestDrift()))};
  diagnostic_msgs::DiagnosticArray msg;
  msg.header.stamp = ros::Time(ros::WallTime::now().sec, ros::WallTime::now().nsec);
  msg.status = {lock, dynamics};
  diagnostics_publisher_.publish(msg);
}

void LtdNode::sayOnce(const std::string& what) {
  if (what == said_) return;
  said_ = what;
  ROS_WARN("%s", what.c_str());
}

}  // namespace ltd
