#include "markers.hpp"

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

const Carrier& theMap() {
  static const Carrier map{"map", Eigen::Isometry3d::Identity()};
  return map;
}

/// Of a carrier that moves: rviz moves the marker with it, whenever the marker was sent.
Marker makeMarker(const Carrier& carrier, const std::string& name, std::size_t id, int type) {
  Marker marker;
  marker.header.frame_id = carrier.frame;
  marker.frame_locked = carrier.frame != theMap().frame;
  marker.ns = name;
  marker.id = static_cast<int>(id);
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
  marker.color = toMsg(Colour{1.0, 1.0, 1.0, 1.0});
  return marker;
}

/// @param points  in the map
void setPoints(const Carrier& carrier, const std::vector<Eigen::Vector3d>& points, Marker& marker) {
  const Eigen::Isometry3d X_CW = carrier.X_WC.inverse();
  for (const Eigen::Vector3d& point : points) marker.points.push_back(toMsg(Eigen::Vector3d(X_CW * point)));
}

Marker makeTriangles(const Carrier& carrier, const std::string& name, std::size_t id, const Triangles& triangles) {
  Marker marker = makeMarker(carrier, name, id, Marker::TRIANGLE_LIST);
  setPoints(carrier, triangles.points, marker);
  for (const Colour& colour : triangles.colours) marker.colors.push_back(toMsg(colour));
  marker.color.a = static_cast<float>(triangles.opacity);
  return marker;
}

Marker makeSolid(const Carrier& carrier, const std::string& name, std::size_t id, int type,
                 const Eigen::Isometry3d& X_WB, const Eigen::Vector3d& size_m, const Colour& colour) {
  Marker marker = makeMarker(carrier, name, id, type);
  const Eigen::Isometry3d X_CB = carrier.X_WC.inverse() * X_WB;
  marker.pose.position = toMsg(Eigen::Vector3d(X_CB.translation()));
  marker.pose.orientation = orientationOf(X_CB);
  marker.scale.x = size_m.x();
  marker.scale.y = size_m.y();
  marker.scale.z = size_m.z();
  marker.color = toMsg(colour);
  return marker;
}

void addBoxes(const std::vector<Carrier>& carriers, const std::string& name, const std::vector<Box>& boxes,
              MarkerArray& msg) {
  std::size_t id = 0;
  for (const Box& box : boxes)
    msg.markers.push_back(makeSolid(carriers[box.carrier], name, id++, Marker::CUBE, box.X_WB, box.size_m, box.colour));
}

void addCylinders(const Carrier& carrier, const std::string& name, const std::vector<Cylinder>& cylinders,
                  MarkerArray& msg) {
  std::size_t id = 0;
  for (const Cylinder& cylinder : cylinders)
    msg.markers.push_back(
        makeSolid(carrier, name, id++, Marker::CYLINDER, cylinder.X_WC, cylinder.size_m, cylinder.colour));
}

Marker makeLine(const std::string& name, const std::vector<Eigen::Vector3d>& points, double width_m, Colour colour) {
  Marker marker = makeMarker(theMap(), name, 0, Marker::LINE_STRIP);
  marker.scale.x = width_m;
  marker.color = toMsg(colour);
  setPoints(theMap(), points, marker);
  return marker;
}

Marker makeText(const Carrier& carrier, const std::string& name, std::size_t id, const Caption& caption) {
  Marker marker = makeMarker(carrier, name, id, Marker::TEXT_VIEW_FACING);
  marker.pose.position = toMsg(Eigen::Vector3d(carrier.X_WC.inverse() * caption.at_m));
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

void addArrows(const Carrier& carrier, const std::string& name, const std::vector<Arrow>& arrows, MarkerArray& msg) {
  std::size_t id = 0;
  for (const Arrow& arrow : arrows) {
    if ((arrow.to_m - arrow.from_m).norm() < kShortestArrow_m) continue;
    Marker marker = makeMarker(carrier, name, id++, Marker::ARROW);
    setPoints(carrier, {arrow.from_m, arrow.to_m}, marker);
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
  msg.markers.push_back(makeMarker(theMap(), "", 0, Marker::CUBE));
  msg.markers.back().action = Marker::DELETEALL;
  return msg;
}

MarkerArray toMsg(const TrackShape& shape) {
  MarkerArray msg = clearingMsg();  // of another run's line there may be more posts
  const Colour steel{0.62, 0.62, 0.66, 1.0}, pale{0.8, 0.78, 0.7, 1.0};
  msg.markers.push_back(makeTriangles(theMap(), "bed", 0, shape.bed));
  msg.markers.push_back(makeLine("left_rail", shape.left_rail, kRailWidth_m, steel));
  msg.markers.push_back(makeLine("right_rail", shape.right_rail, kRailWidth_m, steel));
  for (std::size_t i = 2; i < 4; ++i) msg.markers[i].pose.position.z = -0.5 * kRailWidth_m;  // tops are tops
  msg.markers.push_back(makeLine("centre", shape.centre, kCentreWidth_m, pale));
  std::size_t id = 0;
  for (const Caption& post : shape.posts) msg.markers.push_back(makeText(theMap(), "posts", id++, post));
  return msg;
}

MarkerArray toTrainMsg(const TrainShape& shape, const std::vector<Caption>& captions) {
  MarkerArray msg;
  addBoxes(shape.carriers, "bodies", shape.bodies, msg);
  for (const Triangles& roofs : shape.roofs)
    addOrTakeAway(makeTriangles(shape.carriers[roofs.carrier], "roofs", roofs.carrier, roofs), msg);
  addBoxes(shape.carriers, "bogies", shape.bogies, msg);
  addBoxes(shape.carriers, "chosen_bogies", shape.chosen_bogies, msg);
  addCylinders(shape.carriers[shape.chosen], "chosen_wheels", shape.chosen_wheels, msg);
  std::size_t id = 0;
  for (const Caption& caption : captions)
    msg.markers.push_back(makeText(shape.carriers[caption.carrier], "text", id++, caption));
  return msg;
}

MarkerArray toCouplersMsg(const TrainShape& shape) {
  MarkerArray msg;
  addBoxes(shape.carriers, "couplers", shape.couplers, msg);
  addOrTakeAway(makeTriangles(shape.carriers.front(), "diagram", 0, shape.force_diagram), msg);
  return msg;
}

MarkerArray toMsg(const ContactShape& shape) {
  MarkerArray msg = clearingMsg();  // contacts come and go
  addArrows(shape.carrier, "normal", shape.normal_forces, msg);
  addArrows(shape.carrier, "creep", shape.creep_forces, msg);
  addCylinders(shape.carrier, "patches", shape.patches, msg);
  return msg;
}

tf2_msgs::TFMessage makeAlias(const std::string& frame, const std::string& alias) {
  tf2_msgs::TFMessage msg;
  msg.transforms.resize(1);
  msg.transforms[0].header.frame_id = frame;
  msg.transforms[0].child_frame_id = alias;
  msg.transforms[0].transform.rotation.w = 1.0;
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
