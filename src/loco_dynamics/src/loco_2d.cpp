#include "loco_dynamics/loco_2d.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "loco_dynamics/axle_step.hpp"
#include "loco_dynamics/contact/creepage.hpp"
#include "rail_core/constants.hpp"

namespace loco {

namespace {

using Eigen::Vector3d;

const std::vector<Dof> kPlanarDofs = {kX, kZ, kPitch};

void setZero(BodyVector& x) {
  for (auto& body : x) body.setZero();
}

}  // namespace

Loco2d::Loco2d(const Parameters& parameters)
    : parameters_(parameters),
      dynamics_(BodyLayout(parameters.structure.bodies, kPlanarDofs), parameters.structure.suspension),
      contact_(parameters.contact, parameters.rail),
      drive_(parameters.structure, parameters.control, parameters.adhesion_limit, parameters.micro_step) {
  dynamics_.setRest(computeEquilibrium());
}

std::size_t Loco2d::stateSize() const { return dynamics_.stateSize() + drive_.stateSize(); }

/// At rest at chainage 0; nothing of it depends on the place.
BodyVector Loco2d::computeEquilibrium() const {
  BodyState state;
  dynamics_.unpack(std::vector<double>(dynamics_.stateSize(), 0.0).data(), state);
  const auto n = static_cast<Eigen::Index>(dynamics_.layout().size());
  const auto loadsAt = [&](const BodyState& at) {
    BodyState copy = at;
    BodyVector loads;
    setZero(loads);
    dynamics_.addInnerForces(copy, 1.0, loads);
    Eigen::VectorXd flat(n);
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {
      if (i >= BodyLayout::wheelset(0)) loads[i][kZ] += 2.0 * contact_.computeNormalForce(-at.q[i][kZ], 0.0);
      for (const Dof dof : kPlanarDofs) flat[row++] = loads[i][static_cast<Eigen::Index>(dof)];
    }
    return flat;
  };
  const double wheel_N = dynamics_.layout().totalMass() * rail::kGravity_mps2 / (2.0 * BodyLayout::kAxles);
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle)
    state.q[BodyLayout::wheelset(axle)][kZ] = -contact_.computeApproach(wheel_N);
  for (int iteration = 0; iteration < 20; ++iteration) {  // Newton's method; only the contacts are not linear
    const Eigen::VectorXd loads = loadsAt(state);
    if (loads.cwiseAbs().maxCoeff() < 1e-6) break;
    Eigen::MatrixXd jacobian(n, n);
    Eigen::Index column = 0;
    for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {
      for (const Dof dof : kPlanarDofs) {
        constexpr double kStep = 1e-8;
        BodyState moved = state;
        moved.q[i][static_cast<Eigen::Index>(dof)] += kStep;
        jacobian.col(column++) = (loadsAt(moved) - loads) / kStep;
      }
    }
    // The locomotive may stand anywhere and its wheels at any angle: of all solutions the shortest.
    const Eigen::VectorXd step = jacobian.completeOrthogonalDecomposition().solve(-loads);
    column = 0;
    for (std::size_t i = 0; i < BodyLayout::kBodies; ++i)
      for (const Dof dof : kPlanarDofs) state.q[i][static_cast<Eigen::Index>(dof)] += step[column++];
  }
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) state.q[BodyLayout::wheelset(axle)][kPitch] = 0.0;
  return state.q;
}

LocoStart Loco2d::equilibriumState(double location_m, double speed_mps) const {
  const BodyState state = dynamics_.rollingState(location_m, speed_mps, parameters_.structure.wheel_radius_m);
  std::vector<double> flat(dynamics_.stateSize());
  dynamics_.pack(state, flat.data());
  const std::vector<double> control = drive_.initialState();
  flat.insert(flat.end(), control.begin(), control.end());
  return {std::move(flat), {}};
}

