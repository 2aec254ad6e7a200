#include "loco_dynamics/loco_factory.hpp"

#include <sstream>

#include "loco_dynamics/loco_1d.hpp"
#include "rail_core/vehicle.hpp"

namespace loco {

namespace {

/// Reader of the map at a dotted path; an index follows the key of its list.
rail::YamlReader readerAt(const rail::Document& document, const std::string& path, rail::Problems& problems) {
  rail::YamlReader reader(document, problems);
  std::istringstream parts(path);
  std::string list_key;
  for (std::string part; std::getline(parts, part, '.');) {
    const bool is_index = !part.empty() && part.find_first_not_of("0123456789") == std::string::npos;
    if (is_index) {
      const std::vector<rail::YamlReader> maps = reader.maps(list_key);
      const std::size_t index = std::stoul(part);
      if (index >= maps.size()) {
        reader.refuse(list_key, "has no entry " + part);
        return reader;
      }
      reader = maps[index];
      list_key.clear();
    } else {
      if (!list_key.empty()) reader = reader.map(list_key);
      list_key = part;
    }
  }
  if (!list_key.empty()) reader = reader.map(list_key);
  return reader;
}

}  // namespace

const std::vector<std::string>& knownModels() {
  static const std::vector<std::string> models = {"1d"};
  return models;
}

double readAdhesionLimit(rail::YamlReader& reader) {
  return reader.number("adhesion_limit", rail::aboveUpTo(0.0, 1.0));
}

std::unique_ptr<Locomotive> makeLocomotive(const rail::Document& scenario, const std::string& key,
                                           rail::Problems& problems) {
  const std::size_t problems_before = problems.count();
  rail::YamlReader root(scenario, problems);
  root.choice("locomotive_model", knownModels());
  const bool rotary_inertia = root.boolean("rotary_inertia");

  rail::YamlReader reader = readerAt(scenario, key, problems);
  const rail::Vehicle vehicle = rail::readVehicle(reader);
  Loco1d::Parameters parameters;
  parameters.mass_kg = vehicle.mass_kg;
  parameters.inertial_mass_kg = vehicle.inertialMass(rotary_inertia);
  parameters.adhesion_limit = readAdhesionLimit(reader);
  if (problems.count() != problems_before) return nullptr;
  return std::make_unique<Loco1d>(parameters);
}

}  // namespace loco
