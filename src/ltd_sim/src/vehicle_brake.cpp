#include "ltd_sim/vehicle_brake.hpp"

#include "rail_core/constants.hpp"

namespace ltd {

VehicleBrake VehicleBrake::read(rail::YamlReader reader, const rail::Vehicle& vehicle) {
  VehicleBrake brake;
  reader.text("name");
  brake.shoes = reader.integer("shoes", 1, 8 * vehicle.axles);  // two pairs of shoes on each wheel at most
  const double efficiency = reader.number("rigging_efficiency", rail::aboveUpTo(0.0, 1.0));
  const double weight_N = vehicle.mass_kg * rail::kGravity_mps2;
  // Up to three times the weight: chosen. Cast iron at speed needs about twice; a wrong unit is noticed.
  const double most = 3.0;
  if (reader.has("shoe_force_N") && reader.has("brake_ratio")) {
    reader.number("shoe_force_N", rail::anyNumber());
    reader.number("brake_ratio", rail::anyNumber());
    reader.refuse("brake_ratio", "must not stand beside shoe_force_N: give one of them");
  } else if (reader.has("shoe_force_N")) {
    brake.shoe_force_N = reader.number("shoe_force_N", rail::aboveUpTo(0.0, most * weight_N));
  } else {
    brake.shoe_force_N = weight_N * reader.number("brake_ratio", rail::aboveUpTo(0.0, most));
  }
  brake.shoe_force_N *= efficiency;
  brake.friction = ShoeFriction::read(reader.map("friction"));
  if (reader.has("cylinder")) brake.cylinder = BrakeCylinder::read(reader.map("cylinder"));
  reader.finish();
  return brake;
}

}  // namespace ltd
