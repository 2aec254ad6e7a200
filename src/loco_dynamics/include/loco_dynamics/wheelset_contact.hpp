#pragma once

#include <array>
#include <memory>

#include "loco_dynamics/body_layout.hpp"
#include "loco_dynamics/contact/creepage.hpp"
#include "loco_dynamics/contact/hertz_table.hpp"
#include "loco_dynamics/contact/rail_conditions.hpp"
#include "loco_dynamics/contact_finder.hpp"
#include "rail_core/track_irregularity.hpp"

namespace loco {

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// How a wheelset moves, and where.
struct WheelsetMotion {
  Vector6 q;                   ///< position in the wheelset's track frame
  Vector6 v;                   ///< velocity there; the pitch's is the spin omega
  double curvature_1pm = 0.0;  ///< of the track
  double location_m = 0.0;     ///< chainage: decides on the rail's condition
  bool irregular = false;      ///< the rails may lie elsewhere than designed:
  rail::RailOffsets rails;     ///< where, in the track frame
  bool sanding = false;        ///< sand is laid before the wheels
};

/// Contacts of a wheelset with both rails: normal forces, creepages, creep forces. Constant.                (W)
///   contact frame P: x along the track, n = (0, -sin gamma, cos gamma), t = (0, cos gamma, sin gamma); r from the
///   wheelset's CoG to the contact; axle e = (-psi, 1, phi)
///   speed of the wheelset's material there along a direction d: J_d v + frame's part,
///     J_d = (d, (x cross r) d, (e cross r) d, (z cross r) d)                                            (W1)
///     frame's part of x: -v kappa p_y, of t: v kappa r_x cos gamma
///   N_i = max(0, s_i K_i delta_i^1.5 - c (N_i/sum N) J_n v), c shared in proportion to the elastic forces  (W2)
///   creepages: slip over max(|v|, 0.5 m/s); spin = (J_roll - omega psi, omega, psi' + v kappa + omega phi) n  (W3)
///   generalised forces on the wheelset: J_d transposed times the force along d                         (W4)
/// On rails that lie off by (Y, Z) with slopes Y', Z' the finder sees the wheelset from the rail, at y - Y, z - Z with
/// the yaw psi - Y', and the contact's directions turn with the rail:                                            (W6)
///   x = (1, Y', Z'),  n = (Y' sin gamma - Z' cos gamma, -sin gamma, cos gamma),
///   t = (-Y' cos gamma - Z' sin gamma, cos gamma, sin gamma),   lead r_x + r Z'
/// The creep forces are linearly implicit in all six velocities of the wheelset: F = F_0 - S J (v_n+1 - v_n), S along
/// the slip the slope of the closed form, across it min(k G a b C/V, mu N/slip); where S is not the law's own slope
/// (spin, falling friction) the difference is of the order of the step. No more than mu N a contact.       (W5)
/// Not modelled: moment of spin about the contact's normal, speeds from a cant's run-off in the creepages, elasticity
/// of the rail.
class WheelsetContact {
 public:
  struct Parameters {
    double wheel_radius_m = 0.0;
    double normal_damping_N_s_per_m = 0.0;  ///< c, a wheel
    Elasticity elasticity;
    double shear_modulus_Pa = 82e9;
  };
  WheelsetContact(const Parameters& parameters, const RailConditions& rail,
                  std::shared_ptr<const ContactFinder> finder);

  /// One contact in one step. Forces on the wheel.
  struct Contact {
    Side side = Side::kLeft;
    ContactRegion region;
    double a_m = 0.0, b_m = 0.0;
    double normal_N = 0.0, elastic_N = 0.0;  ///< with and without damping
    Creepage creepage;
    double friction = 0.0;
    Eigen::Vector2d slip_mps = Eigen::Vector2d::Zero();         ///< along x, t
    Eigen::Vector2d frame_mps = Eigen::Vector2d::Zero();        ///< what of it comes from the frame's turning
    Eigen::Vector2d creep_N = Eigen::Vector2d::Zero();          ///< along x, t
    Eigen::Vector2d along = Eigen::Vector2d::UnitX();           ///< unit vector of the slip
    Eigen::Vector2d slope_N_s_per_m = Eigen::Vector2d::Zero();  ///< of the force over slip, along and across the slip
    Vector6 J_n = Vector6::Zero(), J_x = Vector6::Zero(), J_t = Vector6::Zero();  ///< (W1)
    Eigen::Vector3d force_N() const;                                              ///< in T
    double alongTrack_N() const;                                                  ///< its part along x of T
  };
  struct Contacts {
    std::array<Contact, 2 * kMostContacts> list;
    std::size_t count = 0;
    std::array<std::size_t, 2> of_wheel{};  ///< number: left wheel's first, then the right one's
    double static_friction = 0.0;
  };
  /// All contacts of the wheelset, forces from velocities at the start of the step.
  void compute(const WheelsetMotion& motion, Contacts& out) const;

  /// Brake shoes on the treads of one wheelset.
  struct Shoes {
    double largest_N_m = 0.0;    ///< torque that they can take, >= 0
    double turning_radps = 0.0;  ///< of the wheelset against the frame that carries them
  };
  /// Makes the creep forces implicit (W5) and adds all forces to the loads, with them those of the shoes (P3).
  /// @param inertia  of the wheelset: masses and moments of inertia
  /// @return torque of the shoes on the wheelset [N m]
  static double addForces(const Vector6& inertia, double h, Contacts& contacts, Vector6& load, const Shoes& shoes);

  /// What the forces did during the step, with the mean of its velocities [J].
  struct Work {
    double slip = 0.0;     ///< lost to slip
    double damping = 0.0;  ///< lost in the normal contact
    double elastic = 0.0;  ///< stored in it, along the path
    double on_body = 0.0;  ///< given to the wheelset
  };
  static Work computeWork(const Contacts& contacts, const Vector6& v_mean, double h);

 private:
  void computeNormalForces(const Vector6& v, Contact* first, std::size_t count) const;
  void computeCreep(const WheelsetMotion& motion, const CreepLaw& law, Contact& contact) const;

  Parameters parameters_;
  HertzTable hertz_;
  CreepLawByPlace creep_;
  std::shared_ptr<const ContactFinder> finder_;
};

}  // namespace loco
