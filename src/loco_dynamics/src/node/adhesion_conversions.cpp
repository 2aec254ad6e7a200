#include "adhesion_conversions.hpp"

#include "loco_dynamics/node/conversions.hpp"

namespace loco {

namespace {

void toMsg(const AxleAdhesion& a, train_msgs::AxleAdhesion& msg) {
  msg.creep = a.creep;
  msg.adhesion = a.adhesion;
  msg.friction = a.friction;
  msg.static_friction = a.static_friction;
  msg.normal_force = a.normal_force_N;
  msg.force = a.force_N;
  msg.torque_demanded = a.torque_reference_N_m;
  msg.torque_applied = a.torque_N_m;
  msg.shoe_torque = a.shoe_torque_N_m;
  msg.controller_active = static_cast<std::uint8_t>(a.controlled);
  msg.frictional_power = a.frictional_power_W;
  msg.t_gamma = a.t_gamma_N;
  msg.vertical_force_left = a.vertical_force_N[0];
  msg.vertical_force_right = a.vertical_force_N[1];
  msg.lateral_force_left = a.lateral_force_N[0];
  msg.lateral_force_right = a.lateral_force_N[1];
}

AxleAdhesion fromMsg(const train_msgs::AxleAdhesion& msg) {
  AxleAdhesion a;
  a.creep = msg.creep;
  a.adhesion = msg.adhesion;
  a.friction = msg.friction;
  a.static_friction = msg.static_friction;
  a.normal_force_N = msg.normal_force;
  a.force_N = msg.force;
  a.torque_reference_N_m = msg.torque_demanded;
  a.torque_N_m = msg.torque_applied;
  a.shoe_torque_N_m = msg.shoe_torque;
  a.controlled = msg.controller_active != 0;
  a.frictional_power_W = msg.frictional_power;
  a.t_gamma_N = msg.t_gamma;
  a.vertical_force_N[0] = msg.vertical_force_left;
  a.vertical_force_N[1] = msg.vertical_force_right;
  a.lateral_force_N[0] = msg.lateral_force_left;
  a.lateral_force_N[1] = msg.lateral_force_right;
  return a;
}

void toMsg(const ContactAdhesion& c, train_msgs::ContactAdhesion& msg) {
  msg.axle = c.axle;
  msg.right = static_cast<std::uint8_t>(c.right);
  msg.x = c.x_m;
  msg.y = c.y_m;
  msg.z = c.z_m;
  msg.angle = c.angle_rad;
  msg.rolling_radius = c.rolling_radius_m;
  msg.a = c.a_m;
  msg.b = c.b_m;
  msg.normal_force = c.normal_force_N;
  msg.longitudinal_force = c.longitudinal_force_N;
  msg.lateral_force = c.lateral_force_N;
  msg.creep_x = c.xi_x;
  msg.creep_y = c.xi_y;
  msg.spin = c.phi_1pm;
  msg.friction = c.friction;
}

ContactAdhesion fromMsg(const train_msgs::ContactAdhesion& msg) {
  ContactAdhesion c;
  c.axle = msg.axle;
  c.right = msg.right != 0;
  c.x_m = msg.x;
  c.y_m = msg.y;
  c.z_m = msg.z;
  c.angle_rad = msg.angle;
  c.rolling_radius_m = msg.rolling_radius;
  c.a_m = msg.a;
  c.b_m = msg.b;
  c.normal_force_N = msg.normal_force;
  c.longitudinal_force_N = msg.longitudinal_force;
  c.lateral_force_N = msg.lateral_force;
  c.xi_x = msg.creep_x;
  c.xi_y = msg.creep_y;
  c.phi_1pm = msg.spin;
  c.friction = msg.friction;
  return c;
}

}  // namespace

void toMsg(const AdhesionReport& report, std::vector<train_msgs::AxleAdhesion>& axles,
           std::vector<train_msgs::ContactAdhesion>& contacts) {
  axles.resize(report.axles.size());
  for (std::size_t i = 0; i < report.axles.size(); ++i) toMsg(report.axles[i], axles[i]);
  contacts.resize(report.contacts.size());
  for (std::size_t i = 0; i < report.contacts.size(); ++i) toMsg(report.contacts[i], contacts[i]);
}

AdhesionReport fromMsg(const std::vector<train_msgs::AxleAdhesion>& axles,
                       const std::vector<train_msgs::ContactAdhesion>& contacts) {
  AdhesionReport report;
  for (const train_msgs::AxleAdhesion& axle : axles) report.axles.push_back(fromMsg(axle));
  for (const train_msgs::ContactAdhesion& contact : contacts) report.contacts.push_back(fromMsg(contact));
  return report;
}

void toMsg(rail::Nanoseconds t, const LocoTraction& traction, train_msgs::Adhesion& msg) {
  msg.header.stamp = toStamp(t);
  msg.location = traction.location_m;
  msg.speed = traction.speed_mps;
  toMsg(traction.adhesion, msg.axles, msg.contacts);
}

}  // namespace loco
