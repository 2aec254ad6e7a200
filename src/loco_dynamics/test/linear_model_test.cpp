#include "loco_dynamics/linear_model.hpp"

#include "loco_2d_fixtures.hpp"

namespace {

using fixtures::paperStructure;
using loco::BodyLayout;
using loco::BodyVector;
using loco::LinearModel;

const std::vector<loco::Dof> kPlanar = {loco::kX, loco::kZ, loco::kPitch};
const std::vector<loco::Dof> kSpatial = {loco::kX, loco::kY, loco::kZ, loco::kRoll, loco::kPitch, loco::kYaw};

BodyVector zero() {
  BodyVector x;
  for (auto& body : x) body.setZero();
  return x;
}

/// Forces of the suspension on every coordinate when one of them is displaced, or moves.
Eigen::VectorXd forces(const loco::LocoStructure& s, const LinearModel& model, const BodyVector& q,
                       const BodyVector& v) {
  loco::SuspensionWorkspace workspace(s.suspension);
  std::vector<double> damper_x(s.suspension.yaw_dampers.size(), 0.0);
  BodyVector loads = zero();
  // dampers: u = k_s d/c_s
  loco::addSuspensionForces(s.suspension, q, v, 1e-12, {}, damper_x.data(), workspace, loads);
  Eigen::VectorXd out(model.size());
  for (Eigen::Index i = 0; i < model.size(); ++i) {
    const loco::Coordinate& c = model.coordinates[static_cast<std::size_t>(i)];
    out[i] = loads[c.body][static_cast<Eigen::Index>(c.dof)];
  }
  return out;
}

TEST(LinearModelTest, ItsMatricesAreTheForcesThatTheIntegratorUses) {
  const loco::LocoStructure s = paperStructure({{"primary.z_m", "0.6"}});  // above the axle: the box must not spin
  const LinearModel model = loco::linearise(s, loco::allCoordinates(kSpatial), {0.0, 0.0}, {});
  ASSERT_EQ(model.size(), 54);
  const Eigen::MatrixXd K = model.stiffness + model.damper_stretch.transpose() *
                                                  model.damper_spring_N_per_m.asDiagonal() * model.damper_stretch;
  const double small = 1e-5;  // within the pins' clearance and the dampers' first branch
  for (Eigen::Index j = 0; j < model.size(); ++j) {
    const loco::Coordinate& c = model.coordinates[static_cast<std::size_t>(j)];
    BodyVector moved = zero();
    moved[c.body][static_cast<Eigen::Index>(c.dof)] = small;
    // all is linear here: round-off only, of entries up to 1e9
    EXPECT_LT((forces(s, model, moved, zero()) / small + K.col(j)).cwiseAbs().maxCoeff(), 1.0) << model.names[j];
    EXPECT_LT((forces(s, model, zero(), moved) / small + model.damping.col(j)).cwiseAbs().maxCoeff(), 1e-3)
        << model.names[j];
  }
}

TEST(LinearModelTest, MatricesAreSymmetricAndRigidMotionMeetsNoForce) {
  const loco::LocoStructure s = paperStructure();
  const LinearModel model = loco::linearise(s, loco::allCoordinates(kSpatial), {0.0, 0.0}, {});
  EXPECT_LT((model.stiffness - model.stiffness.transpose()).cwiseAbs().maxCoeff(), 1e-6);
  Eigen::VectorXd pitching(model.size());  // about the origin; wheelsets go along, their axleboxes do not see it
  for (Eigen::Index i = 0; i < model.size(); ++i) {
    const loco::Coordinate& c = model.coordinates[static_cast<std::size_t>(i)];
    const Eigen::Vector3d u = Eigen::Vector3d::UnitY().cross(s.bodies[c.body].p_T);
    pitching[i] = c.dof == loco::kPitch ? 1.0 : c.dof < loco::kRoll ? u[static_cast<Eigen::Index>(c.dof)] : 0.0;
  }
  EXPECT_LT((model.stiffness * pitching).cwiseAbs().maxCoeff(), 1e-3);  // of forces of 1e9
}

TEST(LinearModelTest, WheelsResistBounceAndRollOfTheirWheelset) {
  const loco::LocoStructure s = paperStructure();
  const auto stiffnessOf = [&](const loco::WheelSpring& wheel, loco::Dof dof) {
    return loco::linearise(s, {{BodyLayout::wheelset(2), dof}}, wheel, {}).stiffness(0, 0);
  };
  EXPECT_DOUBLE_EQ(stiffnessOf({1e9, 0.0, 0.75}, loco::kZ) - stiffnessOf({0.0, 0.0, 0.75}, loco::kZ), 2e9);
  EXPECT_NEAR(stiffnessOf({1e9, 0.0, 0.75}, loco::kRoll) - stiffnessOf({0.0, 0.0, 0.75}, loco::kRoll),
              2e9 * 0.75 * 0.75, 1.0);
}

TEST(LinearModelTest, APinInItsClearanceIsSlackAndStiffOnItsSteepestBranch) {
  const loco::LocoStructure s = paperStructure();
  const auto stiffnessOf = [&](loco::Branch branch) {
    return loco::linearise(s, {{BodyLayout::kCar, loco::kX}}, {}, {branch, true}).stiffness(0, 0);
  };
  EXPECT_DOUBLE_EQ(stiffnessOf(loco::Branch::kAtRest), 2 * 1507.2e3);
  EXPECT_DOUBLE_EQ(stiffnessOf(loco::Branch::kStiffest), 2 * 1507.2e3 + 2e9);
}

TEST(LinearModelTest, CoordinatesAreNamedInWords) {
  const LinearModel model = loco::linearise(paperStructure(), loco::allCoordinates(kPlanar), {}, {});
  EXPECT_EQ(model.size(), 27);
  EXPECT_EQ(model.names.front(), "car body, longitudinal");
  EXPECT_EQ(model.names[7], "bogie frame 2, vertical");
  EXPECT_EQ(model.names.back(), "wheelset 6, pitch");
}

}  // namespace
