#include "loco_dynamics/wheelset_contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "loco_dynamics/shoe_brake.hpp"

namespace loco {

namespace {

using Eigen::Vector3d;

/// (W1) for the unit vector d at r from the CoG.
Vector6 row(const Vector3d& d, const Vector3d& r, const Vector3d& axle) {
  Vector6 J;
  J << d.x(), d.y(), d.z(), d.z() * r.y() - d.y() * r.z(), d.dot(axle.cross(r)), d.y() * r.x() - d.x() * r.y();
  return J;
}

void placeContact(const WheelsetMotion& motion, double wheel_radius_m, WheelsetContact::Contact& c) {
  const double y = motion.q[kY], z = motion.q[kZ], sin = std::sin(c.region.angle_rad),
               cos = std::cos(c.region.angle_rad);
  const Vector3d r = c.region.p_T - Vector3d(0.0, y, wheel_radius_m + z);
  const Vector3d axle(-motion.q[kYaw], 1.0, motion.q[kRoll]);
  c.J_n = row({0.0, -sin, cos}, r, axle);
  c.J_n[kPitch] = 0.0;  // a wheel is round: spinning moves its surface along itself
  c.J_x = row({1.0, 0.0, 0.0}, r, axle);
  c.J_t = row({0.0, cos, sin}, r, axle);
  const double turning = motion.v[kX] * motion.curvature_1pm;
  c.frame_mps = {-turning * c.region.p_T.y(), turning * r.x() * cos};
}

WheelsetPose seenFrom(const rail::RailOffset& rail, const WheelsetPose& pose) {
  return {pose.y_m - rail.y_m, pose.z_m - rail.z_m, pose.roll_rad, pose.yaw_rad - rail.y_slope};
}

/// A region as seen from its rail, in T. The lead of its yaw against the rail is right already, not so the place that
/// the wheel has from its own yaw.                                                                          (W6)
void moveWithRail(const rail::RailOffset& rail, double axle_y_m, ContactRegion& region) {
  region.p_T.y() += rail.y_m;
  region.p_T.z() += rail.z_m;
  region.p_T.x() += region.rolling_radius_m * rail.z_slope - rail.y_slope * (region.p_T.y() - axle_y_m);
}

void turnWithRail(const rail::RailOffset& rail, const WheelsetMotion& motion, double wheel_radius_m,
                  WheelsetContact::Contact& c) {
  const double sin = std::sin(c.region.angle_rad), cos = std::cos(c.region.angle_rad);
  const Vector3d r = c.region.p_T - Vector3d(0.0, motion.q[kY], wheel_radius_m + motion.q[kZ]);
  const Vector3d axle(-motion.q[kYaw], 1.0, motion.q[kRoll]);
  c.J_n = row({rail.y_slope * sin - rail.z_slope * cos, -sin, cos}, r, axle);  // (W6)
  c.J_n[kPitch] = 0.0;
  c.J_x = row({1.0, rail.y_slope, rail.z_slope}, r, axle);
  c.J_t = row({-rail.y_slope * cos - rail.z_slope * sin, cos, sin}, r, axle);
}

/// Rows of J along the slip and across it.
Vector6 alongSlip(const WheelsetContact::Contact& c) { return c.along.x() * c.J_x + c.along.y() * c.J_t; }
Vector6 acrossSlip(const WheelsetContact::Contact& c) { return c.along.x() * c.J_t - c.along.y() * c.J_x; }

/// The straight line of an implicit step may pass what the law cannot: a force keeps its direction, up to mu N.
Eigen::Vector2d withinFriction(const Eigen::Vector2d& force_N, double largest_N) {
  const double size_N = force_N.norm();
  return size_N > largest_N ? Eigen::Vector2d(force_N * (largest_N / size_N)) : force_N;
}

/// Slope of the closed form (C10) over that at no creep; 0 at full slip.
/// @param x  force over mu N if the law went on straight
double relativeSlope(double x) {
  constexpr double kPi = 3.14159265358979323846;
  const double H = 3.0 * kPi / 16.0 * x;
  if (H >= 2.0) return 0.0;
  const double c0 = 0.5 * H, s0 = std::sqrt((1.0 - c0) * (1.0 + c0)), t0 = std::acos(c0);
  return 0.75 * (2.0 * s0 * (1.0 - s0 * s0 / 3.0) - H * (t0 + s0 * c0) + 0.5 * H * H * s0);
}

/// Torque of the shoes, which stops the turning if it can, against forces on the straight lines of (W5).     (P3)
/// @param change  of velocity in the step without shoes; becomes that with them
template <typename Solver>
double addShoeTorque(const Solver& solver, const WheelsetContact::Shoes& shoes, Vector6& change) {
  const Vector6 per_torque = solver.solve(Vector6::Unit(kPitch));
  const double stopping_N_m = (shoes.turning_radps + change[kPitch]) / per_torque[kPitch];
  const double torque_N_m = computeHoldingForce(stopping_N_m, shoes.largest_N_m);
  change += per_torque * torque_N_m;
  return torque_N_m;
}

}  // namespace

Vector3d WheelsetContact::Contact::force_N() const {
  const double sin = std::sin(region.angle_rad), cos = std::cos(region.angle_rad);
  return {alongTrack_N(), cos * creep_N.y() - sin * normal_N + creep_N.x() * J_x[kY],
          sin * creep_N.y() + cos * normal_N + creep_N.x() * J_x[kZ]};
}

double WheelsetContact::Contact::alongTrack_N() const {
  return creep_N.x() + J_t[kX] * creep_N.y() + J_n[kX] * normal_N;  // the others are 0 on rails as designed
}

WheelsetContact::WheelsetContact(const Parameters& parameters, const RailConditions& rail,
                                 std::shared_ptr<const ContactFinder> finder)
    : parameters_(parameters), hertz_(parameters.elasticity), creep_(rail), finder_(std::move(finder)) {}

void WheelsetContact::compute(const WheelsetMotion& motion, Contacts& out) const {
  const WheelsetPose pose{motion.q[kY], motion.q[kZ], motion.q[kRoll], motion.q[kYaw]};
  const CreepLaw& law = creep_.at(motion.location_m, motion.sanding);
  out.static_friction = law.parameters().friction.mu0;
  out.count = 0;
  std::array<ContactRegion, kMostContacts> regions;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const rail::RailOffset& rail = side == Side::kLeft ? motion.rails.left : motion.rails.right;
    const std::size_t found = finder_->find(side, motion.irregular ? seenFrom(rail, pose) : pose, regions);
    Contact* const first = &out.list[out.count];
    for (std::size_t i = 0; i < found; ++i) {
      first[i].side = side;
      first[i].region = regions[i];
      if (motion.irregular) moveWithRail(rail, motion.q[kY], first[i].region);
      placeContact(motion, parameters_.wheel_radius_m, first[i]);
      if (motion.irregular) turnWithRail(rail, motion, parameters_.wheel_radius_m, first[i]);
    }
    computeNormalForces(motion.v, first, found);
    for (std::size_t i = 0; i < found; ++i) computeCreep(motion, law, first[i]);
    out.of_wheel[static_cast<std::size_t>(side)] = found;
    out.count += found;
  }
}

