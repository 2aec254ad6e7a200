#pragma once

#include <optional>
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
  std::vector<Section> sections;                            ///< rising, not overlapping
  std::optional<CreepLawParameters> sanded = std::nullopt;  ///< under sand, where the rail offers less than this
};

/// Asks a scenario's root for `adhesion` (usually adhesion_file) and, if it is there, `rail_sections`: a list of
/// {from_km, to_km, adhesion or adhesion_file}, rising and not overlapping; and, if it is there, `sanded_adhesion`: the
/// law under sand. Leaves finish() to the caller.
RailConditions readRailConditions(rail::YamlReader& root);

/// The creep law at every place. Constant after construction.
class CreepLawByPlace {
 public:
  explicit CreepLawByPlace(const RailConditions& rail);
  /// @param location_m  chainage of the wheelset. Allocates nothing.
  /// @param sanding  sand is laid: the sanded law holds where it offers more friction (mu0) than the place does
  const CreepLaw& at(double location_m, bool sanding) const;

 private:
  const CreepLaw& unsanded(double location_m) const;
  struct Section {
    double from_m, to_m;
    CreepLaw law;
  };
  CreepLaw elsewhere_;
  std::vector<Section> sections_;
  std::optional<CreepLaw> sanded_;
};

}  // namespace loco
