#include "body_frames.hpp"

#include <Eigen/Geometry>
#include <string>

#include "conversions.hpp"
#include "loco_dynamics/loco_factory.hpp"

namespace ltd {

namespace {

Eigen::Quaterniond rotation(double roll_rad, double pitch_rad, double yaw_rad) {
  return Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(pitch_rad, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitX());
}

/// X_WT: the track frame in the world.
Eigen::Isometry3d trackFrame(const rail::WorldTrack& track, double location_m) {
  const rail::TrackPose pose = track.at(location_m);
  Eigen::Isometry3d X_WT = Eigen::Isometry3d::Identity();
  X_WT.translation() = Eigen::Vector3d(pose.x_m, pose.y_m, pose.z_m);
  X_WT.linear() = rotation(pose.roll_rad, pose.pitch_rad, pose.heading_rad).toRotationMatrix();
  return X_WT;
}

/// X_TB: a body in the track frame at its place. A wheelset spins about its own axle: pitch comes last.
Eigen::Isometry3d bodyFrame(const loco::BodyPose& pose) {
  Eigen::Isometry3d X_TB = Eigen::Isometry3d::Identity();
  X_TB.translation() = Eigen::Vector3d(0.0, pose.y_m, pose.z_m);
  X_TB.linear() =
      (rotation(pose.roll_rad, 0.0, pose.yaw_rad) * Eigen::AngleAxisd(pose.pitch_rad, Eigen::Vector3d::UnitY()))
          .toRotationMatrix();
  return X_TB;
}

geometry_msgs::TransformStamped toMsg(ros::Time stamp, const std::string& parent, const std::string& child,
                                      const Eigen::Isometry3d& X) {
  geometry_msgs::TransformStamped msg;
  msg.header.stamp = stamp;
  msg.header.frame_id = parent;
  msg.child_frame_id = child;
  msg.transform.translation.x = X.translation().x();
  msg.transform.translation.y = X.translation().y();
  msg.transform.translation.z = X.translation().z();
  const Eigen::Quaterniond q(X.linear());
  msg.transform.rotation.w = q.w();
  msg.transform.rotation.x = q.x();
  msg.transform.rotation.y = q.y();
  msg.transform.rotation.z = q.z();
  return msg;
}

}  // namespace

BodyFrames::BodyFrames(const Scenario& scenario) : track_(scenario.track), macro_step_(scenario.macro_step) {
  rail::Problems problems;
  for (const LocoUnit& unit : scenario.train.locomotives) {
    vehicles_.push_back(unit.vehicle);
    locomotives_.push_back(loco::makeLocomotive(scenario.document, unit.key, problems));
  }
  problems.throwIfAny();
}

const tf2_msgs::TFMessage& BodyFrames::compute(const StepRecord& record) {
  const rail::Nanoseconds t = static_cast<rail::Nanoseconds>(record.after.step) * macro_step_;
  msg_.transforms.clear();
  for (std::size_t i = 0; i < locomotives_.size(); ++i)
    add(i, t, record.answers[i]->location_m, record.answers[i]->state);
  addTrain(t, record.answers.front()->location_m);
  return msg_;
}

const tf2_msgs::TFMessage& BodyFrames::computeStart(const TrainState& state) {
  msg_.transforms.clear();
  for (std::size_t i = 0; i < locomotives_.size(); ++i) {
    const double location_m = state.s_m[vehicles_[i]];
    const loco::LocoStart start = locomotives_[i]->equilibriumState(location_m, state.v_mps[vehicles_[i]]);
    if (start.failure.empty()) add(i, 0, location_m, start.state);  // the run's first step will say why, if not
  }
  addTrain(0, state.s_m[vehicles_.front()]);
  return msg_;
}

void BodyFrames::add(std::size_t i, rail::Nanoseconds t, double location_m, const std::vector<double>& state) {
  const ros::Time stamp = toStamp(t);
  const std::string name = "loco_" + std::to_string(i + 1) + "/";
  const Eigen::Isometry3d X_WL = trackFrame(track_, location_m);
  msg_.transforms.push_back(toMsg(stamp, "map", name + "base_link", X_WL));
  for (const loco::BodyPose& pose : locomotives_[i]->computePoses(state)) {
    const Eigen::Isometry3d X_WB = trackFrame(track_, pose.location_m) * bodyFrame(pose);
    msg_.transforms.push_back(toMsg(stamp, name + "base_link", name + pose.name, X_WL.inverse() * X_WB));
  }
}

/// Last: who has it, has all others of the message.
void BodyFrames::addTrain(rail::Nanoseconds t, double location_m) {
  const Eigen::Isometry3d unturned(Eigen::Translation3d(trackFrame(track_, location_m).translation()));
  msg_.transforms.push_back(toMsg(toStamp(t), "map", "train", unturned));
}

}  // namespace ltd
