#include "loco_dynamics/loco_2d.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "rail_core/constants.hpp"

namespace loco {

namespace {

using Eigen::Vector3d;

const std::vector<Dof> kPlanarDofs = {kX, kZ, kPitch};

adhesion::Setup controllerSetup(const Loco2d::Parameters& parameters) {
  adhesion::Setup setup;
  setup.micro_step = parameters.micro_step;
  setup.wheel_radius_m = parameters.structure.wheel_radius_m;
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle)
    setup.bogie_of_axle.push_back(axle / BodyLayout::kAxlesPerBogie);
  return setup;
}

void setZero(BodyVector& x) {
  for (auto& body : x) body.setZero();
}

}  // namespace

Loco2d::Loco2d(const Parameters& parameters)
    : parameters_(parameters),
      dynamics_(BodyLayout(parameters.structure.bodies, kPlanarDofs), parameters.structure.suspension),
      contact_(parameters.contact, parameters.creep),
      controller_(adhesion::makeController(parameters.control, controllerSetup(parameters))),
      torque_limit_{parameters.structure.wheel_radius_m, parameters.structure.totalMass(),
                    static_cast<int>(BodyLayout::kAxles), parameters.adhesion_limit},
      measurements_(BodyLayout::kAxles),
      commands_(BodyLayout::kAxles) {}

std::size_t Loco2d::stateSize() const { return dynamics_.stateSize() + controller_->stateSize(); }

std::vector<double> Loco2d::equilibriumState(double location_m, double speed_mps) const {
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
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {
    state.q[i][kX] += location_m;
    state.v[i][kX] = speed_mps;
    if (i >= BodyLayout::wheelset(0)) {
      state.q[i][kPitch] = 0.0;
      state.v[i][kPitch] = speed_mps / parameters_.structure.wheel_radius_m;
    }
  }
  std::vector<double> flat(dynamics_.stateSize());
  dynamics_.pack(state, flat.data());
  const std::vector<double> control = controller_->initialState();
  flat.insert(flat.end(), control.begin(), control.end());
  return flat;
}

void Loco2d::step(const std::vector<double>& state, const LocoForce& force, LocoTraction& answer) {
  assert(state.size() == stateSize());
  const auto micro_steps = static_cast<int>(force.step_length / parameters_.micro_step);
  const double h = rail::toSeconds(parameters_.micro_step);
  dynamics_.unpack(state.data(), state_);
  answer.state = state;
  double* const control_state = answer.state.data() + dynamics_.stateSize();
  answer.step = force.step;
  answer.traction_N = answer.work_rim_J = answer.work_slip_J = 0.0;
  answer.failure.clear();
  account_ = {};
  account_.kinetic = -dynamics_.computeKineticEnergy(state_.v);
  account_.stored = -storedEnergy();
  for (int i = 0; i < micro_steps; ++i) {
    BodyVector loads;
    setZero(loads);
    dynamics_.addInnerForces(state_, h, loads);
    addOuterForces(force, loads);
    addTorques(force, force.speed_mps, control_state, loads);
    addContactForces(h, loads);
    const BodyVector v_old = state_.v;
    answer.failure = dynamics_.step(loads, h, state_);
    if (!answer.failure.empty()) return;
    book(force, v_old, h, answer);
  }
  answer.traction_N /= micro_steps;
  account_.kinetic += dynamics_.computeKineticEnergy(state_.v);
  account_.stored += storedEnergy();
  dynamics_.pack(state_, answer.state.data());
  answer.speed_mps = dynamics_.centreOfGravity(state_.v);
  answer.location_m = dynamics_.centreOfGravity(state_.q);
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

void Loco2d::addTorques(const LocoForce& force, double v_train_mps, double* control_state, BodyVector& loads) {
  const double reference_N_m = adhesion::computeTorqueReference(torque_limit_, force.traction_reference_N);
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    const double omega = state_.v[BodyLayout::wheelset(axle)][kPitch];
    measurements_[axle].omega_radps = omega;
    measurements_[axle].torque_reference_N_m =
        parameters_.control.rim_power_limit
            ? adhesion::limitRimPower(torque_limit_, reference_N_m, omega, force.rim_power_limit_W)
            : reference_N_m;
  }
  controller_->step(v_train_mps, measurements_, control_state, commands_);
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    const double T = commands_[axle].torque_N_m;
    loads[BodyLayout::wheelset(axle)][kPitch] += T;
    loads[BodyLayout::bogieOfAxle(axle)][kPitch] -= T;
    axles_[axle].torque_N_m = T;
    axles_[axle].reference_N_m = measurements_[axle].torque_reference_N_m;
    axles_[axle].controlled = commands_[axle].active;
  }
}