void Loco2d::step(const std::vector<double>& state, const LocoForce& force, LocoTraction& answer) {
  assert(state.size() == stateSize());
  const auto micro_steps = static_cast<int>(force.step_length / parameters_.micro_step);
  const double h = rail::toSeconds(parameters_.micro_step);
  dynamics_.unpack(state.data(), state_);
  answer.state = state;
  double* const control_state = answer.state.data() + dynamics_.stateSize();
  answer.step = force.step;
  answer.traction_N = answer.work_rim_J = answer.work_slip_J = answer.work_shoes_J = 0.0;
  answer.failure.clear();
  account_ = {};
  account_.kinetic = -dynamics_.computeKineticEnergy(state_.v);
  account_.stored = -storedEnergy();
  for (int i = 0; i < micro_steps; ++i) {
    BodyVector loads;
    setZero(loads);
    dynamics_.addInnerForces(state_, h, loads);
    addOuterForces(force, loads);
    drive_.addTorques(force, state_.v, control_state, loads);
    addContactForces(force, h, loads);
    const BodyVector v_old = state_.v;
    answer.failure = dynamics_.step(loads, h, state_);
    if (!answer.failure.empty()) return;
    book(force, v_old, h, answer);
  }
  answer.traction_N /= micro_steps;
  account_.kinetic += dynamics_.computeKineticEnergy(state_.v);
  account_.stored += storedEnergy();
  report(answer.adhesion);
  dynamics_.pack(state_, answer.state.data());
  answer.speed_mps = dynamics_.centreOfGravity(state_.v);
  answer.location_m = dynamics_.centreOfGravity(state_.q);
}

std::vector<BodyPose> Loco2d::computePoses(const std::vector<double>& state) const {
  return dynamics_.computePoses(state.data());
}

void Loco2d::addOuterForces(const LocoForce& force, BodyVector& loads) const {
  const LocoStructure& s = parameters_.structure;
  const double z = s.coupler_z_m - s.bodies[BodyLayout::kCar].p_T.z();
  auto& car = loads[BodyLayout::kCar];
  addForce(car, {force.coupler_front_N, 0.0, 0.0}, {s.coupler_x_m, 0.0, z});
  addForce(car, {force.coupler_rear_N, 0.0, 0.0}, {-s.coupler_x_m, 0.0, z});
  car[kX] += force.propulsion_resistance_N + force.curving_resistance_N;
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i)
    loads[i][kX] += force.grade_N * (s.bodies[i].mass_kg / dynamics_.layout().totalMass());
}

void Loco2d::addContactForces(const LocoForce& force, double h, BodyVector& loads) {
  const double r = parameters_.structure.wheel_radius_m;
  const double largest_shoe_N_m = force.shoe_force_N * r / BodyLayout::kAxles;
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    const std::size_t i = BodyLayout::wheelset(axle);
    Axle& a = axles_[axle];
    const double approach = -state_.q[i][kZ];
    a.normal_N = contact_.computeNormalForce(approach, -state_.v[i][kZ]);
    a.damping_normal_N = a.normal_N - contact_.computeNormalForce(approach, 0.0);
    a.v_mps = state_.v[i][kX];
    a.slip_mps = state_.v[i][kPitch] * r - a.v_mps;
    const double location_m = state_.q[i][kX] + parameters_.structure.bodies[i].p_T.x();
    a.contact = contact_.computeAxleForce(a.normal_N, a.slip_mps, a.v_mps, location_m, force.sanding);
    const AxleStep step{h,
                        r,
                        dynamics_.layout().inertia(i, kX),
                        dynamics_.layout().inertia(i, kPitch),
                        loads[i][kX],
                        a.contact.force_N,
                        std::max(a.contact.slope_N_s_per_m, 0.0),
                        2.0 * a.contact.friction * a.normal_N};
    auto& frame = loads[BodyLayout::bogieOfAxle(axle)];
    const double turning_radps = state_.v[i][kPitch] - state_.v[BodyLayout::bogieOfAxle(axle)][kPitch];
    a.shoe_N_m = step.shoeTorque(loads[i][kPitch], turning_radps, largest_shoe_N_m);
    loads[i][kPitch] += a.shoe_N_m;
    frame[kPitch] -= a.shoe_N_m;  // the shoes hang on the frame
    a.force_N = step.creepForce(loads[i][kPitch]);
    loads[i][kZ] += 2.0 * a.normal_N;
    loads[i][kX] += a.force_N;
    loads[i][kPitch] -= a.force_N * r;
  }
}

