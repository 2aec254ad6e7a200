#pragma once

#include <vector>

#include "rail_core/yaml_reader.hpp"

namespace ltd {

/// Coupler with draft gears: slack, then a loading and an unloading curve between which the sign of the relative speed
/// chooses, smoothed.                                                                               (T2)
///   F = (L + U)/2 + (L - U)/2 tanh(sgn(x) xdot / vs),      U = u L
/// x: elongation from mid-slack, L, U: loading and unloading force, odd in x, zero within the slack.
/// Signs: x > 0 longer (draft), F > 0 tension.
/// Source: chosen (the paper gives no coupler); the form follows common LTD practice. sgn(x) is needed: with the plain
/// relative speed the coupler would make energy in buff.
class Coupler {
 public:
  struct Parameters {
    /// One straight piece of the loading curve, from the end of the previous one.
    struct Piece {
      double up_to_m =
          0.0;  ///< deflection from the end of the slack at which the piece ends; the last goes on for ever
      double stiffness_N_per_m = 0.0;
    };
    double slack_m = 0.0;              ///< whole slack: half of it each way from the middle
    std::vector<Piece> loading;        ///< at least one
    double unloading_ratio = 1.0;      ///< u, 0 < u <= 1
    double smoothing_speed_mps = 0.0;  ///< vs
  };
  explicit Coupler(Parameters parameters);

  /// Reads slack_m, loading: [{up_to_m, stiffness_N_per_m}, ..., {stiffness_N_per_m}], unloading_ratio,
  /// smoothing_speed_mps and checks them; finishes the reader.
  static Parameters read(rail::YamlReader reader);

  struct Force {
    double force_N = 0.0;             ///< tension +
    double mean_N = 0.0;              ///< (L + U)/2, the part that stores energy
    double friction_N_s_per_m = 0.0;  ///< largest dF/dxdot here, (L - U)/(2 vs): what limits the step
  };
  Force computeForce(double elongation_m, double elongation_speed_mps) const;

  /// Elastic energy: integral of (L + U)/2 from mid-slack [J], >= 0.
  double computeStoredEnergy(double elongation_m) const;

  /// Deflection beyond the slack [m] at which the loading curve reaches `force_N` >= 0.
  double deflectionAt(double force_N) const;
  /// Largest stiffness of the loading curve up to `force_N` [N/m].
  double stiffnessUpTo(double force_N) const;

  const Parameters& parameters() const { return parameters_; }

 private:
  /// Loading force [N] and its integral [J] at deflection d >= 0.
  struct Loading {
    double force_N, energy_J;
  };
  Loading loadingAt(double deflection_m) const;

  struct Knot {
    double deflection_m, force_N, energy_J, stiffness_N_per_m;
  };
  Parameters parameters_;
  std::vector<Knot> knots_;  ///< start of each piece
};

}  // namespace ltd