void Loco2d::addContactForces(double h, BodyVector& loads) {
  const double r = parameters_.structure.wheel_radius_m;
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    const std::size_t i = BodyLayout::wheelset(axle);
    const double approach = -state_.q[i][kZ];
    const double N = contact_.computeNormalForce(approach, -state_.v[i][kZ]);
    damping_normal_N_[axle] = N - contact_.computeNormalForce(approach, 0.0);
    const double v = state_.v[i][kX];
    const double w = state_.v[i][kPitch] * r - v;
    const PlanarContact::AxleForce creep = contact_.computeAxleForce(N, w, v);
    // Linearly implicit in w where the force rises with it: creep is stiff at low speed and with clean rail.     (P2)
    const double m = dynamics_.layout().inertia(i, kX), J = dynamics_.layout().inertia(i, kPitch);
    const double slope = std::max(creep.slope_N_s_per_m, 0.0);
    const double free_rate = r * loads[i][kPitch] / J - loads[i][kX] / m;  // dw/dt without the contact
    const double F = (creep.force_N + slope * h * free_rate) / (1.0 + slope * h * (r * r / J + 1.0 / m));
    loads[i][kZ] += 2.0 * N;
    loads[i][kX] += F;
    loads[i][kPitch] -= F * r;
    axles_[axle].normal_N = 2.0 * N;
    axles_[axle].force_N = F;
    axles_[axle].slip_mps = w;
    axles_[axle].creep = w / std::max(v, 0.5);
    axles_[axle].friction = creep.friction;
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
  const auto mean = [&](std::size_t body, Dof dof) {
    const auto k = static_cast<Eigen::Index>(dof);
    return 0.5 * (v_old[body][k] + state_.v[body][k]);
  };
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    const std::size_t i = BodyLayout::wheelset(axle);
    const double omega = mean(i, kPitch);
    const double slip_work = axles_[axle].force_N * (omega * r - mean(i, kX)) * h;
    answer.traction_N += axles_[axle].force_N;
    answer.work_rim_J += axles_[axle].torque_N_m * omega * h;
    answer.work_slip_J += slip_work;
    account_.slip += slip_work;
    account_.motors += axles_[axle].torque_N_m * (omega - mean(BodyLayout::bogieOfAxle(axle), kPitch)) * h;
    account_.contact_damping -= 2.0 * damping_normal_N_[axle] * mean(i, kZ) * h;
  }
  const LocoStructure& s = parameters_.structure;
  const double z = s.coupler_z_m - s.bodies[BodyLayout::kCar].p_T.z();
  const double coupler_speed = mean(BodyLayout::kCar, kX) + mean(BodyLayout::kCar, kPitch) * z;
  account_.outer += (force.coupler_front_N + force.coupler_rear_N) * coupler_speed * h;
  account_.outer += (force.propulsion_resistance_N + force.curving_resistance_N) * mean(BodyLayout::kCar, kX) * h;
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i)
    account_.outer += force.grade_N * (s.bodies[i].mass_kg / dynamics_.layout().totalMass()) * mean(i, kX) * h;
  account_.dampers += dynamics_.computeDampingWork(v_old, state_.v, h);
}

}  // namespace loco
