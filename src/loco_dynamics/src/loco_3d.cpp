#include "loco_dynamics/loco_3d.hpp"

#include <algorithm>
#include <cassert>

#include "loco_dynamics/frame_forces.hpp"
#include "rail_core/constants.hpp"

namespace loco {

namespace {

using Eigen::Vector3d;

const std::vector<Dof> kAllDofs = {kX, kY, kZ, kRoll, kPitch, kYaw};

void setZero(BodyVector& x) {
  for (auto& body : x) body.setZero();
}

/// Work of forces in a step of length h with these mean velocities.
double workOf(const BodyVector& loads, const BodyVector& v_mean, double h) {
  double power_W = 0.0;
  for (std::size_t i = 0; i < loads.size(); ++i) power_W += loads[i].dot(v_mean[i]);
  return power_W * h;
}

}  // namespace

Loco3d::Loco3d(const Parameters& parameters)
    : parameters_(parameters),
      dynamics_(BodyLayout(parameters.structure.bodies, kAllDofs), parameters.structure.suspension),
      contact_(parameters.contact, parameters.rail, parameters.finder),
      drive_(parameters.structure, parameters.control, parameters.adhesion_limit, parameters.micro_step),
      frames_(dynamics_.layout(), parameters_.track.get()),
      next_frames_(frames_) {
  dynamics_.setRest(computeRest());
}

std::size_t Loco3d::stateSize() const { return dynamics_.stateSize() + drive_.stateSize() + 2 * BodyLayout::kAxles; }

void Loco3d::step(const std::vector<double>& state, const LocoForce& force, LocoTraction& answer) {
  assert(state.size() == stateSize());
  const auto micro_steps = static_cast<int>(force.step_length / parameters_.micro_step);
  const double h = rail::toSeconds(parameters_.micro_step);
  dynamics_.unpack(state.data(), state_);
  answer.state = state;
  double* const control_state = answer.state.data() + dynamics_.stateSize();
  double* const time_in_air_s = control_state + drive_.stateSize();
  answer.step = force.step;
  answer.traction_N = answer.work_rim_J = answer.work_slip_J = answer.work_shoes_J = 0.0;
  answer.failure.clear();
  frames_.place(state_.q);
  frames_.computeGaps(state_.v);
  account_ = {};
  account_.kinetic = -dynamics_.computeKineticEnergy(state_.v);
  account_.stored = -dynamics_.computeStoredEnergy(state_, placement());
  for (int i = 0; i < micro_steps && answer.failure.empty(); ++i) {
    answer.failure = stepMicro(force, control_state, h, answer);
    if (answer.failure.empty()) answer.failure = checkWheels(state_, frames_, contacts_, h, time_in_air_s);
  }
  if (!answer.failure.empty()) return;
  answer.traction_N /= micro_steps;
  account_.kinetic += dynamics_.computeKineticEnergy(state_.v);
  account_.stored += dynamics_.computeStoredEnergy(state_, placement());
  report(answer.adhesion);
  dynamics_.pack(state_, answer.state.data());
  answer.speed_mps = dynamics_.centreOfGravity(state_.v);
  answer.location_m = dynamics_.centreOfGravity(state_.q);
}

/// One micro step from state_ and frames_, which hold those of its end afterwards.
std::string Loco3d::stepMicro(const LocoForce& force, double* control_state, double h, LocoTraction& answer) {
  setZero(scratch_.inner);
  setZero(scratch_.outer);
  setZero(scratch_.frame);
  dynamics_.addInnerForces(state_, h, scratch_.inner, placement());
  addOuterForces(force, frames_, state_.q, scratch_.outer);
  addFrameForces(dynamics_.layout(), frames_, state_.v, parameters_.structure.spin_momentum_inertia_kg_m2,
                 scratch_.frame);
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i)
    scratch_.loads[i] = scratch_.inner[i] + scratch_.outer[i] + scratch_.frame[i];
  drive_.addTorques(force, state_.v, control_state, scratch_.loads);
  addContactForces(force, h);
  addTurning(h);
  const BodyVector v_old = state_.v;
  std::string failure = dynamics_.step(scratch_.loads, h, state_);
  if (!failure.empty()) return failure;
  book(v_old, h, answer);
  std::swap(frames_, next_frames_);
  frames_.computeGaps(state_.v);
  return {};
}

void Loco3d::addOuterForces(const LocoForce& force, const TrackFrames& frames, const BodyVector& q,
                            BodyVector& loads) const {
  const LocoStructure& s = parameters_.structure;
  const double z = s.coupler_z_m - s.bodies[BodyLayout::kCar].p_T.z();
  auto& car = loads[BodyLayout::kCar];
  for (const double side : {1.0, -1.0}) {  // front, rear
    const double F = side > 0.0 ? force.coupler_front_N : force.coupler_rear_N;
    Vector3d r(side * s.coupler_x_m, 0.0, z);
    if (parameters_.gravity_stiffness) r.head<2>() += q[BodyLayout::kCar].tail<3>().cross(r).head<2>();
    addForce(car, {F, F * frames.headingFromCar(side * s.coupler_x_m), 0.0}, r);  // along the tangent at the coupler
  }
  car[kX] += force.propulsion_resistance_N + force.curving_resistance_N;
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i)
    loads[i][kX] += force.grade_N * (s.bodies[i].mass_kg / dynamics_.layout().totalMass());
}

