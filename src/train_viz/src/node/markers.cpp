#include "markers.hpp"

#include <cmath>
#include <stdexcept>

namespace viz {

namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr double kRailWidth_m = 0.072;  // head of a UIC60 rail
constexpr double kCentreWidth_m = 0.05;
constexpr Colour kInk{0.08, 0.1, 0.16, 1.0};  // chosen: read before a light sky
constexpr double kShaft_m = 0.05;             // chosen, of arrows: seen beside wheels of 1 m
constexpr double kHead_m = 0.12;
constexpr double kShortestArrow_m = 0.001;  // chosen: rviz cannot draw an arrow without a direction

geometry_msgs::Point toMsg(const Eigen::Vector3d& p) {
  geometry_msgs::Point msg;
  msg.x = p.x();
  msg.y = p.y();
  msg.z = p.z();
  return msg;
}

geometry_msgs::Quaternion orientationOf(const Eigen::Isometry3d& X) {
  const Eigen::Quaterniond q(X.linear());
  geometry_msgs::Quaternion msg;
  msg.w = q.w();
  msg.x = q.x();
  msg.y = q.y();
  msg.z = q.z();
  return msg;
}

std_msgs::ColorRGBA toMsg(const Colour& colour) {
  std_msgs::ColorRGBA msg;
  msg.r = static_cast<float>(colour.r);
  msg.g = static_cast<float>(colour.g);
  msg.b = static_cast<float>(colour.b);
  msg.a = static_cast<float>(colour.a);
  return msg;
}

Marker makeMarker(const std::string& name, int id, int type) {
  Marker marker;
  marker.header.frame_id = "map";
  marker.ns = name;
  marker.id = id;
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
  marker.color = toMsg(Colour{1.0, 1.0, 1.0, 1.0});
  return marker;
}

Marker makeTriangles(const std::string& name, const Triangles& triangles) {
  Marker marker = makeMarker(name, 0, Marker::TRIANGLE_LIST);
  for (const Eigen::Vector3d& point : triangles.points) marker.points.push_back(toMsg(point));
  for (const Colour& colour : triangles.colours) marker.colors.push_back(toMsg(colour));
  marker.color.a = static_cast<float>(triangles.opacity);
  return marker;
}

Marker makeSolid(const std::string& name, int id, int type, const Eigen::Isometry3d& X_WB,
                 const Eigen::Vector3d& size_m, const Colour& colour) {
  Marker marker = makeMarker(name, id, type);
  marker.pose.position = toMsg(Eigen::Vector3d(X_WB.translation()));
  marker.pose.orientation = orientationOf(X_WB);
  marker.scale.x = size_m.x();
  marker.scale.y = size_m.y();
  marker.scale.z = size_m.z();
  marker.color = toMsg(colour);
  return marker;
}

void addBoxes(const std::string& name, const std::vector<Box>& boxes, MarkerArray& msg) {
  int id = 0;
  for (const Box& box : boxes)
    msg.markers.push_back(makeSolid(name, id++, Marker::CUBE, box.X_WB, box.size_m, box.colour));
}

void addCylinders(const std::string& name, const std::vector<Cylinder>& cylinders, MarkerArray& msg) {
  int id = 0;
  for (const Cylinder& cylinder : cylinders)
    msg.markers.push_back(makeSolid(name, id++, Marker::CYLINDER, cylinder.X_WC, cylinder.size_m, cylinder.colour));
}

Marker makeLine(const std::string& name, const std::vector<Eigen::Vector3d>& points, double width_m, Colour colour) {
  Marker marker = makeMarker(name, 0, Marker::LINE_STRIP);
  marker.scale.x = width_m;
  marker.color = toMsg(colour);
  for (const Eigen::Vector3d& point : points) marker.points.push_back(toMsg(point));
  return marker;
}

Marker makeText(const std::string& name, int id, const Caption& caption) {
  Marker marker = makeMarker(name, id, Marker::TEXT_VIEW_FACING);
  marker.pose.position = toMsg(caption.at_m);
  marker.scale.z = caption.height_m;
  marker.text = caption.text;
  marker.color = toMsg(kInk);
  return marker;
}

/// Empty lists are an error to rviz: what is not there now is taken away.
void addOrTakeAway(Marker marker, MarkerArray& msg) {
  if (marker.points.empty()) marker.action = Marker::DELETE;
  msg.markers.push_back(std::move(marker));
}

void addArrows(const std::string& name, const std::vector<Arrow>& arrows, MarkerArray& msg) {
  int id = 0;
  for (const Arrow& arrow : arrows) {
    if ((arrow.to_m - arrow.from_m).norm() < kShortestArrow_m) continue;
    Marker marker = makeMarker(name, id++, Marker::ARROW);
    marker.points = {toMsg(arrow.from_m), toMsg(arrow.to_m)};
    marker.scale.x = kShaft_m;
    marker.scale.y = kHead_m;
    marker.scale.z = std::min(kHead_m, 0.5 * (arrow.to_m - arrow.from_m).norm());
    marker.color = toMsg(arrow.colour);
    msg.markers.push_back(marker);
  }
}

Contact contactOf(const train_msgs::ContactAdhesion& msg, double axle_m) {
  Contact contact;
  contact.axle_m = axle_m;
  contact.x_m = msg.x;
  contact.y_m = msg.y;
  contact.z_m = msg.z;
  contact.angle_rad = msg.angle;
  contact.a_m = msg.a;
  contact.b_m = msg.b;
  contact.normal_N = msg.normal_force;
  contact.longitudinal_N = msg.longitudinal_force;
  contact.lateral_N = msg.lateral_force;
  contact.friction = msg.friction;
  return contact;
}

Contact wheelOf(const train_msgs::AxleAdhesion& msg, double axle_m, double side) {
  Contact contact;
  contact.axle_m = axle_m;
  contact.y_m = 0.5 * side * rail::kCantBaseline_m;
  contact.normal_N = 0.5 * msg.normal_force;
  contact.longitudinal_N = 0.5 * msg.force;
  contact.friction = msg.friction;
  return contact;
}

}  // namespace

