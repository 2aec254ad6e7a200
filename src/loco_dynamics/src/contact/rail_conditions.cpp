#include "loco_dynamics/contact/rail_conditions.hpp"

#include "loco_dynamics/contact/contact_config.hpp"
#include "rail_core/constants.hpp"

namespace loco {

RailConditions readRailConditions(rail::YamlReader& root) {
  RailConditions rail;
  rail.elsewhere = readCreepLaw(root.map("adhesion"));
  if (root.has("sanded_adhesion")) rail.sanded = readCreepLaw(root.map("sanded_adhesion"));
  if (!root.has("rail_sections")) return rail;
  for (rail::YamlReader& reader : root.maps("rail_sections")) {
    RailConditions::Section section;
    section.from_m = reader.number("from_km", rail::anyNumber()) * rail::kMetresPerKilometre;
    section.to_m = reader.number("to_km", rail::anyNumber()) * rail::kMetresPerKilometre;
    if (section.to_m <= section.from_m) reader.refuse("to_km", "must be ahead of from_km");
    if (!rail.sections.empty() && section.from_m < rail.sections.back().to_m)
      reader.refuse("from_km", "must not be before the end of the section before it");
    section.creep = readCreepLaw(reader.map("adhesion"));
    reader.finish();
    rail.sections.push_back(section);
  }
  return rail;
}

CreepLawByPlace::CreepLawByPlace(const RailConditions& rail) : elsewhere_(rail.elsewhere) {
  for (const RailConditions::Section& s : rail.sections) sections_.push_back({s.from_m, s.to_m, CreepLaw(s.creep)});
  if (rail.sanded) sanded_.emplace(*rail.sanded);
}

const CreepLaw& CreepLawByPlace::at(double location_m, bool sanding) const {
  const CreepLaw& law = unsanded(location_m);
  const bool better = sanding && sanded_ && sanded_->parameters().friction.mu0 > law.parameters().friction.mu0;
  return better ? *sanded_ : law;
}

const CreepLaw& CreepLawByPlace::unsanded(double location_m) const {
  // A line has few sections; a search by halves would cost more than it saves below some dozens.
  for (const Section& section : sections_)
    if (location_m >= section.from_m && location_m < section.to_m) return section.law;
  return elsewhere_;
}

}  // namespace loco
