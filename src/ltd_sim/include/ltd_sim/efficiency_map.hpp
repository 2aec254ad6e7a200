#pragma once

#include <string>

#include "rail_core/lookup_table.hpp"
#include "rail_core/yaml_reader.hpp"

namespace ltd {

/// Efficiency of an engine over its load: linear in the share of the rated power between the points.     (F8)
/// Below the first point and above the last, which is the rated power, it is that of the point.
///
/// YAML: a list of [share, efficiency]; shares rise from above 0 to exactly 1, efficiencies are above 0 and at most 1,
/// and the fuel, share over efficiency, rises from point to point (then it rises everywhere between them, too).
class EfficiencyMap {
 public:
  static EfficiencyMap read(rail::YamlReader& reader, const std::string& key);

  /// Efficiency [-]. @param share  power over rated power [-], >= 0
  double computeEfficiency(double share) const { return efficiency_of_share_(share); }

 private:
  rail::LookupTable efficiency_of_share_{{1.0}, {1.0}};
};

}  // namespace ltd
