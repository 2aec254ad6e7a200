#include "ltd_node.hpp"

#include <algorithm>
#include <chrono>
#include <random>

#include "bag_writer.hpp"
#include "conversions.hpp"
#include "loco_dynamics/loco_factory.hpp"
#include "rail_core/build_id.hpp"
#include "rail_core/constants.hpp"
#include "rail_core/digest.hpp"
#include "rail_core/message_number.hpp"
#include "telemetry_publisher.hpp"

namespace ltd {

namespace {

constexpr std::uint32_t kFirstEpoch = 1;
constexpr double kHeartbeat_s = 1.0;
constexpr double kPatience_s = 1.0;      // before somebody who keeps the run waiting is named
constexpr double kLongestWait_s = 0.05;  // between two looks at the deadlines

double wallNow() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

std::uint64_t drawRunId() {
  std::random_device device;
  return (static_cast<std::uint64_t>(device()) << 32) | device();
}

}  // namespace

LtdNode::LtdNode(const Scenario& scenario, const Options& options)
    : scenario_(scenario),
      keep_(options.keep),
      id_{drawRunId(), kFirstEpoch, 0, 0},
      control_(options.hold),
      lock_(
          lockSettings(), [this](std::size_t i, const loco::ForceMessage& m) { links_.send(i, m); },
          [this](std::size_t i) { return links_.connected(i); }),
      outputs_(scenario, options.out),
      progress_(scenario, 2.0, [](const Progress& p) { ROS_INFO("%s", toString(p).c_str()); }),
      status_(scenario),
      links_(scenario.train.locomotives.size()) {
  std::vector<RunObserver*> observers = {&progress_};
  owned_observers_.push_back(std::make_unique<TelemetryPublisher>(scenario, id_.run_id));
  if (options.record) owned_observers_.push_back(std::make_unique<BagWriter>(scenario, options.out, id_.run_id));
  for (const auto& observer : owned_observers_) observers.push_back(observer.get());
  observers.push_back(&outputs_);  // outcome.yaml comes last: when it is there, everything is
  std::vector<loco::LocoPort*> ports;
  for (std::size_t i = 0; i < lock_.size(); ++i) ports.push_back(&lock_.port(i));
  if (const auto& external = scenario.driver.external())
    driver_ = std::make_unique<DriverLink>(id_.run_id, external->answer_deadline_s,
                                           std::max(external->answer_deadline_s, scenario.lock.join_deadline_s));
  cosimulation_ = std::make_unique<Cosimulation>(scenario, ports, observers, driver_.get());
  for (std::size_t i = 0; i < lock_.size(); ++i) {
    const std::size_t vehicle = scenario.train.locomotives[i].vehicle;
    lock_.setStart(i, cosimulation_->state().s_m[vehicle], cosimulation_->state().v_mps[vehicle]);
  }
  join_server_ = node_.advertiseService("train/join", &LtdNode::onJoin, this);
  step_lock_server_ = node_.advertiseService("train/step_lock", &LtdNode::onStepLock, this);
}

StepLock::Settings LtdNode::lockSettings() const {
  StepLock::Settings settings;
  settings.id = id_;
  settings.build_id = rail::buildId();
  settings.arithmetic_fingerprint = rail::arithmeticFingerprint();
  settings.configuration = scenario_.document.text();
  rail::Problems problems;
  for (const LocoUnit& unit : scenario_.train.locomotives) {
    const auto locomotive = loco::makeLocomotive(scenario_.document, unit.key, problems);
    problems.throwIfAny();
    settings.loco_keys.push_back(unit.key);
    settings.state_sizes.push_back(locomotive->stateSize());
  }
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
  if (answer.accepted && begun_)
    ROS_INFO("loco_%u has joined again for step %lu", request.locomotive, static_cast<unsigned long>(answer.step));
  if (!answer.accepted) sayOnce(request.node + " may not join: " + answer.reason);
  next_heartbeat_s_ = 0.0;
  news_.notify_one();
  return true;
}

bool LtdNode::onStepLock(train_msgs::StepLock::Request& request, train_msgs::StepLock::Response& response) {
  const std::lock_guard<std::mutex> guard(mutex_);
  RunControl::Reply reply{false, "the run has ended: " + cosimulation_->outcome().reason};
  if (!cosimulation_->outcome().ended())
    reply = control_.request(request.command, request.value, situation(), wallNow());
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
  if (advance()) news_.notify_one();
}

void LtdNode::onDriver(const train_msgs::DriverCommand& msg) {
  const std::lock_guard<std::mutex> guard(mutex_);
  const std::string why = driver_->take(msg);
  if (!why.empty()) sayOnce("a message on /train/driver does not count: " + why);
  if (advance()) news_.notify_one();
  const std::string refusal = driver_->refusal();
  if (!refusal.empty()) sayOnce(refusal);
}

/// Who keeps the run waiting, in words; empty: nobody.
std::string LtdNode::waitsFor() const {
  if (cosimulation_->waitsForDriver()) return driver_->waitsFor(kPatience_s);
  return lock_.waitsFor(wallNow(), kPatience_s);
}

RunControl::Situation LtdNode::situation() const {
  return {cosimulation_->state().step, cosimulation_->time(), cosimulation_->leadingLocation(), scenario_.run.end_time,
          scenario_.run.end_location_m};
}

int LtdNode::run(const volatile std::sig_atomic_t& interrupted) {
  ros::AsyncSpinner services(1);
  services.start();
  {
    std::unique_lock<std::mutex> guard(mutex_);
    cosimulation_->start();
  }
  links_.open([this](const train_msgs::LocoTraction& msg) { onTraction(msg); });
  if (driver_) driver_->open([this](const train_msgs::DriverCommand& msg) { onDriver(msg); });
  {
    std::unique_lock<std::mutex> guard(mutex_);
    while (!cosimulation_->outcome().ended()) {
      watch(interrupted);
      advance();
      if (cosimulation_->outcome().ended()) break;
      const double pace_s = control_.paceWait(situation(), wallNow());
      const double wait_s = pace_s > 0.0 ? std::min(pace_s, kLongestWait_s) : kLongestWait_s;
      news_.wait_for(guard, std::chrono::duration<double>(wait_s));
    }
    publishStatus();
  }
  links_.close();
  if (driver_) driver_->close();
  const Outcome& outcome = cosimulation_->outcome();
  if (outcome.exitStatus() == 0) {
    ROS_INFO("%s: %s", toString(outcome.kind).c_str(), outcome.reason.c_str());
  } else if (outcome.kind == Outcome::Kind::kStopped) {
    ROS_WARN("stopped: %s", outcome.reason.c_str());
  } else {
    ROS_ERROR("%s: %s", toString(outcome.kind).c_str(), outcome.reason.c_str());
  }
  if (keep_) stay(interrupted);
  services.stop();
  ros::WallDuration(0.2).sleep();  // roscpp has no flush: the last status goes out
  return outcome.exitStatus();
}

/// Everything that is latched stays to be seen, and the status goes on, so that no locomotive misses the train.
void LtdNode::stay(const volatile std::sig_atomic_t& interrupted) {
  if (interrupted == 0) ROS_INFO("the run has ended; it stays to be looked at until Ctrl-C");
  while (interrupted == 0 && ros::ok()) {
    {
      const std::lock_guard<std::mutex> guard(mutex_);
      const double now_s = wallNow();
      if (now_s >= next_heartbeat_s_) {
        publishStatus();
        next_heartbeat_s_ = now_s + kHeartbeat_s;
      }
    }
    ros::WallDuration(kLongestWait_s).sleep();
  }
}

void LtdNode::publishStatus() {
  const std::uint8_t now = phase();
  const bool rests = now == train_msgs::TrainStatus::HELD || cosimulation_->outcome().ended();
  if (rests && !cosimulation_->stepUnderWay())
    cosimulation_->hold();  // before the status: who reads it finds the state
  if (now == train_msgs::TrainStatus::HELD && now != last_phase_)
    ROS_INFO("held at %s km, %.3f s, step %lu; go on with: rosservice call /train/step_lock RUN 0",
             rail::fixedNumber(cosimulation_->leadingLocation() / rail::kMetresPerKilometre, 3).c_str(),
             rail::toSeconds(cosimulation_->time()), static_cast<unsigned long>(cosimulation_->state().step));
  last_phase_ = now;
  status_.publish(last_phase_, id_, waitsFor(), *cosimulation_, lock_, progress_.last());
}

/// Commits and begins steps as far as answers and commands allow. @return true if run() has something to do now.
bool LtdNode::advance() {
  while (!cosimulation_->outcome().ended()) {
    if (!lock_.fault().empty()) return true;
    if (cosimulation_->stepUnderWay()) {
      if (!cosimulation_->tryCommit()) return false;
      continue;
    }
    if (!(begun_ || lock_.allJoined()) || !control_.mayBegin(situation(), wallNow())) return true;
    if (!begun_) {
      begun_ = true;
      ROS_INFO("all %zu locomotives have joined, %s starts", lock_.size(), scenario_.name.c_str());
    }
    cosimulation_->begin();
  }
  return true;
}

void LtdNode::watch(const volatile std::sig_atomic_t& interrupted) {
  const double now_s = wallNow();
  lock_.tick(now_s);
  if (cosimulation_->waitsForDriver()) driver_->tick();
  const std::string waits_for = waitsFor();
  if (!waits_for.empty()) sayOnce(waits_for.substr(0, waits_for.find(" for ")));
  if (interrupted != 0) {
    cosimulation_->end(Outcome::Kind::kStopped, "interrupted");
  } else if (!ros::ok()) {
    cosimulation_->end(Outcome::Kind::kStopped, "shut down through the ROS master");
  } else if (!lock_.fault().empty()) {
    cosimulation_->end(Outcome::Kind::kFailed, lock_.fault());
  } else if (control_.stopRequested() && (!cosimulation_->stepUnderWay() || !waits_for.empty())) {
    cosimulation_->end(Outcome::Kind::kStopped, "stopped through /train/step_lock");
  }
  if (phase() != last_phase_ || now_s >= next_heartbeat_s_) {
    publishStatus();
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
    case Outcome::Kind::kRefused:  // such a run has no node
    case Outcome::Kind::kFailed:
      return Status::FAILED;
    case Outcome::Kind::kRunning:
      break;
  }
  if (!begun_ && !lock_.allJoined()) return Status::JOINING;
  return control_.held() && !cosimulation_->stepUnderWay() ? Status::HELD : Status::RUNNING;
}

void LtdNode::sayOnce(const std::string& what) {
  if (!said_.insert(what).second) return;
  ROS_WARN("%s", what.c_str());
}

}  // namespace ltd
