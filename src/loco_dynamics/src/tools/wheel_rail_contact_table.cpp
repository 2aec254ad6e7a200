#include "wheel_rail_contact_table.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>

#include "loco_dynamics/profile/patch_pressure.hpp"
#include "loco_dynamics/profile/profile_file.hpp"
#include "loco_dynamics/profile/standard_profiles.hpp"
#include "loco_dynamics/profile/standing_wheelset.hpp"
#include "rail_core/number_text.hpp"

namespace loco {

namespace {

constexpr char kProgram[] = "wheel_rail_contact";
constexpr double kPi = 3.14159265358979323846;
constexpr double kMillimetresPerMetre = 1e3;

std::string shown(double value) { return rail::formatNumber(value, 9); }

/// Points of a named profile or of a file; empty with a problem if there are none.
ProfilePoints findProfile(ProfileKind kind, const std::string& option, const std::string& name,
                          rail::Problems& problems) {
  const bool is_wheel = kind == ProfileKind::kWheel;
  const ProfilePoints named = is_wheel ? makeWheelPoints(name) : makeRailPoints(name);
  if (!named.empty()) return named;
  std::string text;
  if (std::filesystem::is_regular_file(name)) {
    std::ifstream file(name);
    text.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  if (text.empty()) {
    const std::vector<std::string>& names = is_wheel ? wheelProfileNames() : railProfileNames();
    std::string known;
    for (const std::string& each : names) known += each + ", ";
    const std::string near = rail::nearestWord(name, names);
    problems.add(kProgram, option + " " + name,
                 "must be one of " + known + "or a CSV file that can be read" +
                     (near.empty() ? "" : ", did you mean " + near + "?"));
    return {};
  }
  return readProfileCsv(kind, text, name, problems);
}

/// The name of the option from which a misfit comes.
std::string optionOf(const std::string& key) { return key == "gauge_mm" ? "--gauge" : "--" + key; }

void writePatches(std::ostream& output, Side side, double lateral_mm, double yaw_mrad, const StandingWheelset& standing,
                  const WheelRailGeometry& geometry) {
  constexpr double kPascalPerMegapascal = 1e6;
  const double sign = side == Side::kLeft ? 1.0 : -1.0;
  const LoadedWheel& wheel = standing.wheel[static_cast<std::size_t>(side)];
  for (std::size_t i = 0; i < wheel.count; ++i) {
    const LoadedPatch& patch = wheel.patch[i];
    const double a_mm = patch.ellipse.a_m * kMillimetresPerMetre, b_mm = patch.ellipse.b_m * kMillimetresPerMetre;
    const double area_mm2 = kPi * a_mm * b_mm;
    const double p_max_MPa = computePatchPressure(geometry, standing, side, i, {}) / kPascalPerMegapascal;
    output << (side == Side::kLeft ? "left" : "right");
    for (const double value :
         {lateral_mm, yaw_mrad, static_cast<double>(i + 1),
          (sign * patch.region.p_T.y() - geometry.railTop_m()) * kMillimetresPerMetre,
          -patch.region.p_T.z() * kMillimetresPerMetre, sign * patch.region.angle_rad,
          patch.region.rolling_radius_m * kMillimetresPerMetre, patch.normal_N, a_mm, b_mm, area_mm2, p_max_MPa}) {
      output << ',' << shown(value + 0.0);
    }
    output << '\n';
  }
}

/// Cross-sections in the rail's frame, the wheel as it lies when the wheelset is centred and its radius touches z = 0.
bool writeSections(const std::string& path, const WheelRailGeometry& geometry) {
  std::ofstream file(path);
  file << "body,y_mm,z_mm\n";
  constexpr double kStep_m = 0.25e-3;
  const auto write = [&](const char* body, const HeightTable& table, double offset_m) {
    for (double y_m = table.begin_m(); y_m <= table.end_m(); y_m += kStep_m) {
      file << body << ',' << shown((y_m + offset_m) * kMillimetresPerMetre) << ','
           << shown(table.at(y_m).z_m * kMillimetresPerMetre) << '\n';
    }
  };
  write("wheel", geometry.wheel(), geometry.tapingLine_m() - geometry.railTop_m());
  write("rail", geometry.rail(), 0.0);
  return static_cast<bool>(file.flush());
}

/// A new file with the points of a profile. Adds the problem if it cannot be written or is there already: it may be
/// somebody's measured wheel.
void writeCopy(ProfileKind kind, const std::string& option, const std::string& path, const ProfilePoints& points,
               rail::Problems& problems) {
  if (path.empty()) return;
  const std::string given = option + " " + path;
  std::error_code unreadable;
  if (std::filesystem::exists(path, unreadable)) {
    problems.add(kProgram, given, "is there already: remove it first, or give another name");
    return;
  }
  std::ofstream file(path);
  file << profileCsv(kind, points);
  file.close();
  if (!file) problems.add(kProgram, given, "cannot be written");
}

/// @return false if a displacement was refused
bool writeTable(const WheelRailContactArguments& arguments, const WheelRailGeometry& geometry, std::ostream& output,
                std::ostream& errors) {
  constexpr double kRadiansPerMilliradian = 1e-3;
  const WheelsetStand stand(geometry, {});
  bool all_stand = true;
  output << "side,y_mm,yaw_mrad,patch,y_rail_mm,z_rail_mm,angle_rad,rolling_radius_mm,normal_force_N,a_mm,b_mm,"
            "area_mm2,p_max_MPa\n";
  for (const double lateral_mm : arguments.lateral_mm) {
    // right and nose right are + here, left is + in the library
    const StandingWheelset standing =
        stand.compute({-lateral_mm / kMillimetresPerMetre, -arguments.yaw_mrad * kRadiansPerMilliradian,
                       arguments.load_N, arguments.friction});
    if (!standing.stands) {
      errors << "wheel_rail_contact: --lateral " << shown(lateral_mm)
             << ": the wheelset does not stand on both rails\n";
      all_stand = false;
      continue;
    }
    for (const Side side : {Side::kLeft, Side::kRight}) {
      writePatches(output, side, lateral_mm, arguments.yaw_mrad, standing, geometry);
    }
  }
  return all_stand;
}

}  // namespace

int wheelRailContactProgram(const std::vector<std::string>& arguments, std::ostream& output, std::ostream& errors) {
  WheelRailContactArguments parsed;
  const std::string wrong = parsed.parse(arguments);
  if (!wrong.empty()) {
    errors << "wheel_rail_contact: " << wrong << "\nwheel_rail_contact --help tells more\n";
    return 2;
  }
  if (parsed.help) {
    output << kWheelRailContactHelp;
    return 0;
  }
  rail::Problems problems;
  const ProfilePoints wheel = findProfile(ProfileKind::kWheel, "--wheel", parsed.wheel, problems);
  const ProfilePoints rail = findProfile(ProfileKind::kRail, "--rail", parsed.rail, problems);
  if (problems.empty()) {
    writeCopy(ProfileKind::kWheel, "--write-wheel", parsed.wheel_copy, wheel, problems);
    writeCopy(ProfileKind::kRail, "--write-rail", parsed.rail_copy, rail, problems);
  }
  if (problems.empty() && !parsed.contacts) return 0;
  if (problems.empty()) {
    const WheelRailGeometry geometry(wheel, rail, parsed.dimensions);
    for (const WheelRailGeometry::Misfit& misfit : geometry.findMisfits()) {
      problems.add(kProgram, optionOf(misfit.key), misfit.rule);
    }
    if (problems.empty()) {
      if (!parsed.sections_file.empty() && !writeSections(parsed.sections_file, geometry)) {
        errors << "wheel_rail_contact: --sections " << parsed.sections_file << ": cannot be written\n";
        return 2;
      }
      return writeTable(parsed, geometry, output, errors) ? 0 : 2;
    }
  }
  for (const std::string& line : problems.lines()) errors << line << '\n';
  return 2;
}

}  // namespace loco
