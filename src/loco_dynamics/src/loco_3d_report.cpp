// What a 3D locomotive tells of its contacts.

#include <algorithm>
#include <cmath>

#include "loco_dynamics/loco_3d.hpp"

namespace loco {

namespace {

ContactAdhesion reportOf(const WheelsetContact::Contact& c, std::size_t axle) {
  ContactAdhesion out;
  out.axle = static_cast<std::uint8_t>(axle + 1);
  out.right = c.side == Side::kRight;
  out.x_m = c.region.p_T.x();
  out.y_m = c.region.p_T.y();
  out.z_m = c.region.p_T.z();
  out.angle_rad = c.region.angle_rad;
  out.rolling_radius_m = c.region.rolling_radius_m;
  out.a_m = c.a_m;
  out.b_m = c.b_m;
  out.normal_force_N = c.normal_N;
  out.longitudinal_force_N = c.creep_N.x();
  out.lateral_force_N = c.creep_N.y();
  out.xi_x = c.creepage.xi_x;
  out.xi_y = c.creepage.xi_y;
  out.phi_1pm = c.creepage.phi_1pm;
  out.friction = c.friction;
  return out;
}

/// Adds one contact to its axle's sums. Friction: the mean by normal force.
void addContact(const WheelsetContact::Contact& c, AxleAdhesion& to) {
  const Eigen::Vector3d F = c.force_N();
  const auto wheel = static_cast<std::size_t>(c.side);
  to.vertical_force_N[wheel] += F.z();
  to.lateral_force_N[wheel] += F.y();
  to.normal_force_N += c.normal_N;
  to.force_N += c.creep_N.x();
  to.friction += c.friction * c.normal_N;
  to.frictional_power_W -= c.creep_N.dot(c.slip_mps);
  to.t_gamma_N += std::abs(c.creep_N.x() * c.creepage.xi_x + c.creep_N.y() * c.creepage.xi_y);
}

}  // namespace

std::vector<BodyPose> Loco3d::computePoses(const std::vector<double>& state) const {
  return dynamics_.computePoses(state.data());
}

void Loco3d::report(AdhesionReport& out) const {
  out.axles.resize(BodyLayout::kAxles);
  out.contacts.clear();
  out.contacts.reserve(2 * kMostContacts * BodyLayout::kAxles);
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    AxleAdhesion& to = out.axles[axle];
    to = {};
    for (std::size_t i = 0; i < contacts_[axle].count; ++i) {
      addContact(contacts_[axle].list[i], to);
      out.contacts.push_back(reportOf(contacts_[axle].list[i], axle));
    }
    if (to.normal_force_N > 0.0) {
      to.friction /= to.normal_force_N;
      to.adhesion = to.force_N / to.normal_force_N;
    }
    const auto& v = state_.v[BodyLayout::wheelset(axle)];
    to.creep = (v[kPitch] * parameters_.structure.wheel_radius_m - v[kX]) / std::max(v[kX], kCreepageSpeedFloor_mps);
    to.static_friction = contacts_[axle].static_friction;
    to.torque_reference_N_m = drive_.torqueReference_N_m(axle);
    to.torque_N_m = drive_.torque_N_m(axle);
    to.shoe_torque_N_m = shoe_N_m_[axle];
    to.controlled = drive_.controlled(axle);
  }
}

}  // namespace loco