void Loco2d::report(AdhesionReport& out) const {
  out.axles.resize(BodyLayout::kAxles);
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    const Axle& a = axles_[axle];
    AxleAdhesion& to = out.axles[axle];
    to.creep = a.slip_mps / std::max(a.v_mps, kCreepageSpeedFloor_mps);
    to.normal_force_N = 2.0 * a.normal_N;
    to.force_N = a.force_N;
    to.adhesion = to.normal_force_N > 0.0 ? a.force_N / to.normal_force_N : 0.0;
    to.friction = a.contact.friction;
    to.static_friction = a.contact.static_friction;
    to.torque_reference_N_m = drive_.torqueReference_N_m(axle);
    to.torque_N_m = drive_.torque_N_m(axle);
    to.shoe_torque_N_m = a.shoe_N_m;
    to.controlled = drive_.controlled(axle);
    to.frictional_power_W = a.slip_power_W;
    to.t_gamma_N = std::abs(a.force_N * a.slip_mps) / std::max(std::abs(a.v_mps), kCreepageSpeedFloor_mps);
    to.vertical_force_N[0] = to.vertical_force_N[1] = a.normal_N;
  }
}

double Loco2d::storedEnergy() const {
  double energy = dynamics_.computeStoredEnergy(state_);
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle)
    energy += 2.0 * contact_.computeStoredEnergy(-state_.q[BodyLayout::wheelset(axle)][kZ]);
  return energy;
}

void Loco2d::book(const LocoForce& force, const BodyVector& v_old, double h, LocoTraction& answer) {
  const double r = parameters_.structure.wheel_radius_m;
  BodyVector v_mean;
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) v_mean[i] = 0.5 * (v_old[i] + state_.v[i]);
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    const auto& v = v_mean[BodyLayout::wheelset(axle)];
    const double slip_work = axles_[axle].force_N * (v[kPitch] * r - v[kX]) * h;
    answer.traction_N += axles_[axle].force_N;
    answer.work_slip_J += slip_work;
    account_.slip += slip_work;
    axles_[axle].slip_power_W = slip_work / h;
    const double shoe_turning = v[kPitch] - v_mean[BodyLayout::bogieOfAxle(axle)][kPitch];
    const double shoe_work = -axles_[axle].shoe_N_m * shoe_turning * h;
    answer.work_shoes_J += shoe_work;
    account_.shoes += shoe_work;
    account_.contact_damping -= 2.0 * axles_[axle].damping_normal_N * v[kZ] * h;
  }
  const TractionDrive::Work work = drive_.computeWork(v_mean, h);
  answer.work_rim_J += work.rims;
  account_.motors += work.motors;
  const LocoStructure& s = parameters_.structure;
  const double z = s.coupler_z_m - s.bodies[BodyLayout::kCar].p_T.z();
  const double coupler_speed = v_mean[BodyLayout::kCar][kX] + v_mean[BodyLayout::kCar][kPitch] * z;
  account_.outer += (force.coupler_front_N + force.coupler_rear_N) * coupler_speed * h;
  account_.outer += (force.propulsion_resistance_N + force.curving_resistance_N) * v_mean[BodyLayout::kCar][kX] * h;
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i)
    account_.outer += force.grade_N * (s.bodies[i].mass_kg / dynamics_.layout().totalMass()) * v_mean[i][kX] * h;
  account_.dampers += dynamics_.computeDampingWork(v_old, state_.v, h);
}

}  // namespace loco
