#include "loco_dynamics/contact/contact_config.hpp"

namespace loco {

namespace {

FrictionLaw readFriction(rail::YamlReader reader) {
  FrictionLaw friction;
  friction.mu0 = reader.number("mu0", rail::aboveUpTo(0.0, 1.0));
  friction.A = reader.number("A", rail::aboveUpTo(0.0, 1.0));
  friction.B_s_per_m = reader.number("B_s_per_m", rail::notNegative());
  reader.finish();
  return friction;
}

ReductionFactor readReduction(rail::YamlReader reader) {
  ReductionFactor reduction;
  reduction.k0 = reader.number("k0", rail::aboveUpTo(0.0, 1.0));
  reduction.alpha_inf = reader.number("alpha_inf", rail::between(0.0, 1.0));
  reduction.beta = reader.number("beta", rail::notNegative());
  reader.finish();
  return reduction;
}

PolachFactors readPolach(rail::YamlReader reader) {
  PolachFactors polach;
  polach.k_A = reader.number("k_A", rail::aboveUpTo(0.0, 1.0));
  polach.k_S = reader.number("k_S", rail::aboveUpTo(0.0, 1.0));
  if (polach.k_S > polach.k_A) reader.refuse("k_S", "must not be larger than k_A");
  reader.finish();
  return polach;
}

void readGrid(rail::YamlReader reader, CreepLawParameters& parameters) {
  parameters.cells = reader.integer("cells", 1, FastsimGrid::kMostCells);
  parameters.strips = reader.integer("strips", 1, FastsimGrid::kMostCells);
  reader.finish();
}

}  // namespace

CreepLawParameters readCreepLaw(rail::YamlReader reader) {
  CreepLawParameters parameters;
  reader.text("name");
  parameters.method = creepMethodOf(reader.choice("method", creepMethodNames()));
  parameters.friction = readFriction(reader.map("friction"));
  if (parameters.method == CreepMethod::kPolach) {
    parameters.polach = readPolach(reader.map("polach"));
  } else {
    parameters.flexibility =
        flexibilityRuleOf(reader.choiceOr("flexibility", flexibilityRuleNames(), flexibilityRuleNames().front()));
    if (parameters.method != CreepMethod::kFastsim) parameters.reduction = readReduction(reader.map("reduction"));
    if (parameters.method != CreepMethod::kClosed) readGrid(reader.map("grid"), parameters);
  }
  reader.finish();
  return parameters;
}

}  // namespace loco
