#include "creep_force_arguments.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

#include "rail_core/command_line.hpp"
#include "rail_core/number_text.hpp"

namespace loco {

const char* const kCreepForceHelp =
    R"(usage: creep_force [--method METHOD] [--grid CELLSxSTRIPS] [--flexibility RULE] [--k-a X --k-s X] < CASES.csv

Creep forces of elliptic wheel-rail contacts. Reads cases as CSV on standard input and writes the same rows with the columns
Fx_N,Fy_N appended on standard output. The first line names the columns, in any order:
  a_mm,b_mm           semi-axes of the contact, a in rolling direction
                      or curvature_along_1pm,curvature_across_1pm (both bodies together): Hertz's ellipse for N_N, with
                      the column E_GPa, 210 without
  N_N                 normal force
  V_mps               speed; V times the creepages' magnitude is the slip speed that friction depends on
  mu0,A,B_s_per_m     friction mu = mu0 ((1 - A) exp(-B w) + A);  A = 1 is Coulomb's law
  k0,alpha_inf,beta   variable reduction factor; must be there for modfastsim and closed, other methods do not use them
  creep_x,creep_y,spin_rad_per_m  ratios, 0.07 for 7 %: -100 to 100, and a slip of V times creep of 60 m/s at most
  G_GPa,nu            optional, 82 and 0.28 without
  kA,kS               optional, reduction factors of Polach's formula: without them --k-a and --k-s, or 1 (no reduction)
Lines that begin with # and empty ones are left out. Signs are CONTACT's: creepage is the velocity of body 1 relative to
body 2 over V, force is that on body 1, so Fx < 0 for creep_x > 0; rigid slip is creep_x - spin y, creep_y + spin x.

  --method METHOD       modfastsim (default): FASTSIM with falling friction and variable reduction factor
                        fastsim: FASTSIM with falling friction, without reduction
                        closed: modfastsim on an infinitely fine grid, for rows without spin
                        polach: Polach's formula with falling friction
  --grid CELLSxSTRIPS   grid of modfastsim and fastsim, 20x20 if not given, each 1 to 1000
  --flexibility RULE    blended (default): three flexibilities at small creepage, one in full slip, as CONTACT;
                        three: always three. Not for polach.
  --k-a X, --k-s X      k_A and k_S of polach for all rows

A bad row is named with its line on standard error and left out of the output; the others are computed, each with its own
inputs beside it. Exit status: 0 all rows computed, 2 some rows refused, or the columns or the command line (then nothing is
computed).
)";

namespace {

/// Nothing if `text` is not a number > 0 and <= 1.
std::optional<double> parseFactor(const std::string& text) {
  const std::optional<double> value = rail::parseNumber(text);
  return value && *value > 0.0 && *value <= 1.0 ? value : std::nullopt;
}

bool parseCount(const std::string& text, int& count) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  return error == std::errc() && end == text.data() + text.size() && count >= 1 && count <= FastsimGrid::kMostCells;
}

bool isOneOf(const std::string& name, const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string joined(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

}  // namespace

std::string CreepForceArguments::parse(const std::vector<std::string>& arguments) {
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& option = arguments[i];
    if (option == "--help" || option == "-h") {
      help = true;
      return {};
    }
    const std::vector<std::string> options = {"--method", "--grid", "--flexibility", "--k-a", "--k-s"};
    if (option.empty() || option[0] != '-')
      return option + ": is no option: cases are read from standard input, creep_force < CASES.csv";
    if (!isOneOf(option, options)) return rail::unknownOption(option, options);
    if (++i == arguments.size() || rail::isOption(arguments[i])) return option + ": needs a value after it";
    const std::string& value = arguments[i];
    const std::string given = option + " " + value;
    if (option == "--method") {
      if (!isOneOf(value, creepMethodNames())) return given + ": must be one of " + joined(creepMethodNames());
      method = creepMethodOf(value);
    } else if (option == "--grid") {
      const std::size_t x = value.find('x');
      if (x == std::string::npos || !parseCount(value.substr(0, x), cells) ||
          !parseCount(value.substr(x + 1), strips)) {
        return given + ": must read CELLSxSTRIPS, each 1 to 1000";
      }
      grid_given = true;
    } else if (option == "--flexibility") {
      if (!isOneOf(value, flexibilityRuleNames())) return given + ": must be one of " + joined(flexibilityRuleNames());
      flexibility = flexibilityRuleOf(value);
      flexibility_given = true;
    } else {
      std::optional<double>& factor = option == "--k-a" ? k_A : k_S;
      factor = parseFactor(value);
      if (!factor) return given + ": must be a number > 0 and <= 1";
    }
  }
  return checkTogether();
}

std::string CreepForceArguments::checkTogether() const {
  const bool polach = method == CreepMethod::kPolach;
  if (k_A.has_value() != k_S.has_value()) return "--k-a and --k-s must be given together";
  if (k_A && !polach) return "--k-a and --k-s are for --method polach";
  if (k_A && *k_S > *k_A) return "--k-s: must not be larger than --k-a";
  if (grid_given && (polach || method == CreepMethod::kClosed)) return "--grid is for --method modfastsim or fastsim";
  if (flexibility_given && polach) return "--flexibility is not for --method polach";
  return {};
}

}  // namespace loco
