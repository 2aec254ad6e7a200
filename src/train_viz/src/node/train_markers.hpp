#pragma once

#include <ros/ros.h>
#include <std_msgs/Int32.h>
#include <tf2_msgs/TFMessage.h>
#include <train_msgs/Adhesion.h>
#include <train_msgs/RunConfiguration.h>
#include <train_msgs/TrainState.h>

#include <memory>
#include <string>

#include "rail_core/world_track.hpp"
#include "train_viz/train_outline.hpp"

namespace viz {

/// Shows a run in rviz: listens to /train/configuration, /train/state and /loco_i/adhesion, publishes markers, no more
/// often than `rate_hz` of wall time, and nothing while nothing new has come. What moves is drawn in frames that the
/// run itself publishes on /tf, so it stays together at any rate. The frame `chosen_locomotive` is another name for
/// that locomotive's own. It keeps the choice of the locomotive for all who look: who wants another one asks on
/// ~choose_locomotive, which one it is comes on ~locomotive. docs/watch.md says what is on which topic.
class TrainMarkers {
 public:
  static constexpr int kMostLocomotives = 5000;
  struct Options {
    int locomotive = 1;     ///< whose contacts are shown to begin with, from 1 at the head
    double rate_hz = 20.0;  ///< of wall time
  };
  explicit TrainMarkers(const Options& options);

 private:
  void onConfiguration(const train_msgs::RunConfiguration& msg);
  void onChoice(const std_msgs::Int32& msg);
  void onTimer(const ros::WallTimerEvent&);
  void showTrain(const train_msgs::TrainState& msg);
  void showContacts(const train_msgs::Adhesion& msg);
  void advertise();
  void listenToLocomotive();
  void nameChosen();

  /// The run that is shown; the world refers to the outline's track, so both stay where they are.
  struct Run {
    explicit Run(const std::string& resolved) : outline(TrainOutline::read(resolved)), world(outline.track) {}
    const TrainOutline outline;
    const rail::WorldTrack world;
  };

  Options options_;
  std::unique_ptr<const Run> run_;
  train_msgs::TrainState::ConstPtr state_;   ///< newest
  bool state_is_new_ = false;                ///< not shown yet
  train_msgs::Adhesion::ConstPtr adhesion_;  ///< newest, not shown yet
  ros::NodeHandle node_, private_node_{"~"};
  ros::Publisher track_, train_, couplers_, contacts_, static_frames_, locomotive_;
  ros::Subscriber configuration_subscriber_, state_subscriber_, adhesion_subscriber_, choice_subscriber_;
  ros::WallTimer timer_;
};

}  // namespace viz
