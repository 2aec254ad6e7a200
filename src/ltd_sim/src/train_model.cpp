#include "ltd_sim/train_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "loco_dynamics/loco_factory.hpp"
#include "rail_core/constants.hpp"

namespace ltd {

namespace {

constexpr std::size_t kMostVehicles = 5000;  // chosen: longer than any train, and a typing error is found

/// Builds a TrainModel group by group.
class TrainBuilder {
 public:
  TrainBuilder(TrainModel& train, const std::string& model, bool rotary_inertia)
      : train_(train), model_(model), rotary_inertia_(rotary_inertia) {}

  std::size_t addCoupler(rail::YamlReader reader) {
    train_.coupler_types.emplace_back(Coupler::read(reader));
    return train_.coupler_types.size() - 1;
  }

  void addGroups(rail::YamlReader& parent, std::size_t default_coupler) {
    std::vector<rail::YamlReader> groups = parent.maps("groups");
    if (groups.empty() && parent.has("groups")) parent.refuse("groups", "must have at least one group");
    for (rail::YamlReader& group : groups) addGroup(group, default_coupler);
  }

  /// Joins neighbours once all vehicles are there.
  void joinVehicles() {
    for (std::size_t i = 0; i + 1 < train_.vehicles.size(); ++i) {
      train_.coupler_distance_m.push_back(0.5 * (train_.vehicles[i].length_m + train_.vehicles[i + 1].length_m));
      train_.coupler_type.push_back(coupler_behind_[i]);
    }
  }

 private:
  void addGroup(rail::YamlReader& group, std::size_t default_coupler) {
    if (group.has("repeat")) {
      addRepeated(group, default_coupler);
      return;
    }
    const bool locomotive = group.choice("kind", {"locomotive", "wagon"}) == "locomotive";
    const int count = group.integer("count", 1, static_cast<int>(kMostVehicles));
    const std::size_t coupler = group.has("coupler") ? addCoupler(group.map("coupler")) : default_coupler;
    rail::YamlReader reader = group.map("vehicle");
    rail::Vehicle vehicle = rail::readVehicle(reader);
    LocoUnit unit;
    if (locomotive) {
      unit = readLocomotive(group, reader);
      loco::readLocoDetails(reader, unit.model, vehicle);
      if (loco::makesCurvingResistance(unit.model)) vehicle.resistance.curving_N_m_per_t = 0.0;
    }
    VehicleBrake brake;
    if (reader.has("brake")) brake = VehicleBrake::read(reader.map("brake"), vehicle);
    // A locomotive whose wheelsets spin in its own model has their inertia there.
    const bool rotary_inertia = rotary_inertia_ && !(locomotive && loco::hasContacts(unit.model));
    reader.finish();
    group.finish();
    if (!roomFor(group, "count", static_cast<std::size_t>(count))) return;
    for (int i = 0; i < count; ++i) {
      if (locomotive) {
        unit.vehicle = train_.vehicles.size();
        train_.locomotives.push_back(unit);
      }
      train_.vehicles.push_back(vehicle);
      train_.brakes.push_back(brake);
      train_.inertial_mass_kg.push_back(vehicle.inertialMass(rotary_inertia));
      coupler_behind_.push_back(coupler);
    }
  }

  void addRepeated(rail::YamlReader& group, std::size_t default_coupler) {
    const int repeat = group.integer("repeat", 1, static_cast<int>(kMostVehicles));
    const std::size_t first = train_.vehicles.size();
    const std::size_t first_loco = train_.locomotives.size();
    addGroups(group, default_coupler);
    group.finish();
    const std::size_t length = train_.vehicles.size() - first;
    const std::size_t locos = train_.locomotives.size() - first_loco;
    if (!roomFor(group, "repeat", static_cast<std::size_t>(repeat - 1) * length)) return;
    for (std::size_t r = 1; r < static_cast<std::size_t>(repeat); ++r) {
      for (std::size_t j = 0; j < locos; ++j) {
        train_.locomotives.push_back(train_.locomotives[first_loco + j]);
        train_.locomotives.back().vehicle += r * length;
      }
      for (std::size_t i = 0; i < length; ++i) {
        train_.vehicles.push_back(train_.vehicles[first + i]);
        train_.brakes.push_back(train_.brakes[first + i]);
        train_.inertial_mass_kg.push_back(train_.inertial_mass_kg[first + i]);
        coupler_behind_.push_back(coupler_behind_[first + i]);
      }
    }
  }

