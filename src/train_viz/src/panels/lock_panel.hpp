#pragma once

#include <ros/ros.h>
#include <rviz/panel.h>
#include <train_msgs/TrainStatus.h>

#include <memory>
#include <string>

#include "lock_caller.hpp"
#include "lock_view.hpp"

class QTimer;

namespace viz {

/// rviz panel train_viz/LockPanel: shows the train's status and calls its lock. The layout names topic and service.
class LockPanel : public rviz::Panel {
  Q_OBJECT

 public:
  explicit LockPanel(QWidget* parent = nullptr);

  void onInitialize() override;
  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 private:
  void subscribe();
  void onStatus(const train_msgs::TrainStatus& msg);
  void request(const QString& command, double value);
  void onTimer();

  std::string status_topic_ = "/train/status";
  std::string service_ = "/train/step_lock";
  LockView* view_;
  QTimer* timer_;
  std::unique_ptr<LockCaller> caller_;
  ros::NodeHandle node_;
  ros::Subscriber status_;
};

}  // namespace viz
