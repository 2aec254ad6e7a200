#include "train_viz/shapes.hpp"

#include <cmath>

namespace viz {

namespace {

// Chosen: as if light came from above and from the left. rviz does not light triangles that have colours of their own.
constexpr double kTop = 1.0, kLeft = 0.88, kRight = 0.74, kEnds = 0.62, kBottom = 0.5;

Colour shade(const Colour& colour, double brightness) {
  return {brightness * colour.r, brightness * colour.g, brightness * colour.b, colour.a};
}

}  // namespace

void Triangles::add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                    const Colour& colour) {
  for (const Eigen::Vector3d& point : {a, b, c}) {
    points.push_back(point);
    colours.push_back(colour);
  }
}

void Triangles::add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                    const Eigen::Vector3d& d, const Colour& colour) {
  add(a, b, c, colour);
  add(a, c, d, colour);
}

void Triangles::add(const Box& box) {
  const Eigen::Vector3d h = 0.5 * box.size_m;
  const auto corner = [&](double x, double y, double z) -> Eigen::Vector3d {
    return box.X_WB * Eigen::Vector3d(x * h.x(), y * h.y(), z * h.z());
  };
  const Colour ends = shade(box.colour, kEnds);
  add(corner(1, -1, -1), corner(1, 1, -1), corner(1, 1, 1), corner(1, -1, 1), ends);
  add(corner(-1, 1, -1), corner(-1, -1, -1), corner(-1, -1, 1), corner(-1, 1, 1), ends);
  add(corner(1, 1, -1), corner(-1, 1, -1), corner(-1, 1, 1), corner(1, 1, 1), shade(box.colour, kLeft));
  add(corner(-1, -1, -1), corner(1, -1, -1), corner(1, -1, 1), corner(-1, -1, 1), shade(box.colour, kRight));
  add(corner(-1, -1, 1), corner(1, -1, 1), corner(1, 1, 1), corner(-1, 1, 1), shade(box.colour, kTop));
  add(corner(-1, 1, -1), corner(1, 1, -1), corner(1, -1, -1), corner(-1, -1, -1), shade(box.colour, kBottom));
}

void Triangles::addCylinder(const Eigen::Isometry3d& X_WB, double radius_m, double width_m, const Colour& colour) {
  constexpr int kSides = 32;  // chosen: round to the eye
  const double h = 0.5 * width_m;
  const auto rim = [&](int i, double y) -> Eigen::Vector3d {
    const double angle = 2.0 * M_PI * i / kSides;
    return X_WB * Eigen::Vector3d(radius_m * std::cos(angle), y, radius_m * std::sin(angle));
  };
  const Eigen::Vector3d left = X_WB * Eigen::Vector3d(0.0, h, 0.0);
  const Eigen::Vector3d right = X_WB * Eigen::Vector3d(0.0, -h, 0.0);
  for (int i = 0; i < kSides; ++i) {
    add(left, rim(i + 1, h), rim(i, h), colour);
    add(right, rim(i, -h), rim(i + 1, -h), colour);
    add(rim(i, -h), rim(i, h), rim(i + 1, h), rim(i + 1, -h), shade(colour, kEnds));
  }
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

}  // namespace viz