  LocoUnit readLocomotive(rail::YamlReader& group, rail::YamlReader& vehicle) {
    LocoUnit unit;
    unit.key = vehicle.path();
    unit.model = loco::readModelOr(group, model_);
    unit.adhesion_limit = loco::readAdhesionLimit(vehicle);
    unit.type = train_.traction.size();
    const std::size_t problems_before = vehicle.problems().count();
    const TractionCharacteristic traction = TractionCharacteristic::read(vehicle.map("traction"));
    const bool known_traction = vehicle.problems().count() == problems_before;
    train_.traction.push_back(traction);
    const double full_power_W = known_traction ? traction.computeRimPowerLimit(traction.notches()) : 0.0;
    const bool braked = vehicle.has("dynamic_brake");
    train_.dynamic_brakes.push_back(braked ? DynamicBrake::read(vehicle.map("dynamic_brake")) : DynamicBrake());
    const bool supplied = vehicle.has("supply");
    train_.supplies.push_back(supplied ? PowerSupply::read(vehicle.map("supply"), full_power_W) : PowerSupply());
    const std::string name = group.text("notch_group");
    const auto known = std::find(train_.notch_groups.begin(), train_.notch_groups.end(), name);
    unit.notch_group = static_cast<std::size_t>(known - train_.notch_groups.begin());
    if (known == train_.notch_groups.end()) train_.notch_groups.push_back(name);
    return unit;
  }

  bool roomFor(rail::YamlReader& group, const std::string& key, std::size_t more) {
    if (train_.vehicles.size() + more <= kMostVehicles) return true;
    group.refuse(key, "makes a train of more than " + std::to_string(kMostVehicles) + " vehicles");
    return false;
  }

  TrainModel& train_;
  std::string model_;
  bool rotary_inertia_;
  std::vector<std::size_t> coupler_behind_;  ///< per vehicle
};

}  // namespace

double TrainModel::grossMass_t() const {
  double mass_kg = 0.0;
  for (const rail::Vehicle& vehicle : vehicles) mass_kg += vehicle.mass_kg;
  return mass_kg / rail::kKilogramsPerTonne;
}

TrainModel TrainModel::read(rail::YamlReader reader, const std::string& locomotive_model, bool rotary_inertia) {
  TrainModel train;
  TrainBuilder builder(train, locomotive_model, rotary_inertia);
  train.name = reader.text("name");
  const std::size_t coupler = builder.addCoupler(reader.map("coupler"));
  builder.addGroups(reader, coupler);
  builder.joinVehicles();
  if (train.locomotives.empty() && !train.vehicles.empty())
    reader.refuse("groups", "must have at least one locomotive (a group of kind: locomotive)");
  reader.finish();
  return train;
}

double computeDesignCouplerForce(const TrainModel& train) {
  double sum_N = 0.0;
  for (const LocoUnit& unit : train.locomotives) {
    const double adhesion_N = unit.adhesion_limit * train.vehicles[unit.vehicle].mass_kg * rail::kGravity_mps2;
    sum_N += std::min(adhesion_N, train.traction[unit.type].largestForce());
  }
  return sum_N;
}

StepBound computeStepBound(const TrainModel& train, double coupler_force_N) {
  const auto stiffness = [&](std::size_t coupler) {
    return train.coupler_types[train.coupler_type[coupler]].stiffnessUpTo(coupler_force_N);
  };
  const auto friction = [&](std::size_t coupler) {
    const Coupler::Parameters& p = train.coupler_types[train.coupler_type[coupler]].parameters();
    return 0.5 * (1.0 - p.unloading_ratio) * coupler_force_N / p.smoothing_speed_mps;
  };
  StepBound bound{std::numeric_limits<double>::infinity(), 0};
  const std::size_t n = train.vehicles.size();
  for (std::size_t i = 0; i < n; ++i) {
    double k = 0.0, c = 0.0;
    if (i > 0) k += stiffness(i - 1), c += friction(i - 1);
    if (i + 1 < n) k += stiffness(i), c += friction(i);
    k *= 2.0 / train.inertial_mass_kg[i];
    c *= 2.0 / train.inertial_mass_kg[i];
    if (k <= 0.0) continue;
    const double step_s = 4.0 / (c + std::sqrt(c * c + 4.0 * k));  // positive root of H^2 k + 2 H c = 4       (T6)
    if (step_s < bound.largest_step_s) bound = {step_s, i};
  }
  return bound;
}

}  // namespace ltd
