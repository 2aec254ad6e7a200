#include "loco_dynamics/loco_factory.hpp"

#include <cmath>
#include <cstdio>
#include <sstream>

#include "loco_dynamics/contact/contact_config.hpp"
#include "loco_dynamics/loco_1d.hpp"
#include "loco_dynamics/loco_2d.hpp"
#include "loco_dynamics/loco_3d.hpp"
#include "loco_dynamics/profile/contact_search.hpp"
#include "rail_core/constants.hpp"
#include "rail_core/track.hpp"
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

std::shared_ptr<const ContactFinder> readFinder(rail::YamlReader reader, double wheel_radius_m) {
  const std::size_t before = reader.problems().count();
  const WheelRailGeometry geometry = WheelRailGeometry::read(reader, wheel_radius_m);
  if (reader.problems().count() != before) return nullptr;
  return std::make_shared<const ContactFinderOf<ContactSearch>>(ContactSearch(geometry));
}

/// The scenario's track, where a bogie's rigid wheelbase fits into all curves.
std::shared_ptr<const rail::Track> readTrack(rail::YamlReader& root, const LocoStructure& structure) {
  const std::size_t before = root.problems().count();
  auto track = std::make_shared<const rail::Track>(rail::Track::read(root.map("track")));
  if (root.problems().count() != before) return nullptr;
  constexpr double kLargestOffset_m = 0.015;  // chosen: as much as flanges have play between the rails
  const double wheelbase_m = structure.bodies[BodyLayout::wheelset(0)].p_T.x() -
                             structure.bodies[BodyLayout::wheelset(BodyLayout::kAxlesPerBogie - 1)].p_T.x();
  const double smallest_m = wheelbase_m * wheelbase_m / (8.0 * kLargestOffset_m);
  if (track->largestCurvature() * smallest_m > 1.0) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "has a curve of %.4g m radius; a bogie with a wheelbase of %.4g m needs at least %.4g m",
                  1.0 / track->largestCurvature(), wheelbase_m, smallest_m);
    root.refuse("track", text);
    return nullptr;
  }
  return track;
}

std::unique_ptr<Locomotive> makeLoco3d(rail::YamlReader& root, const LocoDetails& details, const ModelOptions& options,
                                       double adhesion_limit, rail::Nanoseconds micro_step) {
  Loco3d::Parameters p;
  p.structure = details.structure;
  p.track = readTrack(root, details.structure);
  if (p.track == nullptr) return nullptr;
  p.finder = details.finder;
  p.contact = {details.structure.wheel_radius_m, details.contact.normal_damping_N_s_per_m, details.contact.elasticity,
               details.contact.shear_modulus_Pa};
  p.rail = options.rail;
  p.control = options.control;
  p.adhesion_limit = adhesion_limit;
  p.micro_step = micro_step;
  return std::make_unique<Loco3d>(p);
}

}  // namespace

const std::vector<std::string>& knownModels() {
  static const std::vector<std::string> models = {"1d", "2d", "3d"};
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

bool makesCurvingResistance(const std::string& model) { return model == "3d"; }

ModelOptions readModelOptions(rail::YamlReader& root, rail::Nanoseconds micro_step) {
  ModelOptions options;
  options.rail = readRailConditions(root);
  options.control = adhesion::readController(root.map("control"), micro_step);
  return options;
}

LocoDetails readLocoDetails(rail::YamlReader& reader, const std::string& model, double vehicle_mass_kg) {
  LocoDetails details;
  if (!hasContacts(model) && !reader.has("bodies") && !reader.has("contact") && !reader.has("profiles")) return details;
  const std::size_t problems_before = reader.problems().count();
  details.structure = LocoStructure::read(reader.map("bodies"));
  details.contact = PlanarContact::read(reader.map("contact"), details.structure.wheel_radius_m);
  if (model == "3d" || reader.has("profiles"))
    details.finder = readFinder(reader.map("profiles"), details.structure.wheel_radius_m);
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
  const std::vector<Dof> dofs =
      model == "3d" ? std::vector<Dof>{kX, kY, kZ, kRoll, kPitch, kYaw} : std::vector<Dof>{kX, kZ, kPitch};
  return computeStepLimit(linearise(s, allCoordinates(dofs), {stiffness, details.contact.normal_damping_N_s_per_m},
                                    {Branch::kStiffest, true}));
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
  if (model == "3d") return makeLoco3d(root, details, options, adhesion_limit, micro_step);
  return std::make_unique<Loco2d>(Loco2d::Parameters{details.structure, details.contact, options.rail, options.control,
                                                     adhesion_limit, micro_step});
}

}  // namespace loco
