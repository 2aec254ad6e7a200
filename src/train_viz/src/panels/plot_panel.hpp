#pragma once

#include <ros/ros.h>
#include <rviz/panel.h>
#include <std_msgs/Int32.h>
#include <std_msgs/String.h>
#include <train_msgs/Adhesion.h>
#include <train_msgs/RunConfiguration.h>
#include <train_msgs/TrainEnergy.h>
#include <train_msgs/TrainState.h>

#include "plot_board.hpp"

namespace viz {

/// rviz panel train_viz/PlotPanel: subscribes to what the layout names and hands it to a PlotBoard. rviz serves the
/// callbacks in the thread that draws, so none of them waits for anything.
class PlotPanel : public rviz::Panel {
  Q_OBJECT

 public:
  explicit PlotPanel(QWidget* parent = nullptr);

  void onInitialize() override;
  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 private:
  void subscribe();
  void advertiseChoice();
  void tellChoice();
  void onState(const train_msgs::TrainState& msg);
  void onEnergy(const train_msgs::TrainEnergy& msg);
  void onAdhesion(const train_msgs::Adhesion& msg);
  void onConfiguration(const train_msgs::RunConfiguration& msg);
  void onLocomotive(const std_msgs::Int32& msg);
  void onExport(const std_msgs::String& msg);

  PlotBoard* board_;
  ros::NodeHandle node_;
  ros::Subscriber state_, energy_, adhesion_, configuration_, locomotive_, export_;
  ros::Publisher choice_;
  int known_choice_ = 0;  ///< the locomotive that was told or heard last
};

}  // namespace viz