void WheelsetContact::computeNormalForces(const Vector6& v, Contact* first, std::size_t count) const {
  double sum_N = 0.0;
  for (Contact* c = first; c != first + count; ++c) {
    const double delta = c->region.approach_m;
    c->elastic_N = c->region.share * hertz_.at(c->region.curvature).stiffness * delta * std::sqrt(delta);
    sum_N += c->elastic_N;
  }
  for (Contact* c = first; c != first + count; ++c) {
    const double damping = sum_N > 0.0 ? parameters_.normal_damping_N_s_per_m * c->elastic_N / sum_N : 0.0;
    c->normal_N = std::max(0.0, c->elastic_N - damping * c->J_n.dot(v));  // (W2)
  }
}

void WheelsetContact::computeCreep(const WheelsetMotion& motion, const CreepLaw& law, Contact& c) const {
  const Vector6& v = motion.v;
  c.slip_mps = Eigen::Vector2d(c.J_x.dot(v), c.J_t.dot(v)) + c.frame_mps;
  c.creep_N.setZero();
  c.slope_N_s_per_m.setZero();
  c.friction = 0.0;
  const double sin = std::sin(c.region.angle_rad), cos = std::cos(c.region.angle_rad);
  const double turning = v[kYaw] + v[kX] * motion.curvature_1pm;
  const double spin = cos * (turning + v[kPitch] * motion.q[kRoll]) - sin * v[kPitch];  // (W3)
  const double way = v[kX] < 0.0 ? -1.0 : 1.0;  // creep laws roll forward: going back, the frame is turned round
  c.creepage = computeCreepage({way * c.slip_mps.x(), way * c.slip_mps.y(), spin}, v[kX]);
  if (!(c.normal_N > 0.0)) return;

  const HertzTable::Contact hertz = hertz_.at(c.region.curvature);
  const double whole_N = c.normal_N / c.region.share, growth = std::cbrt(whole_N);
  c.a_m = hertz.a_unit * growth;
  c.b_m = hertz.b_unit * growth;
  const ContactPatch patch{c.a_m, c.b_m, whole_N, parameters_.shear_modulus_Pa, hertz.kalker};
  const CreepForce force = law.computeForce(patch, c.creepage);
  c.friction = force.friction;
  c.creep_N = way * c.region.share * Eigen::Vector2d(force.x_N, force.y_N);
  const double V = std::max(std::abs(v[kX]), kCreepageSpeedFloor_mps);
  const double straight = c.region.share * force.reduction * parameters_.shear_modulus_Pa * c.a_m * c.b_m / V;
  const double slip = c.creepage.slip_speed_mps;
  c.along = slip > 0.0 ? Eigen::Vector2d(c.slip_mps / slip) : Eigen::Vector2d(1.0, 0.0);
  const double xx = c.along.x() * c.along.x(), yy = c.along.y() * c.along.y();
  const double along = straight * (xx * hertz.kalker.c11 + yy * hertz.kalker.c22);
  const double across = straight * (yy * hertz.kalker.c11 + xx * hertz.kalker.c22);
  const double full_slip_N = c.friction * c.normal_N;
  c.slope_N_s_per_m = {along * relativeSlope(along * slip / full_slip_N),
                       slip > 0.0 ? std::min(across, full_slip_N / slip) : across};
}

