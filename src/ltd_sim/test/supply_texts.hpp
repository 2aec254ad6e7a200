#pragma once

#include <string>

/// Supplies with round numbers, so that each stage can be done by hand.
namespace fixtures {

/// Drivetrain 0.8; auxiliaries 10 kW and a tenth of the rim power.
inline std::string supplyHead(const std::string& kind) {
  return "name: test\nkind: " + kind +
         "\ndrivetrain_efficiency: 0.8\nauxiliary_power_W: 1.0e4\nauxiliary_share_of_rim_power: 0.1\n";
}
/// 1 MW; 0.2 at a fifth, 0.4 at three fifths, 0.5 at full power; generator 0.7.
inline std::string engineText() {
  return "engine: {rated_power_W: 1.0e6, idle_fuel_W: 1.0e4, fuel_J_per_l: 36.0e6, "
         "efficiency: [[0.2, 0.2], [0.6, 0.4], [1.0, 0.5]]}\ngenerator_efficiency: 0.7\n";
}
/// 10 MJ, between 1 and 9, 5 at the start; in 0.4 MW at 0.9, out 0.5 MW at 0.95.
inline std::string storageText() {
  return "storage: {capacity_J: 1.0e7, lowest_share: 0.1, highest_share: 0.9, initial_share: 0.5, "
         "charge_power_W: 4.0e5, discharge_power_W: 5.0e5, charge_efficiency: 0.9, discharge_efficiency: 0.95}\n";
}
inline std::string lineText(bool regenerates) {
  return std::string("line: {efficiency: 0.75, regenerates: ") + (regenerates ? "true}\n" : "false}\n");
}

/// `text` with the first `from`, which must be there, replaced by `to`.
inline std::string changed(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace fixtures
