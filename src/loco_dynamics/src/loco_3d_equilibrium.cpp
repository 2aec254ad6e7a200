// Where a 3D locomotive starts: quasi-static equilibrium on its place of the track.

#include <algorithm>

#include "loco_dynamics/frame_forces.hpp"
#include "loco_dynamics/loco_3d.hpp"
#include "rail_core/constants.hpp"
#include "rail_core/message_number.hpp"

namespace loco {

namespace {

constexpr double kForEver_s = 1e12;  ///< a step after which a yaw damper has no force

/// Takes from the forces along the track what slows all bodies down together.
void shareDeceleration(const BodyLayout& layout, BodyVector& loads) {
  double sum_N = 0.0;
  for (const auto& load : loads) sum_N += load[kX];
  for (std::size_t i = 0; i < loads.size(); ++i)
    loads[i][kX] -= sum_N * layout.bodies()[i].mass_kg / layout.totalMass();
}

std::string placed(double location_m, double speed_mps) {
  return "cannot start at " + rail::fixedNumber(location_m / rail::kMetresPerKilometre, 6) + " km with " +
         rail::messageNumber(speed_mps) + " m/s: ";
}

}  // namespace

/// Everything but the contacts; the yaw dampers have come to rest.
/// @param share  of what the frames' turning and tilt do to the bodies, (K1) and (K2)
BodyVector Loco3d::computeSteadyLoads(const BodyState& state, const TrackFrames& frames, double share) const {
  BodyState copy = state;
  BodyVector loads;
  for (auto& load : loads) load.setZero();
  dynamics_.addInnerForces(copy, kForEver_s, loads, {&frames.gaps(), parameters_.gravity_stiffness});
  BodyVector turning;
  for (auto& load : turning) load.setZero();
  addFrameForces(dynamics_.layout(), frames, state.v, parameters_.structure.spin_momentum_inertia_kg_m2, turning);
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) loads[i] += share * turning[i];
  return loads;
}

BodyVector Loco3d::computeStaticLoads(const BodyState& state) const { return computeStaticLoads(state, frames_); }

BodyVector Loco3d::computeStaticLoads(const BodyState& state, TrackFrames frames) const {
  frames.place(state.q);
  frames.computeGaps(state.v);
  BodyVector loads = computeSteadyLoads(state, frames);
  WheelsetContact::Contacts contacts;
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    contact_.compute(motionOf(axle, state, frames), contacts);
    for (std::size_t i = 0; i < contacts.count; ++i) {
      const WheelsetContact::Contact& c = contacts.list[i];
      loads[BodyLayout::wheelset(axle)] += c.J_n * c.normal_N + c.J_x * c.creep_N.x() + c.J_t * c.creep_N.y();
    }
  }
  shareDeceleration(dynamics_.layout(), loads);
  return loads;
}

/// Moves bogies and car sideways to where the track has the bodies that carry them.
void Loco3d::followTrack(BodyState& state) const {
  TrackFrames frames = frames_;
  frames.place(state.q);
  frames.computeGaps(state.v);
  const auto& bodies = dynamics_.layout().bodies();
  double car_m = 0.0;
  for (std::size_t i = 0; i < BodyLayout::kBogies; ++i) {
    const std::size_t bogie = BodyLayout::bogie(i);
    double mean_m = 0.0;
    for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle)
      if (BodyLayout::bogieOfAxle(axle) == bogie)
        mean_m += frames.gaps()[gapIndex(BodyLayout::wheelset(axle), bogie)].at.lateral_m / BodyLayout::kAxlesPerBogie;
    state.q[bogie][kY] += mean_m;
    const FrameGap::Parts& gap = frames.gaps()[gapIndex(BodyLayout::kCar, bogie)].at;
    car_m += (mean_m - gap.lateral_m - gap.heading_rad * bodies[bogie].p_T.x()) / BodyLayout::kBogies;
  }
  state.q[BodyLayout::kCar][kY] += car_m;
}

/// One step on the spot, over track that stays as it is there. @return empty, or what takes it off the track
std::string Loco3d::settleStep(BodyState& state, double share, double h, ContactsOfAxles& contacts,
                               double* time_in_air_s) const {
  TrackFrames frames = frames_;
  frames.place(state.q);
  frames.computeGaps(state.v);
  BodyVector loads = computeSteadyLoads(state, frames, share);
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    contact_.compute(motionOf(axle, state, frames), contacts[axle]);
    WheelsetContact::addForces(inertiaOf(axle), h, contacts[axle], loads[BodyLayout::wheelset(axle)], {});
  }
  shareDeceleration(dynamics_.layout(), loads);
  const std::string failure = checkWheels(state, frames, contacts, h, time_in_air_s);
  return failure.empty() ? dynamics_.step(loads, h, state) : failure;
}

