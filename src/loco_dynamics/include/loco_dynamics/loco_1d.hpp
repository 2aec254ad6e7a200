#pragma once

#include "loco_dynamics/locomotive.hpp"

namespace loco {

/// The conventional locomotive of longitudinal train dynamics (Wu et al. 2020, Sect. 3.1): a mass whose traction is the
/// reference from look-up tables and motor response, cut at a constant adhesion limit. No contact, no slip: the work
/// at the rim equals that at the rail.
///
/// State: chainage s [m] and speed v [m/s] of the CoG.
class Loco1d : public Locomotive {
 public:
  struct Parameters {
    double mass_kg = 0.0;           ///< weight that adheres
    double inertial_mass_kg = 0.0;  ///< mass that is accelerated: with rotary inertia if the scenario counts it
    double adhesion_limit = 0.0;    ///< traction over weight [-]; 0.35 in the paper
  };
  explicit Loco1d(const Parameters& parameters);

  std::size_t stateSize() const override { return 2; }
  LocoStart equilibriumState(double location_m, double speed_mps) const override;
  void step(const std::vector<double>& state, const LocoForce& force, LocoTraction& answer) override;
  /// The car body alone, at no height: this model has none.
  std::vector<BodyPose> computePoses(const std::vector<double>& state) const override;

 private:
  Parameters parameters_;
  double adhesion_limit_N_;
};

/// Force of the motors after the adhesion limit, in traction and in braking.                        (T8)
///   F_t = F_ref, |F_t| <= mu_lim m g
/// @param reference_N  traction reference [N], < 0: dynamic brake
/// @return force on the locomotive [N], + forward
/// Source: Wu et al. 2020, Sect. 3.1 and note "a 0.35 adhesion limit was applied". Not modelled: anything of the
/// contact.
double computeAdhesionLimitedTraction(double reference_N, double adhesion_limit_N);

}  // namespace loco
