#include "loco_dynamics/loco_factory.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "loco_dynamics/bogie_in_curve.hpp"
#include "loco_dynamics/contact/contact_config.hpp"
#include "loco_dynamics/contact/creepage.hpp"
#include "loco_dynamics/loco_1d.hpp"
#include "loco_dynamics/loco_2d.hpp"
#include "loco_dynamics/loco_3d.hpp"
#include "loco_dynamics/profile/contact_search.hpp"
#include "rail_core/constants.hpp"
#include "rail_core/message_number.hpp"
#include "rail_core/track.hpp"
#include "rail_core/vehicle.hpp"

namespace loco {

using rail::messageNumber;
using rail::Rounding;

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

WheelsOnRails readWheelsOnRails(rail::YamlReader reader, double wheel_radius_m) {
  const std::size_t before = reader.problems().count();
  const WheelRailGeometry geometry = WheelRailGeometry::read(reader, wheel_radius_m);
  if (reader.problems().count() != before) return {};
  return {std::make_shared<const ContactFinderOf<ContactSearch>>(ContactSearch(geometry)),
          geometry.computeClimbRise_m(), computeFlangePlay_m(geometry)};
}

std::unique_ptr<Locomotive> makeLoco3d(rail::YamlReader& root, const LocoDetails& details, const ModelOptions& options,
                                       double adhesion_limit, rail::Nanoseconds micro_step) {
  Loco3d::Parameters p;
  p.structure = details.structure;
  const SpatialOptions spatial = readSpatialOptions(root);
  const std::size_t before = root.problems().count();
  const WheelsOnRails wheels =
      spatial.profiles ? readWheelsOnRails(*spatial.profiles, details.structure.wheel_radius_m) : details.wheels;
  if (root.problems().count() != before) return nullptr;
  p.track = readTrackForBogies(root, details.structure, wheels.flange_play_m);
  if (p.track == nullptr) return nullptr;
  p.finder = wheels.finder;
  p.safety.climb_rise_m = wheels.climb_rise_m;
  p.gravity_stiffness = spatial.gravity_stiffness;
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

bool isSpatial(const std::string& model) { return model == "3d"; }

bool makesCurvingResistance(const std::string& model) { return isSpatial(model); }

ModelOptions readModelOptions(rail::YamlReader& root, rail::Nanoseconds micro_step) {
  ModelOptions options;
  options.rail = readRailConditions(root);
  options.control = adhesion::readController(root.map("control"), micro_step);
  return options;
}

SpatialOptions readSpatialOptions(rail::YamlReader& root) {
  SpatialOptions options;
  if (root.has("profiles")) options.profiles = root.map("profiles");
  options.gravity_stiffness = root.booleanOr("gravity_stiffness", true);
  return options;
}

namespace {

/// What the files of a locomotive say of one and the same thing must agree, and it must be able to stand.
void checkRelations(rail::YamlReader& reader, const rail::Vehicle& vehicle, const LocoDetails& details) {
  const LocoStructure& s = details.structure;
  const PlanarContact::Parameters& c = details.contact;
  rail::YamlReader bodies = reader.map("bodies"), contact = reader.map("contact");
  if (std::abs(s.totalMass() - vehicle.mass_kg) > 1e-9 * vehicle.mass_kg)
    reader.refuse("mass_kg", "must be the sum of the masses in `bodies`, " + rail::exactNumber(s.totalMass()) + " kg");
  if (vehicle.axles != static_cast<int>(BodyLayout::kAxles))
    reader.refuse("axles", "must be " + std::to_string(BodyLayout::kAxles) + ", as many as `bodies` has");
  if (std::abs(s.coupler_x_m - 0.5 * vehicle.length_m) > 1e-6)
    bodies.map("coupler").refuse("x_m",
                                 "must be half of length_m, " + rail::exactNumber(0.5 * vehicle.length_m) + " m");
  const Body& wheelset = s.bodies[BodyLayout::wheelset(0)];
  const double least_kg_m2 = 0.1 * wheelset.mass_kg * s.wheel_radius_m * s.wheel_radius_m;  // a set of thin axles
  if (wheelset.inertia_kg_m2.y() < least_kg_m2)
    bodies.map("wheelsets")
        .refuse("spin_inertia_kg_m2",
                "must be at least m r^2/10, " + messageNumber(least_kg_m2, Rounding::kUp) + " kg m2");
  constexpr double kMostSag_m = 0.4;  // chosen: no suspension gives so much
  const double sag_m = s.computeStaticSag();
  if (!(sag_m <= kMostSag_m))
    reader.refuse("bodies", "is too soft: the car body would sink by " + messageNumber(sag_m) +
                                " m under its weight, at most " + messageNumber(kMostSag_m) + " may be");
  const double G = c.elasticity.young_Pa / (2.0 * (1.0 + c.elasticity.poisson));
  if (std::abs(c.shear_modulus_Pa - G) > 0.05 * G)
    contact.refuse("shear_modulus_Pa",
                   "must be that of young_modulus_Pa and poisson_ratio, " + messageNumber(G) + ", within 5 %");
  constexpr double kMostApproach_m = 0.5e-3;  // chosen: steel gives 0.1 mm
  const double wheel_N = s.totalMass() * rail::kGravity_mps2 / (2.0 * BodyLayout::kAxles);
  const double approach_m = PlanarContact::makeNormalContact(c).computeApproach(wheel_N);
  if (!(approach_m <= kMostApproach_m))
    contact.refuse(c.normal_law == NormalLaw::kLinear ? "linear_stiffness_N_per_m" : "young_modulus_Pa",
                   "is too soft: wheels would sink by " + messageNumber(approach_m) + " m into the rail, at most " +
                       messageNumber(kMostApproach_m) + " may be");
}

}  // namespace

LocoDetails readLocoDetails(rail::YamlReader& reader, const std::string& model, const rail::Vehicle& vehicle) {
  LocoDetails details;
  if (!hasContacts(model) && !reader.has("bodies") && !reader.has("contact") && !reader.has("profiles")) return details;
  const std::size_t problems_before = reader.problems().count();
  details.structure = LocoStructure::read(reader.map("bodies"));
  details.contact = PlanarContact::read(reader.map("contact"), details.structure.wheel_radius_m);
  if (isSpatial(model) || reader.has("profiles"))
    details.wheels = readWheelsOnRails(reader.map("profiles"), details.structure.wheel_radius_m);
  if (reader.problems().count() == problems_before) checkRelations(reader, vehicle, details);
  return details;
}

namespace {

void checkController(rail::YamlReader& root, const adhesion::ControlParameters& control, const LocoStructure& structure,
                     rail::Nanoseconds micro_step) {
  if (control.law != "pi") return;
  const double r = structure.wheel_radius_m;
  const double J = structure.bodies[BodyLayout::wheelset(0)].inertia_kg_m2.y();
  const double period_s = rail::toSeconds(std::max(control.pi.sampling_period, micro_step));
  const double loop = control.pi.pi.proportional_gain_N_m * r * period_s / (J * kCreepageSpeedFloor_mps);  // (A10)
  if (loop < 2.0) return;
  root.map("control").refuse("proportional_gain_N_m",
                             "swings up at low speed: K_p r T_s/(J 0.5 m/s) = " + messageNumber(loop) +
                                 " must be below 2; lower the gain or the sampling period");
}

StepLimit computeMicroStepLimit(const LocoDetails& details) {
  const LocoStructure& s = details.structure;
  const double wheel_N = s.totalMass() * rail::kGravity_mps2 / (2.0 * BodyLayout::kAxles);
  const double stiffness = PlanarContact::makeNormalContact(details.contact).computeTangentStiffness(wheel_N);
  return computeStepLimit(linearise(s, allCoordinates({kX, kZ, kPitch}),
                                    {stiffness, details.contact.normal_damping_N_s_per_m}, {Branch::kStiffest, true}));
}

void checkMicroStep(rail::YamlReader& root, const StepLimit& limit, const std::string& locomotive,
                    rail::Nanoseconds micro_step) {
  if (rail::toSeconds(micro_step) <= limit.largest_s()) return;
  root.map("steps").refuse(
      "micro_step_s", "must be at most " + messageNumber(limit.largest_s(), Rounding::kDown) + " s for " + locomotive +
                          ": mode \"" + limit.mode + "\" at " + messageNumber(limit.frequency_Hz) +
                          " Hz, damping ratio " + messageNumber(limit.damping) + ", grows with steps beyond " +
                          messageNumber(limit.stable_s) + " s, of which " + messageNumber(kStepShare) + " may be used");
}

}  // namespace

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
  const LocoDetails details = readLocoDetails(reader, model, vehicle);
  if (problems.count() == problems_before)
    checkMicroStep(root, computeMicroStepLimit(details), vehicle.name, micro_step);
  if (problems.count() == problems_before) checkController(root, options.control, details.structure, micro_step);
  if (problems.count() != problems_before) return nullptr;
  if (isSpatial(model)) return makeLoco3d(root, details, options, adhesion_limit, micro_step);
  return std::make_unique<Loco2d>(Loco2d::Parameters{details.structure, details.contact, options.rail, options.control,
                                                     adhesion_limit, micro_step});
}

}  // namespace loco
