#include "train_markers.hpp"

#include <exception>

#include "markers.hpp"

namespace viz {

namespace {

// Chosen: read beside one locomotive, and from above the whole train.
constexpr double kNearLetters_m = 1.0;
constexpr double kNearText_m = 8.5;  // above the rail
constexpr double kFarLetters_m = 45.0;
const Eigen::Vector3d kFarText_m(-450.0, 250.0, 150.0);  // in the map's axes, which the view from above has

/// @param carriers  of the train; the second one is the leading locomotive's
std::vector<Caption> captionsAbove(const std::vector<Carrier>& carriers, const std::string& text) {
  return {{carriers[1].X_WC * Eigen::Vector3d(0.0, 0.0, kNearText_m), kNearLetters_m, text, 1},
          {carriers[0].X_WC * kFarText_m, kFarLetters_m, text, 0}};
}

}  // namespace

TrainMarkers::TrainMarkers(const Options& options) : options_(options) {
  advertise();
  const ros::TransportHints hints = ros::TransportHints().tcpNoDelay();
  configuration_subscriber_ = node_.subscribe("/train/configuration", 1, &TrainMarkers::onConfiguration, this, hints);
  state_subscriber_ = node_.subscribe<train_msgs::TrainState>(
      "/train/state", 1,
      [this](const train_msgs::TrainState::ConstPtr& msg) {
        state_ = msg;
        state_is_new_ = true;
      },
      {}, hints);
  choice_subscriber_ = private_node_.subscribe("choose_locomotive", 10, &TrainMarkers::onChoice, this);
  listenToLocomotive();
  timer_ = node_.createWallTimer(ros::WallDuration(1.0 / options.rate_hz), &TrainMarkers::onTimer, this);
}

void TrainMarkers::advertise() {
  const auto advertiseMarkers = [this](const char* topic) {  // 2: what clears must not be overtaken by what comes after
    return private_node_.advertise<visualization_msgs::MarkerArray>(topic, 2, true);
  };
  track_ = advertiseMarkers("track");
  train_ = advertiseMarkers("train");
  couplers_ = advertiseMarkers("couplers");
  contacts_ = advertiseMarkers("contacts");
  locomotive_ = private_node_.advertise<std_msgs::Int32>("locomotive", 1, true);
  static_frames_ = node_.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true);
}

void TrainMarkers::listenToLocomotive() {
  adhesion_.reset();
  adhesion_subscriber_ = node_.subscribe<train_msgs::Adhesion>(
      "/loco_" + std::to_string(options_.locomotive) + "/adhesion", 1,
      [this](const train_msgs::Adhesion::ConstPtr& msg) { adhesion_ = msg; }, {}, ros::TransportHints().tcpNoDelay());
  std_msgs::Int32 chosen;
  chosen.data = options_.locomotive;
  locomotive_.publish(chosen);
}

void TrainMarkers::onChoice(const std_msgs::Int32& msg) {
  if (msg.data < 1 || msg.data > kMostLocomotives) {
    ROS_ERROR("train_markers: ~choose_locomotive: %d: must be a whole number from 1, from the head", msg.data);
    listenToLocomotive();  // tells who asked that nothing has changed
    return;
  }
  if (msg.data == options_.locomotive) return;
  options_.locomotive = msg.data;
  for (const ros::Publisher& publisher : {train_, contacts_}) publisher.publish(clearingMsg());
  listenToLocomotive();
  nameChosen();
  state_is_new_ = true;
}

/// Hangs the camera's frame on the chosen locomotive, or says that the train has no such locomotive.
void TrainMarkers::nameChosen() {
  if (!run_) return;
  if (options_.locomotive <= static_cast<int>(run_->outline.locomotives.size())) {
    static_frames_.publish(
        makeAlias("loco_" + std::to_string(options_.locomotive) + "/base_link", "chosen_locomotive"));
    return;
  }
  ROS_WARN("train_markers: locomotive %d: %s has %zu locomotives; its train is shown without contacts",
           options_.locomotive, run_->outline.name.c_str(), run_->outline.locomotives.size());
}

void TrainMarkers::onConfiguration(const train_msgs::RunConfiguration& msg) {
  run_.reset();
  adhesion_.reset();
  for (const ros::Publisher& publisher : {train_, couplers_, contacts_}) publisher.publish(clearingMsg());
  try {
    run_ = std::make_unique<const Run>(msg.resolved);
  } catch (const std::exception& error) {
    ROS_ERROR("train_markers: cannot show %s: %s", msg.scenario.c_str(), error.what());
    return;
  }
  // A held train says once where it is, and that may come before the longer configuration; what is of another train
  // goes.
  if (state_ && state_->vehicle_location.size() != run_->outline.vehicles.size()) state_.reset();
  state_is_new_ = state_ != nullptr;
  nameChosen();
  track_.publish(toMsg(computeTrackShape(run_->outline.track, run_->world)));
  ROS_INFO("train_markers: shows %s: %zu vehicles on %s", msg.scenario.c_str(), run_->outline.vehicles.size(),
           run_->outline.track.name().c_str());
}

void TrainMarkers::onTimer(const ros::WallTimerEvent&) {
  if (!run_) return;
  try {
    if (state_ && state_is_new_) showTrain(*state_);
    if (adhesion_) showContacts(*adhesion_);
  } catch (const std::exception& error) {
    ROS_ERROR_THROTTLE(1.0, "train_markers: %s", error.what());
  }
  state_is_new_ = false;
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
  train_.publish(toTrainMsg(shape, captionsAbove(shape.carriers, text)));
  couplers_.publish(toCouplersMsg(shape));
}

void TrainMarkers::showContacts(const train_msgs::Adhesion& msg) {
  const auto i = static_cast<std::size_t>(options_.locomotive - 1);
  if (i >= run_->outline.locomotives.size()) return;
  const VehicleOutline& locomotive = run_->outline.vehicles[run_->outline.locomotives[i]];
  contacts_.publish(
      toMsg(computeContactShape(run_->world, options_.locomotive, msg.location, fromMsg(msg, locomotive))));
}

}  // namespace viz
