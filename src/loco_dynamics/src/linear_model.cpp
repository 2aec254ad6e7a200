#include "loco_dynamics/linear_model.hpp"

namespace loco {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr Index kAll = static_cast<Index>(BodyLayout::kBodies * kDofs);

Index columnOf(const Coordinate& c) { return static_cast<Index>(c.body * kDofs + c.dof); }

/// Displacement of the point at r from a body's CoG, u + theta x r, as a matrix on all coordinates.
/// @param spins  a wheelset, whose axlebox does not see its pitch
MatrixXd pointMotion(std::size_t body, const Vector3d& r, bool spins = false) {
  MatrixXd J = MatrixXd::Zero(3, kAll);
  const Index first = columnOf({body, kX});
  J.block<3, 3>(0, first).setIdentity();
  J.block<3, 3>(0, first + 3) << 0.0, r.z(), -r.y(), -r.z(), 0.0, r.x(), r.y(), -r.x(), 0.0;
  if (spins) J.col(columnOf({body, kPitch})).setZero();
  return J;
}

template <typename Element>
MatrixXd relativeMotion(const Element& e, bool spins_A = false) {
  return pointMotion(e.body_A, e.r_A, spins_A) - pointMotion(e.body_B, e.r_B);
}

/// The law's slope at rest, or its steepest.
double slopeOf(const OddLaw& law, Branch branch) {
  return branch == Branch::kAtRest ? law.slope(0.0) : law.largestSlope();
}

/// Matrices over all six degrees of freedom of all bodies.
struct FullMatrices {
  MatrixXd K = MatrixXd::Zero(kAll, kAll), C = MatrixXd::Zero(kAll, kAll);

  void add(MatrixXd& into, const MatrixXd& motion, const Vector3d& coefficients) {
    into += motion.transpose() * coefficients.asDiagonal() * motion;
  }
  void addSuspension(const Suspension& suspension, const LinearOptions& options) {
    for (const SpringDamper& e : suspension.springs) {
      const MatrixXd motion = relativeMotion(e, e.spins_A);
      add(K, motion, e.stiffness_N_per_m);
      add(C, motion, e.damping_N_s_per_m);
    }
    for (const CentrePin& e : suspension.pins)
      add(K, relativeMotion(e), {slopeOf(e.longitudinal, options.branch), slopeOf(e.lateral, options.branch), 0.0});
    if (options.series_springs) return;
    for (const YawDamper& e : suspension.yaw_dampers)
      add(C, relativeMotion(e), {slopeOf(e.damper, options.branch), 0.0, 0.0});
  }
  void addWheels(const WheelSpring& wheel) {
    for (std::size_t axle = 0; axle < BodyLayout::kAxles; ++axle) {
      for (const double y : {wheel.y_m, -wheel.y_m}) {
        const MatrixXd motion = pointMotion(BodyLayout::wheelset(axle), {0.0, y, 0.0});
        add(K, motion, {0.0, 0.0, wheel.stiffness_N_per_m});
        add(C, motion, {0.0, 0.0, wheel.damping_N_s_per_m});
      }
    }
  }
};

void addYawDampers(const Suspension& suspension, Branch branch, LinearModel& model) {
  std::vector<YawDamper> dampers;
  for (const YawDamper& e : suspension.yaw_dampers)
    if (slopeOf(e.damper, branch) > 0.0) dampers.push_back(e);  // the others give no force
  const auto n = static_cast<Index>(dampers.size());
  model.damper_stretch = MatrixXd(n, model.size());
  model.damper_spring_N_per_m = model.damper_slope_N_s_per_m = Eigen::VectorXd(n);
  for (Index i = 0; i < n; ++i) {
    const YawDamper& e = dampers[static_cast<std::size_t>(i)];
    const MatrixXd motion = relativeMotion(e);
    for (Index j = 0; j < model.size(); ++j)
      model.damper_stretch(i, j) = motion(0, columnOf(model.coordinates[static_cast<std::size_t>(j)]));
    model.damper_spring_N_per_m[i] = e.series_stiffness_N_per_m;
    model.damper_slope_N_s_per_m[i] = slopeOf(e.damper, branch);
  }
}

}  // namespace

std::vector<Coordinate> allCoordinates(const std::vector<Dof>& dofs) {
  std::vector<Coordinate> coordinates;
  for (std::size_t body = 0; body < BodyLayout::kBodies; ++body)
    for (const Dof dof : dofs) coordinates.push_back({body, dof});
  return coordinates;
}

std::string toWords(const Coordinate& coordinate, const std::vector<Body>& bodies) {
  static const char* const words[] = {"longitudinal", "lateral", "vertical", "roll", "pitch", "yaw"};
  return bodies[coordinate.body].name + ", " + words[coordinate.dof];
}

LinearModel linearise(const LocoStructure& structure, const std::vector<Coordinate>& coordinates,
                      const WheelSpring& wheel, const LinearOptions& options) {
  FullMatrices full;
  full.addSuspension(structure.suspension, options);
  full.addWheels(wheel);
  LinearModel model;
  model.coordinates = coordinates;
  const auto n = static_cast<Index>(coordinates.size());
  model.inertia = Eigen::VectorXd(n);
  model.stiffness = model.damping = MatrixXd(n, n);
  const BodyLayout layout(structure.bodies, {});
  for (Index i = 0; i < n; ++i) {
    const Coordinate& row = coordinates[static_cast<std::size_t>(i)];
    model.names.push_back(toWords(row, structure.bodies));
    model.inertia[i] = layout.inertia(row.body, row.dof);
    for (Index j = 0; j < n; ++j) {
      const Coordinate& column = coordinates[static_cast<std::size_t>(j)];
      model.stiffness(i, j) = full.K(columnOf(row), columnOf(column));
      model.damping(i, j) = full.C(columnOf(row), columnOf(column));
    }
  }
  model.damper_stretch = MatrixXd(0, n);
  if (options.series_springs) addYawDampers(structure.suspension, options.branch, model);
  return model;
}

}  // namespace loco
