#include "ltd_sim/energy_storage.hpp"

#include <algorithm>

namespace ltd {

namespace {

// Chosen, wider than anything on rails (0.03 kWh to 280 MWh): kilowatt hours given for joules are noticed.
const rail::Range kCapacities = rail::between(1e5, 1e12);
// Chosen, wider than any: kilowatts given for watts are noticed.
const rail::Range kPowers = rail::between(1e4, 1e8);

}  // namespace

EnergyStorage EnergyStorage::read(rail::YamlReader reader) {
  EnergyStorage storage;
  storage.capacity_J_ = reader.number("capacity_J", kCapacities);
  storage.lowest_share_ = reader.number("lowest_share", rail::between(0.0, 1.0));
  storage.highest_share_ = reader.number("highest_share", rail::aboveUpTo(0.0, 1.0));
  storage.initial_share_ = reader.number("initial_share", rail::between(0.0, 1.0));
  storage.charge_power_W_ = reader.number("charge_power_W", kPowers);
  storage.discharge_power_W_ = reader.number("discharge_power_W", kPowers);
  storage.charge_efficiency_ = reader.number("charge_efficiency", rail::aboveUpTo(0.0, 1.0));
  storage.discharge_efficiency_ = reader.number("discharge_efficiency", rail::aboveUpTo(0.0, 1.0));
  if (storage.highest_share_ <= storage.lowest_share_) reader.refuse("highest_share", "must be above lowest_share");
  if (storage.initial_share_ < storage.lowest_share_ || storage.initial_share_ > storage.highest_share_)
    reader.refuse("initial_share", "must be from lowest_share to highest_share");
  reader.finish();
  return storage;
}

double EnergyStorage::computeLargestOut(double stored_J, double step_s) const {
  const double held_J = (stored_J - lowestEnergy()) * discharge_efficiency_;
  return std::max(std::min(discharge_power_W_ * step_s, held_J), 0.0);
}

double EnergyStorage::computeLargestIn(double stored_J, double step_s) const {
  const double room_J = (highestEnergy() - stored_J) / charge_efficiency_;
  return std::max(std::min(charge_power_W_ * step_s, room_J), 0.0);
}

double EnergyStorage::stepOut(double asked_J, double step_s, double& stored_J) const {
  const double out_J = std::min(asked_J, computeLargestOut(stored_J, step_s));
  stored_J = std::max(stored_J - out_J / discharge_efficiency_, lowestEnergy());  // (F10); the max only rounds
  return out_J;
}

double EnergyStorage::stepIn(double offered_J, double step_s, double& stored_J) const {
  const double in_J = std::min(offered_J, computeLargestIn(stored_J, step_s));
  stored_J = std::min(stored_J + in_J * charge_efficiency_, highestEnergy());  // (F9); the min only rounds
  return in_J;
}

}  // namespace ltd
