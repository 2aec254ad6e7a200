#include "rail_core/vehicle.hpp"

namespace rail {

namespace {

ResistanceCoefficients readResistance(YamlReader reader) {
  ResistanceCoefficients c;
  c.per_mass_N_per_t = reader.number("per_mass_N_per_t", notNegative());
  c.per_axle_N = reader.number("per_axle_N", notNegative());
  c.per_mass_speed_N_per_t_kmph = reader.number("per_mass_speed_N_per_t_kmph", notNegative());
  c.per_speed_squared_N_per_kmph2 = reader.number("per_speed_squared_N_per_kmph2", notNegative());
  c.curving_N_m_per_t = reader.number("curving_N_m_per_t", notNegative());
  reader.finish();
  return c;
}

}  // namespace

Vehicle readVehicle(YamlReader& reader) {
  Vehicle vehicle;
  vehicle.name = reader.text("name");
  vehicle.mass_kg = reader.number("mass_kg", between(1e3, 1e6));
  vehicle.axles = reader.integer("axles", 2, 32);
  vehicle.length_m = reader.number("length_m", aboveUpTo(0.0, 100.0));
  vehicle.rotary_mass_kg_per_axle = reader.number("rotary_mass_kg_per_axle", notNegative());
  vehicle.resistance = readResistance(reader.map("resistance"));
  return vehicle;
}

}  // namespace rail
