#include "node/markers.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

/// A locomotive with two axles, 2 m before and behind its CoG.
viz::VehicleOutline twoAxles() {
  viz::VehicleOutline locomotive;
  locomotive.bogies = {{2.0, {2.0}}, {-2.0, {-2.0}}};
  return locomotive;
}

train_msgs::Adhesion twoAxlesPulling() {
  train_msgs::Adhesion msg;
  msg.axles.resize(2);
  for (train_msgs::AxleAdhesion& axle : msg.axles) {
    axle.normal_force = 200e3;
    axle.force = 60e3;
    axle.friction = 0.4;
  }
  return msg;
}

std::set<std::string> namesOf(const MarkerArray& msg, int action) {
  std::set<std::string> names;
  for (const Marker& marker : msg.markers)
    if (marker.action == action) names.insert(marker.ns);
  return names;
}

TEST(FromAdhesionTest, RefusesAnotherNumberOfAxles) {
  train_msgs::Adhesion msg = twoAxlesPulling();
  msg.axles.resize(6);
  EXPECT_THROW(viz::fromMsg(msg, twoAxles()), std::runtime_error);
}

TEST(FromAdhesionTest, WithoutContactsEveryWheelHasHalfOfItsAxlesForces) {
  const std::vector<viz::Contact> contacts = viz::fromMsg(twoAxlesPulling(), twoAxles());
  ASSERT_EQ(contacts.size(), 4U);
  EXPECT_EQ(contacts[0].axle_m, 2.0);
  EXPECT_EQ(contacts[3].axle_m, -2.0);
  EXPECT_EQ(contacts[0].y_m, 0.75);
  EXPECT_EQ(contacts[1].y_m, -0.75);
  for (const viz::Contact& contact : contacts) {
    EXPECT_EQ(contact.normal_N, 100e3);
    EXPECT_EQ(contact.longitudinal_N, 30e3);
    EXPECT_DOUBLE_EQ(contact.computeUse(), 0.75);
  }
}

TEST(FromAdhesionTest, ContactsStandAtTheirAxles) {
  train_msgs::Adhesion msg = twoAxlesPulling();
  msg.contacts.resize(1);
  msg.contacts[0].axle = 2;
  msg.contacts[0].y = -0.76;
  msg.contacts[0].normal_force = 90e3;
  msg.contacts[0].longitudinal_force = -5e3;
  msg.contacts[0].lateral_force = 7e3;
  const std::vector<viz::Contact> contacts = viz::fromMsg(msg, twoAxles());
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].axle_m, -2.0);
  EXPECT_EQ(contacts[0].y_m, -0.76);
  EXPECT_EQ(contacts[0].normal_N, 90e3);
  EXPECT_EQ(contacts[0].longitudinal_N, -5e3);
  EXPECT_EQ(contacts[0].lateral_N, 7e3);
  msg.contacts[0].axle = 3;
  EXPECT_THROW(viz::fromMsg(msg, twoAxles()), std::exception);
}

TEST(MarkersTest, ContactsOfBeforeAreTakenAway) {
  const MarkerArray msg = viz::toMsg(viz::ContactShape{});
  ASSERT_EQ(msg.markers.size(), 1U);
  EXPECT_EQ(msg.markers[0].action, Marker::DELETEALL);
}

TEST(MarkersTest, WhatIsEmptyIsTakenAwayNotDrawn) {
  const MarkerArray msg = viz::toCouplersMsg(viz::TrainShape{});
  EXPECT_TRUE(namesOf(msg, Marker::ADD).empty());
  EXPECT_EQ(namesOf(msg, Marker::DELETE), (std::set<std::string>{"diagram"}));
}

