#pragma once

#include <string>
#include <vector>

#include "loco_dynamics/contact/contact_patch.hpp"
#include "loco_dynamics/contact/fastsim.hpp"
#include "loco_dynamics/contact/flexibility.hpp"
#include "loco_dynamics/contact/friction_law.hpp"
#include "loco_dynamics/contact/polach.hpp"
#include "loco_dynamics/contact/reduction_factor.hpp"

namespace loco {

enum class CreepMethod {
  kModfastsim,  ///< FASTSIM with falling friction, Eq. (2), and variable reduction, Eq. (3): the paper's
  kFastsim,     ///< FASTSIM with falling friction, no reduction (k = 1)
  kClosed,      ///< closed form of kModfastsim on an infinitely fine grid; spin is left out
  kPolach       ///< Polach's formula with falling friction
};

/// Names of the methods as users write them, in the order of the enumeration: modfastsim, fastsim, closed, polach.
const std::vector<std::string>& creepMethodNames();
/// @param name  one of creepMethodNames()
CreepMethod creepMethodOf(const std::string& name);
/// Names of the flexibility rules: blended, three.
const std::vector<std::string>& flexibilityRuleNames();
FlexibilityRule flexibilityRuleOf(const std::string& name);

/// How creepage makes force. Parameters that a method does not use do not matter.
struct CreepLawParameters {
  CreepMethod method = CreepMethod::kModfastsim;
  FrictionLaw friction;
  ReductionFactor reduction;                                ///< kModfastsim, kClosed
  PolachFactors polach;                                     ///< kPolach
  FlexibilityRule flexibility = FlexibilityRule::kBlended;  ///< all but kPolach
  int cells = 20;                                           ///< kModfastsim, kFastsim: along rolling
  int strips = 20;                                          ///< kModfastsim, kFastsim: across
};

/// The one door to all creep laws. Constant after construction: one object serves any number of contacts.
class CreepLaw {
 public:
  explicit CreepLaw(const CreepLawParameters& parameters);

  /// Force on the wheel. Allocates nothing, throws nothing. No load or no creepage gives no force.
  CreepForce computeForce(const ContactPatch& patch, const Creepage& creepage) const;

  const CreepLawParameters& parameters() const { return parameters_; }

 private:
  CreepForce computeSimplified(const ContactPatch& patch, const Creepage& creepage, double mu) const;

  CreepLawParameters parameters_;
  FastsimGrid grid_;
};

}  // namespace loco