MarkerArray clearingMsg() {
  MarkerArray msg;
  msg.markers.push_back(makeMarker("", 0, Marker::CUBE));
  msg.markers.back().action = Marker::DELETEALL;
  return msg;
}

MarkerArray toMsg(const TrackShape& shape) {
  MarkerArray msg = clearingMsg();  // of another run's line there may be more posts
  const Colour steel{0.62, 0.62, 0.66, 1.0}, pale{0.8, 0.78, 0.7, 1.0};
  msg.markers.push_back(makeTriangles("bed", shape.bed));
  msg.markers.push_back(makeLine("left_rail", shape.left_rail, kRailWidth_m, steel));
  msg.markers.push_back(makeLine("right_rail", shape.right_rail, kRailWidth_m, steel));
  for (std::size_t i = 2; i < 4; ++i) msg.markers[i].pose.position.z = -0.5 * kRailWidth_m;  // tops are tops
  msg.markers.push_back(makeLine("centre", shape.centre, kCentreWidth_m, pale));
  int id = 0;
  for (const Caption& post : shape.posts) msg.markers.push_back(makeText("posts", id++, post));
  return msg;
}

MarkerArray toTrainMsg(const TrainShape& shape, const std::vector<Caption>& captions) {
  MarkerArray msg;
  addBoxes("bodies", shape.bodies, msg);
  addOrTakeAway(makeTriangles("roofs", shape.roofs), msg);
  addBoxes("bogies", shape.bogies, msg);
  addBoxes("chosen_bogies", shape.chosen_bogies, msg);
  addCylinders("chosen_wheels", shape.chosen_wheels, msg);
  int id = 0;
  for (const Caption& caption : captions) msg.markers.push_back(makeText("text", id++, caption));
  return msg;
}

MarkerArray toCouplersMsg(const TrainShape& shape) {
  MarkerArray msg;
  addBoxes("couplers", shape.couplers, msg);
  addOrTakeAway(makeTriangles("diagram", shape.force_diagram), msg);
  return msg;
}

MarkerArray toMsg(const ContactShape& shape) {
  MarkerArray msg = clearingMsg();  // contacts come and go
  addArrows("normal", shape.normal_forces, msg);
  addArrows("creep", shape.creep_forces, msg);
  addCylinders("patches", shape.patches, msg);
  return msg;
}

geometry_msgs::TransformStamped toMsg(ros::Time stamp, const std::string& child, const Eigen::Isometry3d& X) {
  geometry_msgs::TransformStamped msg;
  msg.header.stamp = stamp;
  msg.header.frame_id = "map";
  msg.child_frame_id = child;
  msg.transform.translation.x = X.translation().x();
  msg.transform.translation.y = X.translation().y();
  msg.transform.translation.z = X.translation().z();
  msg.transform.rotation = orientationOf(X);
  return msg;
}

CaptionValues fromMsg(const train_msgs::TrainState& msg) {
  return {msg.speed, msg.location, msg.notch, msg.brake_notch, msg.traction, msg.pipe_pressure, msg.cylinder_pressure};
}

std::vector<Contact> fromMsg(const train_msgs::Adhesion& msg, const VehicleOutline& locomotive) {
  const std::vector<double> axles_m = locomotive.axles_m();
  if (msg.axles.size() != axles_m.size())
    throw std::runtime_error("has " + std::to_string(msg.axles.size()) + " axles, the locomotive of this run has " +
                             std::to_string(axles_m.size()));
  std::vector<Contact> contacts;
  for (const train_msgs::ContactAdhesion& contact : msg.contacts)
    contacts.push_back(contactOf(contact, axles_m.at(contact.axle - 1U)));
  if (!contacts.empty()) return contacts;
  for (std::size_t i = 0; i < axles_m.size(); ++i)
    for (const double side : {1.0, -1.0}) contacts.push_back(wheelOf(msg.axles[i], axles_m[i], side));
  return contacts;
}

}  // namespace viz