double WheelsetContact::addForces(const Vector6& inertia, double h, Contacts& contacts, Vector6& load,
                                  const Shoes& shoes) {
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  Matrix6 system = Matrix6::Zero();
  system.diagonal() = inertia / h;
  for (std::size_t i = 0; i < contacts.count; ++i) {
    const Contact& c = contacts.list[i];
    system.selfadjointView<Eigen::Lower>().rankUpdate(alongSlip(c), c.slope_N_s_per_m.x());
    system.selfadjointView<Eigen::Lower>().rankUpdate(acrossSlip(c), c.slope_N_s_per_m.y());
    load += c.J_n * c.normal_N + c.J_x * c.creep_N.x() + c.J_t * c.creep_N.y();  // (W4)
  }
  const auto solver = system.selfadjointView<Eigen::Lower>().llt();
  Vector6 change = solver.solve(load);  // v_n+1 - v_n
  double shoe_N_m = shoes.largest_N_m > 0.0 ? addShoeTorque(solver, shoes, change) : 0.0;
  bool slides = false;
  for (std::size_t i = 0; i < contacts.count; ++i) {
    Contact& c = contacts.list[i];
    const double along_N = -c.slope_N_s_per_m.x() * alongSlip(c).dot(change);  // (W5)
    const double across_N = -c.slope_N_s_per_m.y() * acrossSlip(c).dot(change);
    const Eigen::Vector2d implicit = along_N * c.along + across_N * Eigen::Vector2d(-c.along.y(), c.along.x());
    const Eigen::Vector2d before = c.creep_N;
    c.creep_N = withinFriction(before + implicit, c.friction * c.normal_N);
    slides = slides || c.creep_N != before + implicit;
    const Eigen::Vector2d added = c.creep_N - before;
    load += c.J_x * added.x() + c.J_t * added.y();
  }
  // The straight lines asked the shoes for more than mu N can turn: beyond it they would turn the wheel backwards.
  if (slides && shoes.largest_N_m > 0.0)
    shoe_N_m = computeHoldingForce(shoes.turning_radps * inertia[kPitch] / h + load[kPitch], shoes.largest_N_m);
  load[kPitch] += shoe_N_m;
  return shoe_N_m;
}

WheelsetContact::Work WheelsetContact::computeWork(const Contacts& contacts, const Vector6& v_mean, double h) {
  Work work;
  for (std::size_t i = 0; i < contacts.count; ++i) {
    const Contact& c = contacts.list[i];
    const Eigen::Vector2d slip(c.J_x.dot(v_mean), c.J_t.dot(v_mean));
    const double leaving = c.J_n.dot(v_mean);
    work.slip -= h * c.creep_N.dot(slip + c.frame_mps);
    work.damping -= h * (c.normal_N - c.elastic_N) * leaving;
    work.elastic -= h * c.elastic_N * leaving;
    work.on_body += h * (c.creep_N.dot(slip) + c.normal_N * leaving);
  }
  return work;
}

}  // namespace loco
