#include "loco_dynamics/contact/creep_law.hpp"

#include <algorithm>
#include <cassert>

#include "loco_dynamics/contact/closed_form.hpp"

namespace loco {

namespace {

std::size_t indexOf(const std::string& name, const std::vector<std::string>& names) {
  const auto at = std::find(names.begin(), names.end(), name);
  assert(at != names.end());
  return static_cast<std::size_t>(at - names.begin());
}

}  // namespace

const std::vector<std::string>& creepMethodNames() {
  static const std::vector<std::string> names = {"modfastsim", "fastsim", "closed", "polach"};
  return names;
}

CreepMethod creepMethodOf(const std::string& name) {
  return static_cast<CreepMethod>(indexOf(name, creepMethodNames()));
}

const std::vector<std::string>& flexibilityRuleNames() {
  static const std::vector<std::string> names = {"blended", "three"};
  return names;
}

FlexibilityRule flexibilityRuleOf(const std::string& name) {
  return static_cast<FlexibilityRule>(indexOf(name, flexibilityRuleNames()));
}

CreepLaw::CreepLaw(const CreepLawParameters& parameters)
    : parameters_(parameters), grid_(parameters.cells, parameters.strips) {}

CreepForce CreepLaw::computeForce(const ContactPatch& patch, const Creepage& creepage) const {
  const double mu = computeFriction(parameters_.friction, creepage.slip_speed_mps);  // Eq. (2)
  if (!(patch.normal_N > 0.0)) return {0.0, 0.0, mu, 1.0};
  if (parameters_.method != CreepMethod::kPolach) return computeSimplified(patch, creepage, mu);
  const PlaneForce force = computePolachForce(patch, parameters_.polach, creepage, mu);
  return {force.x_N, force.y_N, mu, 1.0};
}

CreepForce CreepLaw::computeSimplified(const ContactPatch& patch, const Creepage& creepage, double mu) const {
  double k = 1.0;
  if (parameters_.method != CreepMethod::kFastsim) {
    const double eps = computeStressGradient(parameters_.reduction.k0, patch, creepage, mu);  // (C5)
    k = computeReduction(parameters_.reduction, eps);                                         // Eq. (3)
  }
  Flexibilities flexibility = computeFlexibilities(patch);
  if (parameters_.flexibility == FlexibilityRule::kBlended) {
    flexibility = blendFlexibilities(flexibility, patch, creepage, parameters_.friction.mu0);
  }
  flexibility = {flexibility.l1 / k, flexibility.l2 / k, flexibility.l3 / k};

  if (parameters_.method == CreepMethod::kClosed) {
    const PlaneForce force = computeClosedForce(patch, flexibility, creepage, mu);
    return {force.x_N, force.y_N, mu, k};
  }
  const FastsimGrid::Force force = grid_.computeForce(patch, flexibility, creepage, mu);
  return {force.x_N, force.y_N, mu, k};
}

}  // namespace loco
