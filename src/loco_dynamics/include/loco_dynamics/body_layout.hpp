#pragma once

#include <Eigen/Dense>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace loco {

/// Degrees of freedom of a body in the track frame T (REP-103: x forward along the track, y left, z up; rotations
/// positive about these axes, so positive pitch turns the nose down and a wheelset that rolls forward has pitch rate >
/// 0).
enum Dof : std::size_t { kX = 0, kY = 1, kZ = 2, kRoll = 3, kPitch = 4, kYaw = 5 };
inline constexpr std::size_t kDofs = 6;

/// One rigid body. Constant.
struct Body {
  std::string name;
  double mass_kg = 0.0;
  Eigen::Vector3d inertia_kg_m2 = Eigen::Vector3d::Zero();  ///< about its CoG: roll, pitch, yaw
  Eigen::Vector3d p_T = Eigen::Vector3d::Zero();  ///< CoG in nominal position: x from the locomotive's centre,
                                                  ///< z above the rail [m]
};

/// The bodies of a locomotive in a fixed order: car body B, bogie frames F1 (front) and F2, wheelsets A1 (front) to A6;
/// and which degrees of freedom each of them has. The models of 27 and of 54 degrees of freedom differ in that only.
class BodyLayout {
 public:
  static constexpr std::size_t kCar = 0;
  static constexpr std::size_t kBogies = 2;
  static constexpr std::size_t kAxlesPerBogie = 3;
  static constexpr std::size_t kAxles = kBogies * kAxlesPerBogie;
  static constexpr std::size_t kBodies = 1 + kBogies + kAxles;
  static constexpr std::size_t bogie(std::size_t i) { return 1 + i; }
  static constexpr std::size_t wheelset(std::size_t axle) { return 1 + kBogies + axle; }
  static constexpr std::size_t bogieOfAxle(std::size_t axle) { return bogie(axle / kAxlesPerBogie); }

  /// @param dofs  the degrees of freedom that every body has, e.g. {kX, kZ, kPitch} for the model of 27
  BodyLayout(std::vector<Body> bodies, const std::vector<Dof>& dofs);

  const std::vector<Body>& bodies() const { return bodies_; }
  /// Number of degrees of freedom of the whole locomotive.
  std::size_t size() const { return bodies_.size() * dofs_.size(); }
  double totalMass() const { return total_mass_kg_; }
  /// Mass or moment of inertia that resists this degree of freedom.
  double inertia(std::size_t body, Dof dof) const;
  const std::vector<Dof>& dofs() const { return dofs_; }

 private:
  std::vector<Body> bodies_;
  std::vector<Dof> dofs_;
  double total_mass_kg_ = 0.0;
};

/// Six numbers for each body: positions, velocities, or forces and moments. Entries of degrees of freedom that the
/// layout does not have stay 0 (forces on them are taken up by the constraint and have no effect).
using BodyVector = std::array<Eigen::Matrix<double, 6, 1>, BodyLayout::kBodies>;

/// Displacement of the point at `r` from a body's CoG, for small rotations: u + theta x r.
inline Eigen::Vector3d pointDisplacement(const Eigen::Matrix<double, 6, 1>& q, const Eigen::Vector3d& r) {
  return q.head<3>() + q.tail<3>().cross(r);
}

/// Adds the force F that acts on a body at `r` from its CoG, with its moment about the CoG.
inline void addForce(Eigen::Matrix<double, 6, 1>& load, const Eigen::Vector3d& F, const Eigen::Vector3d& r) {
  load.head<3>() += F;
  load.tail<3>() += r.cross(F);
}

}  // namespace loco
