#include "loco_dynamics/planar_contact.hpp"

#include "loco_dynamics/contact/creepage.hpp"

namespace loco {

namespace {

/// Pure longitudinal creep has an exact and cheaper form of the paper's law.
CreepLawParameters withoutGrid(CreepLawParameters parameters) {
  if (parameters.method == CreepMethod::kModfastsim) parameters.method = CreepMethod::kClosed;
  return parameters;
}

RailConditions withoutGrid(RailConditions rail) {
  rail.elsewhere = withoutGrid(rail.elsewhere);
  if (rail.sanded) rail.sanded = withoutGrid(*rail.sanded);
  for (RailConditions::Section& section : rail.sections) section.creep = withoutGrid(section.creep);
  return rail;
}

/// Force of both wheels along the track at slip w.
CreepForce forceOf(const CreepLaw& law, const ContactPatch& patch, double slip_mps, double v_mps) {
  CreepForce force = law.computeForce(patch, computeCreepage({-slip_mps, 0.0, 0.0}, v_mps));
  force.x_N *= 2.0;
  return force;
}

}  // namespace

PlanarContact::Parameters PlanarContact::read(rail::YamlReader reader, double wheel_radius_m) {
  Parameters p;
  p.wheel_radius_m = wheel_radius_m;
  p.rail_crown_radius_m = reader.number("rail_crown_radius_m", rail::between(0.01, 10.0));
  p.wheel_transverse_curvature_1pm = reader.number("wheel_transverse_curvature_1pm", rail::between(-100.0, 100.0));
  p.normal_damping_N_s_per_m = reader.number("normal_damping_N_s_per_m", rail::notNegative());
  p.elasticity.young_Pa = reader.number("young_modulus_Pa", rail::positive());
  p.elasticity.poisson = reader.number("poisson_ratio", rail::between(0.0, 0.5));
  p.shear_modulus_Pa = reader.number("shear_modulus_Pa", rail::positive());
  if (reader.choiceOr("normal_law", {"hertz", "linear"}, "hertz") == "linear") {
    p.normal_law = NormalLaw::kLinear;
    p.linear_stiffness_N_per_m = reader.number("linear_stiffness_N_per_m", rail::positive());
  }
  if (1.0 / p.rail_crown_radius_m + p.wheel_transverse_curvature_1pm <= 0.0)
    reader.refuse("wheel_transverse_curvature_1pm", "must be less hollow than the rail's crown is round");
  reader.finish();
  return p;
}

NormalContact PlanarContact::makeNormalContact(const Parameters& p) {
  const RelativeCurvature curvature{1.0 / p.wheel_radius_m,
                                    1.0 / p.rail_crown_radius_m + p.wheel_transverse_curvature_1pm};
  return NormalContact({curvature, p.elasticity, p.normal_damping_N_s_per_m, p.normal_law, p.linear_stiffness_N_per_m});
}

PlanarContact::PlanarContact(const Parameters& parameters, const RailConditions& rail)
    : shear_modulus_Pa_(parameters.shear_modulus_Pa),
      normal_(makeNormalContact(parameters)),
      kalker_(computeKalkerCoefficients(normal_.hertz().aOverB(), parameters.elasticity.poisson)),
      creep_(withoutGrid(rail)) {}

PlanarContact::AxleForce PlanarContact::computeAxleForce(double normal_N, double slip_mps, double v_mps,
                                                         double location_m, bool sanding) const {
  AxleForce result;
  const CreepLaw& law = creep_.at(location_m, sanding);
  result.static_friction = law.parameters().friction.mu0;
  if (normal_N <= 0.0) return result;
  const HertzContact::Ellipse ellipse = normal_.hertz().computeEllipse(normal_N);
  const ContactPatch patch{ellipse.a_m, ellipse.b_m, normal_N, shear_modulus_Pa_, kalker_};
  constexpr double kSlipStep_mps = 1e-5;  // chosen: far below the slip at which the law bends
  const CreepForce force = forceOf(law, patch, slip_mps, v_mps);
  result.force_N = force.x_N;
  result.friction = force.friction;
  result.slope_N_s_per_m = (forceOf(law, patch, slip_mps + kSlipStep_mps, v_mps).x_N - force.x_N) / kSlipStep_mps;
  return result;
}

}  // namespace loco
