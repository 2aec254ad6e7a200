#pragma once

#include <string>
#include <vector>

#include "ltd_sim/power_supply.hpp"
#include "supply_texts.hpp"
#include "train_fixtures.hpp"

/// Supplies of supply_texts.hpp, and a step of them.
namespace fixtures {

constexpr double kSupplyStep = 2.0;   // s
constexpr double kTinyEnergy = 1e-8;  // J, round-off of some MJ

inline ltd::PowerSupply readSupply(const std::string& text) {
  return fixtures::readMap(text, [](rail::YamlReader reader) { return ltd::PowerSupply::read(reader, 0.0); });
}
inline ltd::PowerSupply diesel() { return readSupply(supplyHead("diesel") + engineText()); }
inline ltd::PowerSupply hybrid() { return readSupply(supplyHead("diesel_storage") + engineText() + storageText()); }
inline ltd::PowerSupply battery() { return readSupply(supplyHead("storage") + storageText()); }
inline ltd::PowerSupply line(bool regenerates) {
  return readSupply(supplyHead("overhead_line") + lineText(regenerates));
}
inline std::vector<ltd::PowerSupply> allKinds() { return {diesel(), hybrid(), battery(), line(true), line(false)}; }

/// One step of 2 s from the initial state.
inline ltd::PowerSupply::State after(const ltd::PowerSupply& supply, double rim_work_J) {
  ltd::PowerSupply::State state = supply.initialState();
  supply.step(ltd::RimWork(rim_work_J), kSupplyStep, state);
  EXPECT_NEAR(state.residual(), 0.0, kTinyEnergy);
  return state;
}

}  // namespace fixtures
