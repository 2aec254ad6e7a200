#include "driver_link.hpp"

#include <chrono>
#include <cstdio>
#include <utility>

#include "conversions.hpp"

namespace ltd {

namespace {

constexpr double kResend_s = 0.1;

double wallNow() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

DriverLink::DriverLink(std::uint64_t run_id, double answer_deadline_s, double first_deadline_s)
    : run_id_(run_id), answer_deadline_s_(answer_deadline_s), first_deadline_s_(first_deadline_s) {
  node_.setCallbackQueue(&queue_);
  publisher_ = node_.advertise<train_msgs::DriverView>("train/driver_view", 10, true);
}

void DriverLink::open(Receive receive) {
  receive_ = std::move(receive);
  const boost::function<void(const train_msgs::DriverCommandConstPtr&)> callback =
      [this](const train_msgs::DriverCommandConstPtr& msg) { receive_(*msg); };
  subscriber_ = node_.subscribe<train_msgs::DriverCommand>("train/driver", 10, callback, ros::VoidPtr(),
                                                           ros::TransportHints().tcpNoDelay());
}

void DriverLink::close() { subscriber_.shutdown(); }

void DriverLink::ask(std::uint64_t step, const DriverView& view) {
  accepted_once_ = accepted_once_ || answer_;  // one that was refused is gone
  answer_.reset();
  refused_.clear();
  asked_ = true;
  asked_at_s_ = sent_at_s_ = wallNow();
  toMsg(run_id_, step, view, question_);
  publisher_.publish(question_);
}

const DriverCommand* DriverLink::answer() { return answer_ ? &*answer_ : nullptr; }

void DriverLink::refuse(const std::string& why) {
  refused_ = why;
  answer_.reset();
}

std::string DriverLink::refusal() const {
  if (refused_.empty()) return {};
  return "the driver's answer to step " + std::to_string(question_.step) + " was refused: " + refused_;
}

double DriverLink::waited_s() const { return wallNow() - asked_at_s_; }

double DriverLink::deadline_s() const { return accepted_once_ ? answer_deadline_s_ : first_deadline_s_; }

bool DriverLink::silent() { return waited_s() > deadline_s(); }

std::string DriverLink::take(const train_msgs::DriverCommand& msg) {
  if (!asked_ || msg.run_id != run_id_ || msg.step != question_.step)
    return "answers step " + std::to_string(msg.step) + " of run " + std::to_string(msg.run_id) +
           (asked_ ? ", asked was step " + std::to_string(question_.step) + " of run " + std::to_string(run_id_)
                   : ", and nothing was asked");
  if (!answer_) answer_ = fromMsg(msg);
  return {};
}

void DriverLink::tick() {
  if (!asked_ || answer_ || wallNow() - sent_at_s_ < kResend_s) return;
  sent_at_s_ = wallNow();
  publisher_.publish(question_);
}

std::string DriverLink::waitsFor(double patience_s) const {
  if (!asked_ || answer_ || waited_s() < patience_s) return {};
  char text[96];
  std::snprintf(text, sizeof text, "the driver has not answered step %lu for %.0f s",
                static_cast<unsigned long>(question_.step), waited_s());
  return text + (refused_.empty() ? std::string() : "; his last answer was refused: " + refused_);
}

}  // namespace ltd
