#include "wheel_rail_contact_arguments.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "rail_core/command_line.hpp"
#include "rail_core/number_text.hpp"

namespace loco {

const char* const kWheelRailContactHelp =
    R"(usage: wheel_rail_contact --load N --lateral MM[,MM...] [OPTION VALUE]...
       wheel_rail_contact [--wheel NAME] --write-wheel FILE.csv   (likewise --rail, --write-rail)

Where and how the wheels of a wheelset touch their rails. For each lateral displacement height and roll are found so that the
wheelset stands on both rails with the given load, rolling freely and steadily; one row a contact patch on standard output:
  side,y_mm,yaw_mrad,patch,y_rail_mm,z_rail_mm,angle_rad,rolling_radius_mm,normal_force_N,a_mm,b_mm,area_mm2,p_max_MPa

  --wheel NAME|FILE      S1002 (default), coned_1_20, or a CSV of points
  --rail NAME|FILE       UIC60 (default), or a CSV of points
  --inclination N        the rails lean 1:N to the track's centre, 40 if not given; 0: they stand upright
  --gauge MM             1435 if not given, 14 mm below the tops of the inclined rails
  --flange-back MM       distance of the flanges' backs, 1360 if not given
  --radius MM            of the wheels at the taping line, 70 mm from the flange's back; 533.5 if not given
  --load N               vertical load a wheel
  --lateral MM[,MM...]   displacements of the wheelset to the right
  --yaw MRAD             + turns the nose to the right, 0 if not given
  --friction MU          0.3 if not given: spin and yaw press a rolling wheel up or down its rail, which changes its normal
                         force; 0 leaves that out
  --sections FILE        writes the cross-sections of wheel and rail there, for `rosrun train_viz contact_plot`
  --write-wheel FILE     writes the wheel's points there, a file to start from and to read again with --wheel or wheel_file;
  --write-rail FILE      likewise the rail's, not inclined. No file is overwritten. Without --load and --lateral this is all

Columns: y_rail_mm is counted from the rail's highest point to the field side, z_rail_mm from there down, on both sides;
angle_rad is that of the contact plane, positive on the treads and more so on the flanges, on both sides. a_mm (in rolling
direction), b_mm are the semi-axes of the ellipse with which the simulator computes, area_mm2 its area; p_max_MPa is the largest
pressure of elastic half-spaces with the shape of the profiles, not of the ellipse.
Files have the columns y_mm,z_mm: y to the field side (a wheel's from its taping line, its flange at y < 0), z down, flange's back
or gauge face first. A displacement at which the wheelset does not stand is named on standard error and left out. Exit status: 0 all
computed, 2 something refused.
)";

namespace {

/// An option that takes one number.
struct NumberOption {
  double low, high;
  const char* rule;
};

// generous: from a model's wheels to a mining truck's; beyond, the unit is wrong
const std::map<std::string, NumberOption> kNumbers{
    {"--inclination", {0.0, 1e6, "must be 0 (upright) or >= 10 (1:10)"}},
    {"--gauge", {500.0, 2000.0, "must be a number >= 500 and <= 2000 (mm)"}},
    {"--flange-back", {400.0, 1900.0, "must be a number >= 400 and <= 1900 (mm)"}},
    {"--radius", {150.0, 1000.0, "must be a number >= 150 and <= 1000 (mm)"}},
    {"--load", {1.0, 1e6, "must be a number >= 1 and <= 1e6 (N)"}},
    {"--yaw", {-50.0, 50.0, "must be a number >= -50 and <= 50 (mrad)"}},
    {"--friction", {0.0, 1.0, "must be a number >= 0 and <= 1"}}};

}  // namespace

std::string WheelRailContactArguments::take(const std::string& option, const std::string& value) {
  constexpr double kMetresPerMillimetre = 1e-3;
  const std::string given = option + " " + value;
  const auto found = kNumbers.find(option);
  if (found != kNumbers.end()) {
    const std::optional<double> number = rail::parseNumber(value);
    if (!number || *number < found->second.low || *number > found->second.high ||
        (option == "--inclination" && *number > 0.0 && *number < 10.0)) {
      return given + ": " + found->second.rule;
    }
    if (option == "--inclination") dimensions.inclination = *number;
    if (option == "--gauge") dimensions.gauge_m = *number * kMetresPerMillimetre;
    if (option == "--flange-back") dimensions.flange_back_m = *number * kMetresPerMillimetre;
    if (option == "--radius") dimensions.wheel_radius_m = *number * kMetresPerMillimetre;
    if (option == "--load") load_N = *number;
    if (option == "--yaw") yaw_mrad = *number;
    if (option == "--friction") friction = *number;
    return {};
  }
  if (option != "--lateral") {
    std::string* const text = option == "--wheel"         ? &wheel
                              : option == "--rail"        ? &rail
                              : option == "--write-wheel" ? &wheel_copy
                              : option == "--write-rail"  ? &rail_copy
                                                          : &sections_file;
    *text = value;
    return value.empty() ? given + ": must not be empty" : std::string();
  }
  for (std::size_t begin = 0; begin <= value.size();) {
    const std::size_t end = std::min(value.find(',', begin), value.size());
    const std::optional<double> number = rail::parseNumber(value.substr(begin, end - begin));
    if (!number || std::abs(*number) > 50.0) return given + ": must be numbers >= -50 and <= 50 (mm), with commas";
    lateral_mm.push_back(*number);
    begin = end + 1;
  }
  return {};
}

std::string WheelRailContactArguments::parse(const std::vector<std::string>& arguments) {
  std::vector<std::string> options{"--wheel", "--rail", "--lateral", "--sections", "--write-wheel", "--write-rail"};
  for (const auto& [name, range] : kNumbers) options.push_back(name);
  std::set<std::string> seen;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& option = arguments[i];
    if (option == "--help" || option == "-h") {
      help = true;
      return {};
    }
    if (std::find(options.begin(), options.end(), option) == options.end()) return rail::unknownOption(option, options);
    if (!seen.insert(option).second) return option + ": given twice";
    if (++i == arguments.size() || rail::isOption(arguments[i])) return option + ": needs a value after it";
    const std::string wrong = take(option, arguments[i]);
    if (!wrong.empty()) return wrong;
  }
  const bool writes = !wheel_copy.empty() || !rail_copy.empty();
  contacts = !writes || seen.count("--load") + seen.count("--lateral") > 0;
  if (!contacts) return {};
  if (seen.count("--load") == 0) return "--load: must be given (N)";
  if (seen.count("--lateral") == 0) return "--lateral: must be given (mm)";
  return {};
}

}  // namespace loco