/// Lets the bodies move on the spot until damping has brought them near the equilibrium that running would bring them
/// to: there may be others, with a wheel up on its flange. @return empty, or what takes it off the track
std::string Loco3d::settle(BodyState& state, double speed_mps) const {
  constexpr double kGrowth_s = 2.0;    // chosen: a sudden push would lift wheels that stay down; the sway takes 1.6 s
  constexpr double kSettling_s = 5.0;  // chosen: when the push is whole, the slowest sway falls to a quarter
  constexpr double kStep_s = 5e-4;
  ContactsOfAxles contacts;
  std::array<double, 2 * BodyLayout::kAxles> time_in_air_s{};
  for (int i = 0; i < static_cast<int>(kSettling_s / kStep_s); ++i) {
    const double share = std::min(1.0, i * kStep_s / kGrowth_s);
    const std::string failure = settleStep(state, share, kStep_s, contacts, time_in_air_s.data());
    if (!failure.empty()) return failure;
    for (auto& q : state.q) q[kX] -= kStep_s * speed_mps;
  }
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {
    const double omega = state.v[i][kPitch];
    state.v[i].setZero();
    state.v[i][kX] = speed_mps;
    if (i < BodyLayout::wheelset(0)) continue;
    state.v[i][kPitch] = omega;
    state.q[i][kPitch] = 0.0;
  }
  return {};
}

/// What takes a locomotive off the track that stands in this equilibrium: what is without load stays so.
std::string Loco3d::checkStanding(const BodyState& state, TrackFrames frames) const {
  frames.place(state.q);
  ContactsOfAxles contacts;
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle)
    contact_.compute(motionOf(axle, state, frames), contacts[axle]);
  std::array<double, 2 * BodyLayout::kAxles> time_in_air_s{};
  return checkWheels(state, frames, contacts, 2.0 * parameters_.safety.lift_time_s, time_in_air_s.data());
}

/// Lowers each wheelset until its wheels carry its share of the weight, by halving.
void Loco3d::placeWheelsets(BodyState& state) const {
  const double axle_N = dynamics_.layout().totalMass() * rail::kGravity_mps2 / BodyLayout::kAxles;
  WheelsetContact::Contacts contacts;
  for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
    double low_m = -2e-3, high_m = 2e-3;
    for (int i = 0; i < 50; ++i) {
      double& z_m = state.q[BodyLayout::wheelset(axle)][kZ] = 0.5 * (low_m + high_m);
      contact_.compute(motionOf(axle, state, frames_), contacts);
      double sum_N = 0.0;
      for (std::size_t k = 0; k < contacts.count; ++k) sum_N += contacts.list[k].force_N().z();
      (sum_N > axle_N ? low_m : high_m) = z_m;
    }
  }
}

bool Loco3d::onStraightTrack(const BodyState& state) const {
  TrackFrames frames = frames_;
  frames.place(state.q);
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i)
    if (frames[i].curvature_1pm != 0.0 || frames[i].roll_rad != 0.0 || frames[i].irregular) return false;
  return true;
}

/// At rest at chainage 0 of straight track.
BodyVector Loco3d::computeRest() const {
  BodyState state;
  dynamics_.unpack(std::vector<double>(dynamics_.stateSize(), 0.0).data(), state);
  placeWheelsets(state);
  relax(TrackFrames(dynamics_.layout(), nullptr), state);
  for (auto& q : state.q) q[kY] = q[kRoll] = q[kYaw] = 0.0;  // both sides are alike: no round-off to grow from
  return state.q;
}

LocoStart Loco3d::equilibriumState(double location_m, double speed_mps) const {
  BodyState state = dynamics_.rollingState(location_m, speed_mps, parameters_.structure.wheel_radius_m);
  std::string failure;
  if (!onStraightTrack(state)) {
    followTrack(state);
    failure = settle(state, speed_mps);
  }
  if (failure.empty()) {
    const std::string unbalanced = relax(frames_, state);
    failure = checkStanding(state, frames_);
    if (failure.empty()) failure = unbalanced;
  }
  if (!failure.empty()) return {{}, placed(location_m, speed_mps) + failure};
  if (onStraightTrack(state))
    for (auto& q : state.q) q[kY] = q[kRoll] = q[kYaw] = 0.0;
  return {packStart(state), {}};
}

/// Flat, with yaw dampers that have followed, control at rest and all wheels on their rails.
std::vector<double> Loco3d::packStart(BodyState state) const {
  TrackFrames frames = frames_;
  frames.place(state.q);
  frames.computeGaps(state.v);
  BodyVector loads;
  for (auto& load : loads) load.setZero();
  dynamics_.addInnerForces(state, kForEver_s, loads, {&frames.gaps(), parameters_.gravity_stiffness});
  std::vector<double> flat(dynamics_.stateSize());
  dynamics_.pack(state, flat.data());
  const std::vector<double> control = drive_.initialState();
  flat.insert(flat.end(), control.begin(), control.end());
  flat.insert(flat.end(), 2 * BodyLayout::kAxles, 0.0);
  return flat;
}

}  // namespace loco
