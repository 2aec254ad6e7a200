#include "ltd_sim/diesel_engine.hpp"

#include <algorithm>

namespace ltd {

namespace {

// Chosen, wider than any engine and fuel: kilowatts given for watts, or megajoules for joules, are noticed.
const rail::Range kRatedPowers = rail::between(1e4, 1e8);
const rail::Range kFuels = rail::between(1e7, 1e8);

}  // namespace

DieselEngine DieselEngine::read(rail::YamlReader reader) {
  DieselEngine engine;
  engine.rated_power_W_ = reader.number("rated_power_W", kRatedPowers);
  engine.idle_fuel_W_ = reader.number("idle_fuel_W", rail::notNegative());
  engine.fuel_J_per_l_ = reader.number("fuel_J_per_l", kFuels);
  engine.efficiency_ = EfficiencyMap::read(reader, "efficiency");
  if (engine.idle_fuel_W_ * engine.efficiency_.computeEfficiency(1.0) >= engine.rated_power_W_)
    reader.refuse("idle_fuel_W", "must be below the fuel that the rated power burns");
  reader.finish();
  return engine;
}

double DieselEngine::computeFuel(double shaft_work_J, double step_s) const {
  const double power_W = shaft_work_J / step_s;
  const double efficiency = efficiency_.computeEfficiency(power_W / rated_power_W_);  // (F8)
  return std::max(shaft_work_J / efficiency, idle_fuel_W_ * step_s);                  // (F7)
}

}  // namespace ltd