/// rviz knows a marker by name and number.
TEST(MarkersTest, EveryBoxAndWheelHasANumberOfItsOwnAndItsOwnPoseAndSize) {
  viz::TrainShape shape;
  shape.bodies.resize(3);
  shape.carriers.resize(2);
  shape.roofs.resize(2);
  shape.roofs[1].carrier = 1;
  shape.chosen_wheels.resize(18);
  shape.bodies[2].X_WB.translation() = Eigen::Vector3d(1.0, 2.0, 3.0);
  shape.bodies[2].size_m = Eigen::Vector3d(14.0, 2.9, 2.0);
  const MarkerArray msg = viz::toTrainMsg(shape, {});
  std::set<std::pair<std::string, int>> names;
  for (const Marker& marker : msg.markers) names.insert({marker.ns, marker.id});
  EXPECT_EQ(names.size(), 23U);
  EXPECT_EQ(msg.markers[2].type, Marker::CUBE);
  EXPECT_EQ(msg.markers[2].pose.position.z, 3.0);
  EXPECT_EQ(msg.markers[2].scale.x, 14.0);
  EXPECT_EQ(msg.markers[5].type, Marker::CYLINDER) << "after the roofs";
}

/// A picture of the paper's train: 108 bodies and roofs, 214 bogies, 107 couplers and a piece of the diagram between
/// two couplers, two bogies and 18 cylinders of the chosen locomotive. With the corners of all boxes it was 0.92 MB.
TEST(MarkersTest, APictureOf108VehiclesIsLessThan120kB) {
  viz::TrainShape shape;
  shape.bodies.resize(108);
  shape.bogies.resize(214);
  shape.couplers.resize(107);
  shape.chosen_bogies.resize(2);
  shape.chosen_wheels.resize(18);
  const Eigen::Vector3d corner = Eigen::Vector3d::Zero();
  for (int i = 0; i < 106; ++i) shape.force_diagram.add(corner, corner, corner, corner, {});
  shape.roofs.resize(1);
  for (int i = 0; i < 108; ++i) shape.roofs[0].add(corner, corner, corner, corner, {});
  const std::vector<viz::Caption> captions(2, {corner, 1.0, std::string(100, 'x')});
  const std::uint32_t bytes = ros::serialization::serializationLength(viz::toTrainMsg(shape, captions)) +
                              ros::serialization::serializationLength(viz::toCouplersMsg(shape));
  RecordProperty("bytes", static_cast<int>(bytes));
  EXPECT_LT(bytes, 120000U);
  EXPECT_GT(bytes, 449U * 7U * 8U) << "every pose is there";
}

/// rviz blends triangles with a colour each by the marker's own opacity.
TEST(MarkersTest, TheDiagramIsToBeLookedThrough) {
  viz::TrainShape shape;
  const Eigen::Vector3d corner = Eigen::Vector3d::Zero();
  shape.force_diagram.add(corner, corner, corner, corner, {1.0, 0.0, 0.0, 1.0});
  shape.force_diagram.opacity = 0.5;
  const MarkerArray msg = viz::toCouplersMsg(shape);
  ASSERT_EQ(msg.markers.back().ns, "diagram");
  EXPECT_EQ(msg.markers.back().color.a, 0.5F);
  EXPECT_EQ(msg.markers.back().colors.size(), 2U);
  EXPECT_EQ(msg.markers.back().points.size(), 6U);
}

TEST(MarkersTest, ForcesTooSmallForADirectionAreNotDrawn) {
  viz::ContactShape shape;
  shape.creep_forces.push_back({Eigen::Vector3d::Zero(), Eigen::Vector3d(1e-5, 0.0, 0.0), {}});
  shape.creep_forces.push_back({Eigen::Vector3d::Zero(), Eigen::Vector3d(0.5, 0.0, 0.0), {}});
  const MarkerArray msg = viz::toMsg(shape);
  ASSERT_EQ(msg.markers.size(), 2U);
  EXPECT_EQ(msg.markers[1].points[1].x, 0.5);
}

