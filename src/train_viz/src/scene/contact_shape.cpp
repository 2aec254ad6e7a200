#include "train_viz/contact_shape.hpp"

#include <cmath>

#include "train_viz/colour_scale.hpp"

namespace viz {

namespace {

constexpr Colour kNormal{0.85, 0.92, 1.0, 1.0};  // chosen: none of the scales has it

/// X_WP: the contact's own frame: x in rolling direction, z along the rail's outward normal.
Eigen::Isometry3d contactFrame(const rail::WorldTrack& world, double location_m, const Contact& contact) {
  return frameOf(world.at(location_m + contact.axle_m + contact.x_m)) *
         Eigen::Translation3d(0.0, contact.y_m, contact.z_m) *
         Eigen::AngleAxisd(contact.angle_rad, Eigen::Vector3d::UnitX());
}

Arrow arrowOf(const Eigen::Isometry3d& X_WP, const Eigen::Vector3d& force_P_N, const Colour& colour) {
  return {X_WP.translation(), X_WP * Eigen::Vector3d(kArrow_m_per_N * force_P_N), colour};
}

}  // namespace

double Contact::computeUse() const {
  const double offered_N = friction * normal_N;
  return offered_N > 0.0 ? std::hypot(longitudinal_N, lateral_N) / offered_N : 0.0;
}

ContactShape computeContactShape(const rail::WorldTrack& world, int number, double location_m,
                                 const std::vector<Contact>& contacts) {
  ContactShape shape;
  shape.carrier = locomotiveCarrier(world, number, location_m);
  for (const Contact& contact : contacts) {
    const Eigen::Isometry3d X_WP = contactFrame(world, location_m, contact);
    const Colour colour = adhesionColour(contact.computeUse());
    shape.normal_forces.push_back(arrowOf(X_WP, {0.0, 0.0, contact.normal_N}, kNormal));
    shape.creep_forces.push_back(arrowOf(X_WP, {contact.longitudinal_N, contact.lateral_N, 0.0}, colour));
    if (contact.a_m > 0.0 && contact.b_m > 0.0)
      shape.patches.push_back(
          {X_WP, {2.0 * kPatchScale * contact.a_m, 2.0 * kPatchScale * contact.b_m, kPatchThickness_m}, colour});
  }
  return shape;
}

}  // namespace viz
