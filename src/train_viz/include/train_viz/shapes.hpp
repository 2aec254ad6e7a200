#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "rail_core/world_track.hpp"

/// What is drawn of a train, in the frame `map` of docs/watch.md: x forward, y left, z up, lengths in m. No ROS here.
namespace viz {

/// Red, green, blue and opacity, each from 0 to 1.
struct Colour {
  double r = 0.0, g = 0.0, b = 0.0, a = 1.0;
};

/// A frame C of tf that moves with the train. What is drawn in it moves with it, and so with all that the same message
/// on /tf moves; poses in it change with the line's shape only.
struct Carrier {
  std::string frame;
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
};

/// `train`: the leading locomotive's place, in the map's axes: if it turned, the end of a long train would swing while
/// frame and picture are not of one instant.
Carrier trainCarrier(const rail::WorldTrack& world, double location_m);
/// `loco_i/base_link`: the track's frame at that locomotive. @param number  i, from 1
Carrier locomotiveCarrier(const rail::WorldTrack& world, int number, double location_m);

/// A box about its centre B.
struct Box {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();  ///< along B's x, y, z
  Colour colour;
  std::size_t carrier = 0;  ///< index in the list of them
};

/// A cylinder about the z axis of its centre C; its ends may be ellipses.
struct Cylinder {
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();  ///< two diameters and the height
  Colour colour;
};

/// Three points a triangle, counterclockwise seen from outside; a colour a triangle, and one opacity for all of them,
/// because rviz blends by a marker's own.
struct Triangles {
  std::vector<Eigen::Vector3d> points;
  std::vector<Colour> colours;
  double opacity = 1.0;
  std::size_t carrier = 0;  ///< index in the list of them

  /// A quadrangle a, b, c, d, counterclockwise seen from outside.
  void add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d,
           const Colour& colour);
};

struct Arrow {
  Eigen::Vector3d from_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d to_m = Eigen::Vector3d::Zero();
  Colour colour;
};

/// A text that faces whoever looks.
struct Caption {
  Eigen::Vector3d at_m = Eigen::Vector3d::Zero();
  double height_m = 1.0;  ///< of a capital letter
  std::string text;
  std::size_t carrier = 0;  ///< index in the list of them; posts of the line have none
};

/// X_WT: the track's frame in the world.
Eigen::Isometry3d frameOf(const rail::TrackPose& pose);

}  // namespace viz
