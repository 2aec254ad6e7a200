#include "loco_dynamics/loco_factory.hpp"

#include <cmath>
#include <cstdio>
#include <sstream>

#include "loco_dynamics/contact/contact_config.hpp"
#include "loco_dynamics/loco_1d.hpp"
#include "loco_dynamics/loco_2d.hpp"
#include "rail_core/constants.hpp"
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
  static const std::vector<std::string> models = {"1d", "2d"};
  return models;
}

double readAdhesionLimit(rail::YamlReader& reader) {
  return reader.number("adhesion_limit", rail::aboveUpTo(0.0, 1.0));
}

std::string readModel(rail::YamlReader& reader) { return reader.choice("locomotive_model", knownModels()); }

std::string readModelOr(rail::YamlReader& group, const std::string& scenario_model) {
  return group.has("locomotive_model") ? readModel(group) : scenario_model;
}

bool hasContacts(const std::string& model) { return model != "1d"; }

ModelOptions readModelOptions(rail::YamlReader& root, rail::Nanoseconds micro_step) {
  ModelOptions options;
  options.rail = readRailConditions(root);
  options.control = adhesion::readController(root.map("control"), micro_step);
  return options;
}

LocoDetails readLocoDetails(rail::YamlReader& reader, const std::string& model, double vehicle_mass_kg) {
  LocoDetails details;
  if (!hasContacts(model) && !reader.has("bodies") && !reader.has("contact")) return details;
  const std::size_t problems_before = reader.problems().count();
  details.structure = LocoStructure::read(reader.map("bodies"));
  details.contact = PlanarContact::read(reader.map("contact"), details.structure.wheel_radius_m);
  if (reader.problems().count() != problems_before) return details;
  const double sum_kg = details.structure.totalMass();
  if (std::abs(sum_kg - vehicle_mass_kg) > 1e-9 * vehicle_mass_kg)
    reader.refuse("mass_kg", "must be the sum of the bodies' masses, " + std::to_string(sum_kg) + " kg");
  return details;
}

StepLimit computeMicroStepLimit(const LocoDetails& details, const std::string& model) {
  if (!hasContacts(model)) return {};
  const LocoStructure& s = details.structure;
  const double wheel_N = s.totalMass() * rail::kGravity_mps2 / (2.0 * BodyLayout::kAxles);
  const double stiffness = PlanarContact::makeNormalContact(details.contact).computeTangentStiffness(wheel_N);
  return computeStepLimit(linearise(s, allCoordinates({kX, kZ, kPitch}),
                                    {stiffness, details.contact.normal_damping_N_s_per_m}, {Branch::kStiffest, true}));
}

void checkMicroStep(rail::YamlReader& root, const StepLimit& limit, const std::string& locomotive,
                    rail::Nanoseconds micro_step) {
  if (rail::toSeconds(micro_step) <= limit.largest_s()) return;
  char text[256];
  std::snprintf(text, sizeof text,
                "must be at most %.4g s for %s: mode \"%s\" at %.4g Hz, damping ratio %.2g, grows with steps beyond "
                "%.4g s, of which %g may be used",
                std::floor(limit.largest_s() * 1e6) / 1e6, locomotive.c_str(), limit.mode.c_str(), limit.frequency_Hz,
                limit.damping, limit.stable_s, kStepShare);
  root.map("steps").refuse("micro_step_s", text);
}

std::unique_ptr<Locomotive> makeLocomotive(const rail::Document& scenario, const std::string& key,
                                           rail::Problems& problems) {
  const std::size_t problems_before = problems.count();
  rail::YamlReader root(scenario, problems);
  const std::string scenario_model = readModel(root);
  rail::YamlReader group = readerAt(scenario, key.substr(0, key.rfind('.')), problems);
  const std::string model = readModelOr(group, scenario_model);
  rail::YamlReader reader = readerAt(scenario, key, problems);
  const rail::Vehicle vehicle = rail::readVehicle(reader);
  const double adhesion_limit = readAdhesionLimit(reader);
  if (!hasContacts(model)) {
    const bool rotary_inertia = root.boolean("rotary_inertia");
    if (problems.count() != problems_before) return nullptr;
    return std::make_unique<Loco1d>(
        Loco1d::Parameters{vehicle.mass_kg, vehicle.inertialMass(rotary_inertia), adhesion_limit});
  }
  const rail::Nanoseconds micro_step =
      rail::wholeNanoseconds(root.map("steps").number("micro_step_s", rail::positive())).value_or(0);
  const ModelOptions options = readModelOptions(root, micro_step);
  const LocoDetails details = readLocoDetails(reader, model, vehicle.mass_kg);
  if (problems.count() == problems_before)
    checkMicroStep(root, computeMicroStepLimit(details, model), vehicle.name, micro_step);
  if (problems.count() != problems_before) return nullptr;
  return std::make_unique<Loco2d>(Loco2d::Parameters{details.structure, details.contact, options.rail, options.control,
                                                     adhesion_limit, micro_step});
}

}  // namespace loco
