#pragma once

#include <vector>

#include "loco_dynamics/contact/creep_law.hpp"
#include "rail_core/yaml_reader.hpp"

namespace loco {

/// The rail's condition by place: friction and creep law, as a scenario gives them.
struct RailConditions {
  struct Section {
    double from_m = 0.0, to_m = 0.0;  ///< chainages; from inclusive, to exclusive
    CreepLawParameters creep;
  };
  CreepLawParameters elsewhere;
  std::vector<Section> sections;  ///< rising, not overlapping
};

/// Asks a scenario's root for `adhesion` (usually adhesion_file) and, if it is there, `rail_sections`: a list of
/// {from_km, to_km, adhesion or adhesion_file}, rising and not overlapping; leaves finish() to the caller.
RailConditions readRailConditions(rail::YamlReader& root);

/// The creep law at every place. Constant after construction.
class CreepLawByPlace {
 public:
  explicit CreepLawByPlace(const RailConditions& rail);
  /// @param location_m  chainage of the wheelset. Allocates nothing.
  const CreepLaw& at(double location_m) const;

 private:
  struct Section {
    double from_m, to_m;
    CreepLaw law;
  };
  CreepLaw elsewhere_;
  std::vector<Section> sections_;
};

}  // namespace loco
