#pragma once

#include "loco_dynamics/contact/normal_contact.hpp"
#include "loco_dynamics/contact/rail_conditions.hpp"
#include "rail_core/yaml_reader.hpp"

namespace loco {

/// Contact of a wheelset that stays in the middle of straight track: both wheels alike, one constant geometry.
/// Constant. Normal force of each wheel by (P1); the creep force of both wheels together from the creep law,
/// longitudinal creep only.
class PlanarContact {
 public:
  struct Parameters {
    double rail_crown_radius_m = 0.0;             ///< of the rail head, transverse
    double wheel_transverse_curvature_1pm = 0.0;  ///< < 0: the tread is hollow
    double wheel_radius_m = 0.0;
    double normal_damping_N_s_per_m = 0.0;  ///< c, a wheel
    Elasticity elasticity;
    double shear_modulus_Pa = 82e9;
    NormalLaw normal_law = NormalLaw::kHertz;
    double linear_stiffness_N_per_m = 0.0;  ///< a wheel, if the law is linear
  };
  /// Reads rail_crown_radius_m, wheel_transverse_curvature_1pm, normal_damping_N_s_per_m, young_modulus_Pa,
  /// poisson_ratio, shear_modulus_Pa and, optional, normal_law with linear_stiffness_N_per_m if it is linear; finishes
  /// the reader.
  static Parameters read(rail::YamlReader reader, double wheel_radius_m);

  PlanarContact(const Parameters& parameters, const RailConditions& rail);
  /// One wheel's normal contact alone.
  static NormalContact makeNormalContact(const Parameters& parameters);

  /// Force of one wheel [N], >= 0, at approach delta [m] and its rate [m/s].
  double computeNormalForce(double approach_m, double approach_rate_mps) const {
    return normal_.computeForce(approach_m, approach_rate_mps);
  }
  /// Elastic energy of one wheel's contact [J].
  double computeStoredEnergy(double approach_m) const { return normal_.computeStoredEnergy(approach_m); }
  double computeApproach(double normal_N) const { return normal_.computeApproach(normal_N); }

  struct AxleForce {
    double force_N = 0.0;          ///< of both wheels on the wheelset, + forward
    double friction = 0.0;         ///< mu that the rail offers at this slip speed
    double static_friction = 0.0;  ///< mu0 of the rail at this place
    double slope_N_s_per_m = 0.0;  ///< dF/dw, w slip speed of the wheels over the rail, + driving
  };
  /// @param normal_N  of one wheel
  /// @param slip_mps  w = omega r - v, + driving
  /// @param v_mps     speed of the wheelset along the track
  /// @param location_m  chainage of the wheelset: decides on the rail's condition
  /// @param sanding   sand is laid before the wheels
  AxleForce computeAxleForce(double normal_N, double slip_mps, double v_mps, double location_m,
                             bool sanding = false) const;

 private:
  double shear_modulus_Pa_;
  NormalContact normal_;
  KalkerCoefficients kalker_;
  CreepLawByPlace creep_;
};

}  // namespace loco