/// A locomotive 3 m along and 1 m left of the map's origin, that looks to the left.
viz::Carrier leftwards() {
  viz::Carrier carrier{"loco_2/base_link", Eigen::Isometry3d::Identity()};
  carrier.X_WC.translation() = Eigen::Vector3d(3.0, 1.0, 0.0);
  carrier.X_WC.linear() = Eigen::AngleAxisd(0.5 * M_PI, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return carrier;
}

void expectAt(const geometry_msgs::Point& p, double x, double y, double z) {
  EXPECT_NEAR(p.x, x, 1e-12);
  EXPECT_NEAR(p.y, y, 1e-12);
  EXPECT_NEAR(p.z, z, 1e-12);
}

/// A body 2 m before the locomotive's place, that looks as it does; a roof's and a text's point 2 m left of it.
TEST(MarkersTest, WhatMovesIsPlacedInItsCarriersFrameAndLockedToIt) {
  viz::TrainShape shape;
  shape.carriers.push_back(leftwards());
  shape.bodies.resize(1);
  shape.bodies[0].carrier = 1;
  shape.bodies[0].X_WB = leftwards().X_WC * Eigen::Translation3d(2.0, 0.0, 0.0);
  const Eigen::Vector3d corner(1.0, 1.0, 4.0);
  shape.roofs.resize(1);
  shape.roofs[0].carrier = 1;
  shape.roofs[0].add(corner, corner, corner, corner, {});
  const MarkerArray msg = viz::toTrainMsg(shape, {{corner, 1.0, "text", 1}});
  ASSERT_EQ(msg.markers.size(), 3U);
  for (const Marker& marker : msg.markers) {
    EXPECT_EQ(marker.header.frame_id, "loco_2/base_link");
    EXPECT_TRUE(marker.frame_locked);
    EXPECT_TRUE(marker.header.stamp.isZero()) << "at no time but now";
    EXPECT_NEAR(marker.pose.orientation.w, 1.0, 1e-12) << "turned by the frame";
  }
  expectAt(msg.markers[0].pose.position, 2.0, 0.0, 0.0);
  expectAt(msg.markers[1].points[0], 0.0, 2.0, 4.0);
  expectAt(msg.markers[1].pose.position, 0.0, 0.0, 0.0);
  expectAt(msg.markers[2].pose.position, 0.0, 2.0, 4.0);
}

TEST(MarkersTest, ContactsAreCarriedByTheirLocomotive) {
  viz::ContactShape shape;
  shape.carrier = leftwards();
  shape.normal_forces.push_back({Eigen::Vector3d(3.0, 2.0, 0.0), Eigen::Vector3d(3.0, 2.0, 1.1), {}});
  shape.patches.resize(1);
  shape.patches[0].X_WC.translation() = Eigen::Vector3d(3.0, 2.0, 0.0);
  const MarkerArray msg = viz::toMsg(shape);
  ASSERT_EQ(msg.markers.size(), 3U);
  for (std::size_t i = 1; i < 3; ++i) {
    EXPECT_EQ(msg.markers[i].header.frame_id, "loco_2/base_link");
    EXPECT_TRUE(msg.markers[i].frame_locked);
  }
  expectAt(msg.markers[1].points[0], 1.0, 0.0, 0.0);
  expectAt(msg.markers[1].points[1], 1.0, 0.0, 1.1);
  expectAt(msg.markers[2].pose.position, 1.0, 0.0, 0.0);
}

/// rviz would build a line of 400 km anew for each of its pictures, if it were locked.
TEST(MarkersTest, TheLineStaysInTheMap) {
  viz::TrackShape shape;
  shape.bed.add(Eigen::Vector3d(1.0, 0.0, 0.0), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                Eigen::Vector3d::Zero(), {});
  shape.posts.push_back({Eigen::Vector3d(1.0, 0.0, 0.0), 1.0, "0.1"});
  for (const Marker& marker : viz::toMsg(shape).markers) {
    EXPECT_EQ(marker.header.frame_id, "map");
    EXPECT_FALSE(marker.frame_locked);
  }
}

TEST(MarkersTest, AnAliasLiesInItsFrame) {
  const tf2_msgs::TFMessage msg = viz::makeAlias("loco_3/base_link", "chosen_locomotive");
  ASSERT_EQ(msg.transforms.size(), 1U);
  EXPECT_EQ(msg.transforms[0].header.frame_id, "loco_3/base_link");
  EXPECT_EQ(msg.transforms[0].child_frame_id, "chosen_locomotive");
  EXPECT_EQ(msg.transforms[0].transform.translation.x, 0.0);
  EXPECT_EQ(msg.transforms[0].transform.rotation.w, 1.0);
}

}  // namespace
