#include "node/markers.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

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
  EXPECT_EQ(namesOf(msg, Marker::DELETE), (std::set<std::string>{"couplers", "diagram"}));
}

TEST(MarkersTest, ForcesTooSmallForADirectionAreNotDrawn) {
  viz::ContactShape shape;
  shape.creep_forces.push_back({Eigen::Vector3d::Zero(), Eigen::Vector3d(1e-5, 0.0, 0.0), {}});
  shape.creep_forces.push_back({Eigen::Vector3d::Zero(), Eigen::Vector3d(0.5, 0.0, 0.0), {}});
  const MarkerArray msg = viz::toMsg(shape);
  ASSERT_EQ(msg.markers.size(), 2U);
  EXPECT_EQ(msg.markers[1].points[1].x, 0.5);
}

TEST(MarkersTest, FramesAreChildrenOfTheMap) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation() = Eigen::Vector3d(1.0, 2.0, 3.0);
  const geometry_msgs::TransformStamped frame = viz::toMsg(ros::Time(7.0), "train", X);
  EXPECT_EQ(frame.header.frame_id, "map");
  EXPECT_EQ(frame.child_frame_id, "train");
  EXPECT_EQ(frame.transform.translation.y, 2.0);
  EXPECT_EQ(frame.transform.rotation.w, 1.0);
}

}  // namespace