WheelsetMotion Loco3d::motionOf(std::size_t axle, const BodyState& state, const TrackFrames& frames) const {
  const std::size_t i = BodyLayout::wheelset(axle);
  return {state.q[i], state.v[i], frames[i].curvature_1pm, frames[i].s_m, frames[i].irregular, frames[i].rails};
}

Vector6 Loco3d::inertiaOf(std::size_t axle) const {
  Vector6 inertia;
  for (const Dof dof : kAllDofs)
    inertia[static_cast<Eigen::Index>(dof)] = dynamics_.layout().inertia(BodyLayout::wheelset(axle), dof);
  return inertia;
}

void Loco3d::addContactForces(const LocoForce& force, double h) {
  const double largest_shoe_N_m = force.shoe_force_N * parameters_.structure.wheel_radius_m / BodyLayout::kAxles;
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    const std::size_t i = BodyLayout::wheelset(axle);
    WheelsetMotion motion = motionOf(axle, state_, frames_);
    motion.sanding = force.sanding;
    contact_.compute(motion, contacts_[axle]);
    const std::size_t frame = BodyLayout::bogieOfAxle(axle);
    const WheelsetContact::Shoes shoes{largest_shoe_N_m, state_.v[i][kPitch] - state_.v[frame][kPitch]};
    shoe_N_m_[axle] = WheelsetContact::addForces(inertiaOf(axle), h, contacts_[axle], scratch_.loads[i], shoes);
    scratch_.loads[frame][kPitch] -= shoe_N_m_[axle];  // the shoes hang on the frame
  }
}

/// Places the frames of the step's end, which the forces along the track decide, and adds what their turning takes.
void Loco3d::addTurning(double h) {
  BodyVector v_next = state_.v, q_next = state_.q;
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {
    v_next[i][kX] += h * scratch_.loads[i][kX] / dynamics_.layout().inertia(i, kX);
    q_next[i][kX] += h * v_next[i][kX];
  }
  next_frames_.place(q_next);
  BodyVector turning;
  setZero(turning);
  addTurningForces(dynamics_.layout(), frames_, next_frames_, state_.v, v_next, h, turning);
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {
    scratch_.frame[i] += turning[i];
    scratch_.loads[i] += turning[i];
  }
}

void Loco3d::book(const BodyVector& v_old, double h, LocoTraction& answer) {
  BodyVector v_mean;
  double weight_J = 0.0;
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {
    v_mean[i] = 0.5 * (v_old[i] + state_.v[i]);
    weight_J -= dynamics_.layout().bodies()[i].mass_kg * rail::kGravity_mps2 * v_mean[i][kZ] * h;
  }
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    const WheelsetContact::Contacts& contacts = contacts_[axle];
    for (std::size_t i = 0; i < contacts.count; ++i) answer.traction_N += contacts.list[i].alongTrack_N();
    const WheelsetContact::Work work = WheelsetContact::computeWork(contacts, v_mean[BodyLayout::wheelset(axle)], h);
    answer.work_slip_J += work.slip;
    account_.slip += work.slip;
    const double shoe_turning =
        v_mean[BodyLayout::wheelset(axle)][kPitch] - v_mean[BodyLayout::bogieOfAxle(axle)][kPitch];
    const double shoe_work = -shoe_N_m_[axle] * shoe_turning * h;
    answer.work_shoes_J += shoe_work;
    account_.shoes += shoe_work;
    account_.contact_damping += work.damping;
    account_.stored += work.elastic;
    account_.frames += work.on_body + work.slip + work.damping + work.elastic;
  }
  const TractionDrive::Work drive = drive_.computeWork(v_mean, h);
  answer.work_rim_J += drive.rims;
  account_.motors += drive.motors;
  account_.outer += workOf(scratch_.outer, v_mean, h);
  account_.frames += workOf(scratch_.frame, v_mean, h);
  account_.frames +=
      workOf(scratch_.inner, v_mean, h) - weight_J - dynamics_.computeElementWork(v_mean, h, placement());
  account_.dampers += dynamics_.computeDampingWork(v_old, state_.v, h, placement());
}

std::string Loco3d::checkWheels(const BodyState& state, const TrackFrames& frames, const ContactsOfAxles& contacts,
                                double h, double* time_in_air_s) const {
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    const std::size_t i = BodyLayout::wheelset(axle);
    std::string failure = parameters_.safety.check(parameters_.structure.bodies[i].name, frames[i].s_m,
                                                   parameters_.structure.wheel_radius_m, state.q[i][kZ], h,
                                                   contacts[axle], time_in_air_s + 2 * axle);
    if (!failure.empty()) return failure;
  }
  return {};
}

}  // namespace loco
