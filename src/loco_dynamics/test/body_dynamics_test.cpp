#include "loco_dynamics/body_dynamics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "loco_dynamics/loco_structure.hpp"

namespace {

using loco::BodyDynamics;
using loco::BodyLayout;
using loco::BodyState;
using loco::BodyVector;

const std::vector<loco::Dof> kPlanar = {loco::kX, loco::kZ, loco::kPitch};

loco::LocoStructure paperLocomotive(const std::vector<rail::Override>& overrides = {}) {
  rail::Problems problems;
  const rail::Document document =
      rail::Document::load(std::string(CONFIG_DIR) + "/bodies/co_co_134t.yaml", overrides, problems);
  const loco::LocoStructure structure = loco::LocoStructure::read(rail::YamlReader(document, problems));
  problems.throwIfAny();
  return structure;
}

BodyState atRest(const BodyDynamics& dynamics) {
  BodyState state;
  dynamics.unpack(std::vector<double>(dynamics.stateSize(), 0.0).data(), state);
  return state;
}

TEST(BodyDynamicsTest, MassesOfThePapersLocomotiveCloseAt134Tonnes) {
  EXPECT_DOUBLE_EQ(paperLocomotive().totalMass(), 134000.0);
}

TEST(BodyDynamicsTest, ThePlanarModelHas27DegreesOfFreedomAndTheSpatial54) {
  const loco::LocoStructure s = paperLocomotive();
  EXPECT_EQ(BodyLayout(s.bodies, kPlanar).size(), 27u);
  EXPECT_EQ(BodyLayout(s.bodies, {loco::kX, loco::kY, loco::kZ, loco::kRoll, loco::kPitch, loco::kYaw}).size(), 54u);
}

TEST(BodyDynamicsTest, ElementsActOnBothBodiesSoThatNoNetForceOrMomentRemains) {
  const loco::LocoStructure s = paperLocomotive();
  BodyDynamics dynamics(BodyLayout(s.bodies, kPlanar), s.suspension);
  BodyState state = atRest(dynamics);
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {  // some distorted, moving state
    state.q[i][loco::kX] = 1e-3 * std::sin(1.0 + 2.0 * static_cast<double>(i));
    state.q[i][loco::kZ] = 2e-3 * std::cos(3.0 * static_cast<double>(i));
    state.v[i][loco::kPitch] = i < 3 ? 1e-2 * std::sin(5.0 * static_cast<double>(i)) : 0.0;
  }
  BodyVector loads{};
  for (auto& load : loads) load.setZero();
  dynamics.addInnerForces(state, 1e-3, loads);
  double F_x = 0.0, F_z = 0.0, M_y = 0.0;
  for (std::size_t i = 0; i < BodyLayout::kBodies; ++i) {
    F_x += loads[i][loco::kX];
    F_z += loads[i][loco::kZ] + s.bodies[i].mass_kg * 9.81;
    M_y += loads[i][loco::kPitch] + s.bodies[i].p_T.z() * loads[i][loco::kX] -
           s.bodies[i].p_T.x() * (loads[i][loco::kZ] + s.bodies[i].mass_kg * 9.81);
  }
  EXPECT_NEAR(F_x, 0.0, 1e-6);  // of element forces of 1e5 N: round-off
  EXPECT_NEAR(F_z, 0.0, 1e-6);
  // The axlebox carries no pitch of its wheelset: its moment r x F is taken by the frame's guidance.
  EXPECT_NEAR(M_y, 0.0, 1e-5);
}

/// A step that leads to no good says where.
TEST(BodyDynamicsTest, WhatIsNoNumberOrFarFromItsPlaceIsNamed) {
  const loco::LocoStructure s = paperLocomotive();
  const BodyDynamics dynamics(BodyLayout(s.bodies, kPlanar), s.suspension);
  const auto failure = [&](std::size_t body, loco::Dof dof, double load) {
    BodyState state = atRest(dynamics);
    for (auto& q : state.q) q[loco::kX] = 3000.0;  // a chainage is no displacement
    BodyVector loads{};
    for (auto& l : loads) l.setZero();
    loads[body][static_cast<Eigen::Index>(dof)] = load;
    return dynamics.step(loads, 1.0, state);
  };
  EXPECT_EQ(failure(BodyLayout::wheelset(1), loco::kZ, std::nan("")), "wheelset 2: its speed in z is no number");
  EXPECT_EQ(failure(BodyLayout::wheelset(1), loco::kZ, -3400.0 * 1.5), "wheelset 2: in z is -1.5 m from its place");
  EXPECT_EQ(failure(BodyLayout::bogie(0), loco::kX, 11000.0 * 2.0), "bogie frame 1: in x is 2 m from its place");
  EXPECT_EQ(failure(BodyLayout::kCar, loco::kPitch, 3793457.0 * 1.1), "car body: in pitch is 1.1 rad from its place");
  EXPECT_EQ(failure(BodyLayout::wheelset(1), loco::kZ, 3400.0 * 0.9), "");
  EXPECT_EQ(failure(BodyLayout::wheelset(5), loco::kPitch, 1432.0 * 1e4), "");  // wheels may race
}

}  // namespace
