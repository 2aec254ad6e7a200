#pragma once

namespace adhesion {

/// The part of `value` that lies between 0 and `end`, whichever sign `end` has.
double clampBetweenZeroAnd(double value, double end);

/// PI controller of one slip, with anti-windup. It takes a reduction R away from the torque reference:
///   e = s - sgn(T_ref) s_limit
///   R = K_p e + I,       kept between 0 and T_ref                                                           (A2)
///   dI/dt = K_i e,       I kept between 0 and T_ref                                                         (A3)
///   T = T_ref - R,       so T lies between 0 and T_ref, too
/// In traction T_ref, R, I >= 0. Braking (T_ref < 0, s < 0) is the mirror image: slide protection. R and I carry the
/// sign of T_ref, so when T_ref changes its sign both start again from 0 and T passes through 0 with T_ref.
/// Source: PI and 7 % published (Wu et al. 2020), gains and clamps chosen. Without the clamp on I a long slip would
/// charge the integral far beyond T_ref, and the wheel would stay without torque long after it had gripped again.
class PiController {
 public:
  struct Parameters {
    double slip_limit = 0.07;                 ///< s_limit, 0 < s_limit < 1
    double proportional_gain_N_m = 150e3;     ///< K_p, > 0
    double integral_gain_N_m_per_s = 1000e3;  ///< K_i, >= 0
  };
  explicit PiController(const Parameters& parameters) : parameters_(parameters) {}

  /// Takes one sample and advances the integral by one period (Euler: I at the sample makes R).
  /// @param slip  s as in (A1)
  /// @param torque_reference_N_m  T_ref at the wheelset [N m], + driving forward
  /// @param period_s  time to the next sample [s]
  /// @param integral_N_m  I [N m], replaced by its value at the next sample
  /// @return R [N m], between 0 and T_ref
  double step(double slip, double torque_reference_N_m, double period_s, double& integral_N_m) const;

  const Parameters& parameters() const { return parameters_; }

 private:
  Parameters parameters_;
};

}  // namespace adhesion
