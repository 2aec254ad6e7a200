#include "train_markers.hpp"

#include <exception>

#include "markers.hpp"

namespace viz {

namespace {

// Chosen: read beside one locomotive, and from above the whole train.
constexpr double kNearLetters_m = 1.0;
constexpr double kNearText_m = 8.5;  // above the rail
constexpr double kFarLetters_m = 32.0;
constexpr double kFarText_m = 150.0;
constexpr double kFarOffset_m = 160.0;  // to the right of the line

std::vector<Caption> captionsAbove(const Eigen::Isometry3d& X_WT, const std::string& text) {
  return {{X_WT * Eigen::Vector3d(0.0, 0.0, kNearText_m), kNearLetters_m, text},
          {X_WT * Eigen::Vector3d(0.0, -kFarOffset_m, kFarText_m), kFarLetters_m, text}};
}

}  // namespace

TrainMarkers::TrainMarkers(const Options& options) : options_(options) {
  advertise();
  const ros::TransportHints hints = ros::TransportHints().tcpNoDelay();
  configuration_subscriber_ = node_.subscribe("/train/configuration", 1, &TrainMarkers::onConfiguration, this, hints);
  state_subscriber_ = node_.subscribe<train_msgs::TrainState>(
      "/train/state", 1, [this](const train_msgs::TrainState::ConstPtr& msg) { state_ = msg; }, {}, hints);
  adhesion_subscriber_ = node_.subscribe<train_msgs::Adhesion>(
      "/loco_" + std::to_string(options.locomotive) + "/adhesion", 1,
      [this](const train_msgs::Adhesion::ConstPtr& msg) { adhesion_ = msg; }, {}, hints);
  timer_ = node_.createWallTimer(ros::WallDuration(1.0 / options.rate_hz), &TrainMarkers::onTimer, this);
}

void TrainMarkers::advertise() {
  track_ = private_node_.advertise<visualization_msgs::MarkerArray>("track", 1, true);
  train_ = private_node_.advertise<visualization_msgs::MarkerArray>("train", 1, true);
  couplers_ = private_node_.advertise<visualization_msgs::MarkerArray>("couplers", 1, true);
  contacts_ = private_node_.advertise<visualization_msgs::MarkerArray>("contacts", 1, true);
  // /tf cannot be latched, it has many publishers: who comes while the train is held gets the last frames from here
  tf_ = node_.advertise<tf2_msgs::TFMessage>("/tf", 10, [this](const ros::SingleSubscriberPublisher& subscriber) {
    if (!frames_.transforms.empty()) subscriber.publish(frames_);
  });
}

void TrainMarkers::onConfiguration(const train_msgs::RunConfiguration& msg) {
  run_.reset();
  state_.reset();
  adhesion_.reset();
  for (const ros::Publisher& publisher : {train_, couplers_, contacts_}) publisher.publish(clearingMsg());
  try {
    run_ = std::make_unique<const Run>(msg.resolved);
  } catch (const std::exception& error) {
    ROS_ERROR("train_markers: cannot show %s: %s", msg.scenario.c_str(), error.what());
    return;
  }
  if (options_.locomotive > static_cast<int>(run_->outline.locomotives.size()))
    ROS_WARN("train_markers: ~locomotive = %d: %s has %zu locomotives; its train is shown without contacts",
             options_.locomotive, msg.scenario.c_str(), run_->outline.locomotives.size());
  track_.publish(toMsg(computeTrackShape(run_->outline.track, run_->world)));
  ROS_INFO("train_markers: shows %s: %zu vehicles on %s", msg.scenario.c_str(), run_->outline.vehicles.size(),
           run_->outline.track.name().c_str());
}

void TrainMarkers::onTimer(const ros::WallTimerEvent&) {
  if (!run_) return;
  try {
    if (state_) showTrain(*state_);
    if (adhesion_) showContacts(*adhesion_);
  } catch (const std::exception& error) {
    ROS_ERROR_THROTTLE(1.0, "train_markers: %s", error.what());
  }
  state_.reset();
  adhesion_.reset();
}

void TrainMarkers::showTrain(const train_msgs::TrainState& msg) {
  const std::size_t vehicles = run_->outline.vehicles.size();
  if (msg.vehicle_location.size() != vehicles || msg.coupler_force.size() + 1 != vehicles)
    throw std::runtime_error("/train/state is not of the train in /train/configuration: it has " +
                             std::to_string(msg.vehicle_location.size()) + " vehicles, not " +
                             std::to_string(vehicles));
  const TrainShape shape =
      computeTrainShape(run_->outline, run_->world, options_.locomotive, msg.vehicle_location, msg.coupler_force);
  const std::string text = computeCaption(fromMsg(msg), options_.locomotive);
  train_.publish(toTrainMsg(shape, captionsAbove(frameOf(run_->world.at(msg.location)), text)));
  couplers_.publish(toCouplersMsg(shape));
  const tf2_msgs::TFMessage frames = computeFrames(msg);
  const bool repeated =
      !frames_.transforms.empty() && frames_.transforms.front().header.stamp == frames.transforms.front().header.stamp;
  frames_ = frames;
  if (!repeated) tf_.publish(frames_);  // tf2 warns of a stamp that it has
}

void TrainMarkers::showContacts(const train_msgs::Adhesion& msg) {
  const auto i = static_cast<std::size_t>(options_.locomotive - 1);
  if (i >= run_->outline.locomotives.size()) return;
  const VehicleOutline& locomotive = run_->outline.vehicles[run_->outline.locomotives[i]];
  contacts_.publish(toMsg(computeContactShape(run_->world, msg.location, fromMsg(msg, locomotive))));
}

/// For cameras: the track's frame at the leading and at the chosen locomotive.
tf2_msgs::TFMessage TrainMarkers::computeFrames(const train_msgs::TrainState& msg) const {
  tf2_msgs::TFMessage frames;
  frames.transforms.push_back(toMsg(msg.header.stamp, "train", frameOf(run_->world.at(msg.location))));
  const auto i = static_cast<std::size_t>(options_.locomotive - 1);
  if (i < run_->outline.locomotives.size()) {
    const double location_m = msg.vehicle_location[run_->outline.locomotives[i]];
    frames.transforms.push_back(toMsg(msg.header.stamp, "chosen_locomotive", frameOf(run_->world.at(location_m))));
  }
  return frames;
}

}  // namespace viz
