#include <string>

#include "loco_dynamics/profile/profile_file.hpp"
#include "loco_dynamics/profile/standard_profiles.hpp"
#include "loco_dynamics/profile/wheel_rail_geometry.hpp"

namespace loco {

namespace {

constexpr double kMetresPerMillimetre = 1e-3;

/// A profile's name, or what `wheel_file` or `rail_file` has put in its place; empty if refused.
ProfilePoints readProfile(rail::YamlReader& reader, ProfileKind kind) {
  const bool is_wheel = kind == ProfileKind::kWheel;
  const std::string key = is_wheel ? "wheel" : "rail";
  const std::string file = reader.has(key) ? reader.file(key) : "";
  const bool is_file = file.size() > 4 && file.compare(file.size() - 4, 4, ".csv") == 0;  // not --set, not YAML
  const std::string text = reader.text(key);
  if (text.empty()) return {};  // has been reported
  if (is_file || text.find('\n') != std::string::npos) {
    return readProfileCsv(kind, text, file, reader.problems());
  }
  const std::vector<std::string>& names = is_wheel ? wheelProfileNames() : railProfileNames();
  const ProfilePoints points = is_wheel ? makeWheelPoints(text) : makeRailPoints(text);
  if (points.empty()) {
    std::string known;
    for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
    reader.refuse(key, "must be one of " + known + ", or " + key + "_file must name a CSV");
  }
  return points;
}

}  // namespace

WheelRailGeometry WheelRailGeometry::read(rail::YamlReader reader, double wheel_radius_m) {
  const std::size_t before = reader.problems().count();
  reader.textOr("name", "profiles");
  const ProfilePoints wheel = readProfile(reader, ProfileKind::kWheel);
  const ProfilePoints rail = readProfile(reader, ProfileKind::kRail);
  WheelRailDimensions dimensions;
  dimensions.wheel_radius_m = wheel_radius_m;
  dimensions.inclination = reader.number("inclination", rail::notNegative());
  // a head inclined more than 1:10 could not be a rail's; 0 is upright
  if (dimensions.inclination > 0.0 && dimensions.inclination < 10.0) {
    reader.refuse("inclination", "must be 0 (upright) or >= 10 (1:10)");
  }
  dimensions.gauge_m = kMetresPerMillimetre * reader.number("gauge_mm", rail::between(500.0, 2000.0));
  dimensions.flange_back_m = kMetresPerMillimetre * reader.number("flange_back_mm", rail::between(400.0, 1900.0));
  reader.finish();
  if (reader.problems().count() != before) return WheelRailGeometry();
  const WheelRailGeometry geometry(wheel, rail, dimensions);
  for (const Misfit& misfit : geometry.findMisfits()) reader.refuse(misfit.key, misfit.rule);
  return reader.problems().count() == before ? geometry : WheelRailGeometry();
}

}  // namespace loco
