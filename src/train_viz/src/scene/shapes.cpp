#include "train_viz/shapes.hpp"

namespace viz {

void Triangles::add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                    const Eigen::Vector3d& d, const Colour& colour) {
  points.insert(points.end(), {a, b, c, a, c, d});
  colours.insert(colours.end(), {colour, colour});
}

Eigen::Isometry3d frameOf(const rail::TrackPose& pose) {
  Eigen::Isometry3d X_WT = Eigen::Isometry3d::Identity();
  X_WT.translation() = Eigen::Vector3d(pose.x_m, pose.y_m, pose.z_m);
  X_WT.linear() = (Eigen::AngleAxisd(pose.heading_rad, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(pose.pitch_rad, Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(pose.roll_rad, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  return X_WT;
}

Carrier trainCarrier(const rail::WorldTrack& world, double location_m) {
  Carrier carrier{"train", Eigen::Isometry3d::Identity()};
  carrier.X_WC.translation() = frameOf(world.at(location_m)).translation();
  return carrier;
}

Carrier locomotiveCarrier(const rail::WorldTrack& world, int number, double location_m) {
  return {"loco_" + std::to_string(number) + "/base_link", frameOf(world.at(location_m))};
}

}  // namespace viz
