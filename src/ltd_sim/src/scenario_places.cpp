#include "scenario_places.hpp"

#include "rail_core/constants.hpp"
#include "rail_core/message_number.hpp"

namespace ltd {

namespace {

using rail::messageKilometres;
using rail::Rounding;

std::string fromTo(double from_m, double to_m) { return messageKilometres(from_m) + " to " + messageKilometres(to_m); }

/// Places that keep a rule when they are typed as they are shown.
std::string allowed(double from_m, double to_m) {
  return "must be " + messageKilometres(from_m, Rounding::kUp) + " to " + messageKilometres(to_m, Rounding::kDown);
}

}  // namespace

std::vector<double> readLocations(rail::YamlReader& reader, const std::string& key, const Bounds& bounds) {
  std::vector<double> locations_m;
  const std::size_t before = reader.problems().count();
  for (const double km : reader.numbers(key, rail::anyNumber())) locations_m.push_back(km * rail::kMetresPerKilometre);
  if (reader.problems().count() != before) return locations_m;
  for (std::size_t i = 0; i < locations_m.size(); ++i) {
    const std::string entry = key + "." + std::to_string(i);
    if (i > 0 && locations_m[i] <= locations_m[i - 1])
      reader.refuse(entry, "must be ahead of the one before, " + messageKilometres(locations_m[i - 1]));
    if (bounds.known && (locations_m[i] < bounds.from_m || locations_m[i] > bounds.to_m))
      reader.refuse(entry,
                    allowed(bounds.from_m, bounds.to_m) + " km, from run.start_location_km to the end of the track");
  }
  return locations_m;
}

void checkEndIsAhead(rail::YamlReader& root, const RunLimits& run, const Bounds& track) {
  if (track.known && (run.start_location_m < track.from_m || run.start_location_m > track.to_m)) return;
  if (run.end_location_m <= run.start_location_m)
    root.map("run").refuse("end_location_km",
                           "must be ahead of start_location_km = " + messageKilometres(run.start_location_m));
}

void checkPlaces(rail::YamlReader& root, const Scenario& scenario) {
  if (scenario.train.locomotives.empty()) return;
  double ahead_m = 0.0, behind_m = 0.0;  // vehicles before and behind the leading locomotive
  const std::size_t lead = scenario.train.locomotives.front().vehicle;
  for (std::size_t i = 0; i < lead; ++i) ahead_m += scenario.train.coupler_distance_m[i];
  for (std::size_t i = lead; i < scenario.train.coupler_distance_m.size(); ++i)
    behind_m += scenario.train.coupler_distance_m[i];
  rail::YamlReader run = root.map("run");
  const double from_m = scenario.track.start_m(), to_m = scenario.track.end_m();
  const double start_m = scenario.run.start_location_m;
  if (start_m - behind_m < from_m || start_m + ahead_m > to_m) {
    const std::string stands = "the train would stand from " + fromTo(start_m - behind_m, start_m + ahead_m) +
                               " km, the track is from " + fromTo(from_m, to_m) + " km";
    const bool fits = from_m + behind_m <= to_m - ahead_m;
    run.refuse("start_location_km", fits ? allowed(from_m + behind_m, to_m - ahead_m) + " for this train: " + stands
                                         : stands + ": the train is longer than the track");
    return;  // the end counts from there
  }
  if (scenario.run.end_location_m + ahead_m > to_m)
    run.refuse("end_location_km", "must be at most " + messageKilometres(to_m - ahead_m, Rounding::kDown) +
                                      ", or the head of the train would be beyond the track, " + fromTo(from_m, to_m) +
                                      " km");
}

void checkRailSections(rail::YamlReader& root, const std::vector<loco::RailConditions::Section>& sections,
                       const rail::Track& track) {
  for (std::size_t i = 0; i < sections.size(); ++i) {
    rail::YamlReader section = root.maps("rail_sections")[i];
    const std::string rule = "is beyond the track, " + fromTo(track.start_m(), track.end_m()) + " km";
    if (sections[i].from_m < track.start_m()) section.refuse("from_km", rule);
    if (sections[i].to_m > track.end_m()) section.refuse("to_km", rule);
  }
}

}  // namespace ltd
