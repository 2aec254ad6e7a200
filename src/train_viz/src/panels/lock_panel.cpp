#include "lock_panel.hpp"

#include <ros/service.h>
#include <train_msgs/StepLock.h>

#include <QScrollArea>
#include <QTimer>
#include <QVBoxLayout>

namespace viz {

namespace {

constexpr int kQueue = 10;     // statuses: the last one counts
constexpr int kPoll_ms = 100;  // chosen: people do not notice

/// Runs in the caller's thread. Neither waits for a service that is not there nor for a master that is gone.
LockReply callLock(const std::string& service, const std::string& command, double value) {
  if (!ros::service::exists(service, false)) return {false, "there is no service " + service + ": no train runs"};
  train_msgs::StepLock lock;
  lock.request.command = command;
  lock.request.value = value;
  if (!ros::service::call(service, lock)) return {false, service + " broke off"};
  return {lock.response.accepted != 0, lock.response.message};
}

TrainStatus fromMsg(const train_msgs::TrainStatus& msg) {
  TrainStatus status;
  status.phase = static_cast<TrainStatus::Phase>(msg.phase);  // in the order of the message's constants
  status.reason = msg.reason;
  status.notes = msg.notes;
  status.time_s = msg.time;
  status.place_m = msg.location;
  status.real_time_factor = msg.real_time_factor;
  status.time_left_s = msg.time_left;
  for (const auto joined : msg.joined) status.joined.push_back(joined != 0);
  return status;
}

}  // namespace

LockPanel::LockPanel(QWidget* parent) : rviz::Panel(parent), view_(new LockView), timer_(new QTimer(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* scroll = new QScrollArea;  // a low dock must not hide the buttons for good
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidget(view_);
  column->addWidget(scroll);
  connect(view_, &LockView::requested, this, &LockPanel::request);
  connect(timer_, &QTimer::timeout, this, &LockPanel::onTimer);
  timer_->start(kPoll_ms);
}

void LockPanel::onInitialize() {
  QTimer::singleShot(0, this, [this] { subscribe(); });  // after load(), if there is a layout to load
}

void LockPanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  QString text;
  if (config.mapGetString("Status Topic", &text)) status_topic_ = text.toStdString();
  if (config.mapGetString("Lock Service", &text)) service_ = text.toStdString();
  subscribe();
}

void LockPanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  config.mapSetValue("Status Topic", QString::fromStdString(status_topic_));
  config.mapSetValue("Lock Service", QString::fromStdString(service_));
}

void LockPanel::subscribe() {
  try {
    if (!status_ || status_.getTopic() != node_.resolveName(status_topic_))
      status_ = node_.subscribe(status_topic_, kQueue, &LockPanel::onStatus, this);
    const std::string service = node_.resolveName(service_);
    caller_ = std::make_unique<LockCaller>(
        [service](const std::string& command, double value) { return callLock(service, command, value); });
  } catch (const ros::InvalidNameException& error) {
    view_->tell(error.what(), false);
  }
}

void LockPanel::onStatus(const train_msgs::TrainStatus& msg) { view_->show(fromMsg(msg)); }

void LockPanel::request(const QString& command, double value) {
  if (!caller_ || !caller_->start(command.toStdString(), value)) return;
  view_->tell(command + " ...", true);
  view_->setBusy(true);
}

void LockPanel::onTimer() {
  if (caller_) {
    if (const auto reply = caller_->poll()) {
      view_->setBusy(false);
      view_->tell(QString::fromStdString(reply->message), reply->accepted);
    }
  }
  view_->refresh();
}

}  // namespace viz
