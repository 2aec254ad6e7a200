#pragma once

#include <memory>
#include <optional>
#include <string>

#include "adhesion_control/controller_factory.hpp"
#include "loco_dynamics/contact/rail_conditions.hpp"
#include "loco_dynamics/contact_finder.hpp"
#include "loco_dynamics/loco_structure.hpp"
#include "loco_dynamics/locomotive.hpp"
#include "loco_dynamics/planar_contact.hpp"
#include "loco_dynamics/step_limit.hpp"
#include "rail_core/document.hpp"
#include "rail_core/vehicle.hpp"
#include "rail_core/yaml_reader.hpp"

namespace loco {

/// The models that a scenario may name in `locomotive_model`.
const std::vector<std::string>& knownModels();

/// Asks a scenario's root, or a group of locomotives in its train, for `locomotive_model`.
std::string readModel(rail::YamlReader& reader);
/// The same of a group, which goes by the scenario's model if it names none.
std::string readModelOr(rail::YamlReader& group, const std::string& scenario_model);

/// True if the model computes its bodies and contacts itself, so that it needs `adhesion`, `control`, `bodies`.
bool hasContacts(const std::string& model);

/// True if its bodies move in all directions, on wheels and rails with profiles: 3d.
bool isSpatial(const std::string& model);

/// True if its wheels make the curving resistance themselves, so that Eq. (6) must not be added: 3d.
bool makesCurvingResistance(const std::string& model);

/// Asks a locomotive's map for adhesion_limit: largest traction over weight [-]; leaves finish() to the caller.
double readAdhesionLimit(rail::YamlReader& reader);

/// What a scenario's root says for locomotives with wheel-rail contact.
struct ModelOptions {
  RailConditions rail;
  adhesion::ControlParameters control;
};

/// Asks the scenario's root for `adhesion`, `rail_sections` and `control` (usually adhesion_file, control_file), which
/// every model but 1d needs and a train of 1d alone must not have.
/// @param micro_step  h [ns]; <= 0 if it is not known
ModelOptions readModelOptions(rail::YamlReader& root, rail::Nanoseconds micro_step);

/// What a scenario's root may say for 3D locomotives; a train without any of them must not have it.
struct SpatialOptions {
  std::optional<rail::YamlReader> profiles;  ///< of all 3D locomotives, in place of their own
  bool gravity_stiffness = true;             ///< forces act at the displaced points
};

/// Asks the scenario's root for `profiles` (usually profiles_file) and `gravity_stiffness`, both optional.
SpatialOptions readSpatialOptions(rail::YamlReader& root);

/// A wheelset's profiles on their track.
struct WheelsOnRails {
  std::shared_ptr<const ContactFinder> finder;
  double climb_rise_m = 0.0;   ///< see WheelRailGeometry
  double flange_play_m = 0.0;  ///< see computeFlangePlay_m()
};

/// What a locomotive's own map says of its bodies and contacts.
struct LocoDetails {
  LocoStructure structure;
  PlanarContact::Parameters contact;  ///< its geometry is the 2D model's, its material that of all
  WheelsOnRails wheels;               ///< from `profiles`; no finder if they are not there
};

/// Asks a locomotive's map for `bodies` and `contact`, which every model but 1d needs, and `profiles` (usually
/// profiles_file), which 3d needs; checks that they agree with the vehicle and with each other, and that the locomotive
/// can stand; leaves finish() to the caller. What a model does not need may be there and is checked.
LocoDetails readLocoDetails(rail::YamlReader& reader, const std::string& model, const rail::Vehicle& vehicle);

/// Makes the locomotive whose map stands at the dotted path `key` of a resolved scenario, e.g. train.groups.0.vehicle,
/// with the model that its group or the scenario's root names and the options that the root gives. Refused as well: a
/// micro step longer than this locomotive bears (wheels at the tangent of their static load, pins on their stiff
/// branch), a controller whose loop swings up at low speed (A10). What is wrong goes to `problems`, then the result is
/// null.
std::unique_ptr<Locomotive> makeLocomotive(const rail::Document& scenario, const std::string& key,
                                           rail::Problems& problems);

}  // namespace loco
