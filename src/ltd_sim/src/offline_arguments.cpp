#include "offline_arguments.hpp"

#include <algorithm>
#include <cmath>

#include "rail_core/command_line.hpp"

namespace ltd {

namespace {

constexpr int kMostJobs = 999;

bool isWhole(const std::string& text, bool sign) {
  const std::size_t first = sign && !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
  return text.size() > first && text.find_first_not_of("0123456789", first) == std::string::npos;
}

/// @return 0 if it is no such number
int readJobs(const std::string& text) { return isWhole(text, false) && text.size() <= 3 ? std::stoi(text) : 0; }

}  // namespace

std::vector<std::string> splitValues(const std::string& text) {
  std::vector<std::string> values(1);
  int depth = 0;
  char quote = 0;
  for (const char c : text) {
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      --depth;
    } else if (c == ',' && depth == 0) {
      values.emplace_back();
      continue;
    }
    values.back() += c;
  }
  return values;
}

bool looksLikeDecimalComma(const std::vector<std::string>& values) {
  constexpr std::size_t kLongest = 15;  // digits that a double tells apart
  if (values.size() != 2 || values[0].size() > kLongest || values[1].size() > kLongest) return false;
  if (!isWhole(values[0], true) || !isWhole(values[1], false)) return false;
  const double first = std::abs(std::stod(values[0]));
  return first == 0.0 || std::stod(values[1]) < first;
}

/// @return empty, or what is wrong with the argument of a --set
std::string OfflineArguments::takeSet(const std::string& argument) {
  const std::size_t equals = argument.find('=');
  if (equals == std::string::npos || equals == 0) return "--set " + argument + ": must read key=value";
  const std::string key = argument.substr(0, equals);
  auto known = std::find_if(sets.begin(), sets.end(), [&](const auto& set) { return set.first == key; });
  if (known == sets.end()) known = sets.insert(sets.end(), {key, {}});
  const std::vector<std::string> values = splitValues(argument.substr(equals + 1));
  for (const std::string& value : values) {
    const bool leading_zero = value.size() > 1 && value[0] == '0' && isWhole(value, false);
    if (values.size() > 1 && leading_zero)
      return "--set " + argument + ": gives the value " + value +
             ", which no number begins with: a comma separates values, decimals need a point";
    if (std::find(known->second.begin(), known->second.end(), value) != known->second.end())
      return "--set " + argument + ": gives the value " + value + " twice; a comma separates values, a run each";
    known->second.push_back(value);
  }
  if (looksLikeDecimalComma(values)) like_decimal_comma_.push_back(argument);
  return {};
}

std::string OfflineArguments::parse(const std::vector<std::string>& arguments) {
  const std::vector<std::string> options = {"--out", "--set", "--jobs", "--no-bag", "--help"};
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& a = arguments[i];
    if (a == "--help" || a == "-h") {
      help = true;
    } else if (a == "--no-bag") {
      bag = false;
    } else if (a == "--out" || a == "--set" || a == "--jobs") {
      if (++i == arguments.size() || rail::isOption(arguments[i])) return a + ": needs a value after it";
      if (a == "--set") {
        const std::string fault = takeSet(arguments[i]);
        if (!fault.empty()) return fault;
      } else if (a == "--jobs") {
        jobs = readJobs(arguments[i]);
        if (jobs == 0)
          return "--jobs " + arguments[i] + ": must be a whole number from 1 to " + std::to_string(kMostJobs);
      } else {
        out = arguments[i];
      }
    } else if (!a.empty() && a[0] == '-') {
      return rail::unknownOption(a, options);
    } else if (scenario.empty()) {
      scenario = a;
    } else {
      return a + ": one scenario at a time (the first was " + scenario + ")";
    }
  }
  if (help) return {};
  if (scenario.empty()) return "SCENARIO.yaml is missing";
  if (out.empty()) return "--out DIR is missing";
  return {};
}

std::string OfflineArguments::announcement() const {
  std::size_t runs = 1;
  std::string lines;
  for (const auto& [key, values] : sets) {
    runs *= values.size();
    if (values.size() < 2) continue;
    lines += "  " + key + " =";
    for (std::size_t i = 0; i < values.size(); ++i) lines += (i == 0 ? " " : "  |  ") + values[i];
    lines += '\n';
  }
  if (runs == 1) return {};
  return std::to_string(runs) +
         " runs, one for each combination of the values given to --set (a comma separates values):\n" + lines;
}

std::string OfflineArguments::commaHints() const {
  std::string lines;
  for (const std::string& argument : like_decimal_comma_) {
    const std::vector<std::string> values = splitValues(argument.substr(argument.find('=') + 1));
    lines += "ltd_offline: --set " + argument + ": is taken as two values, " + values[0] + " and " + values[1] +
             "; if one number was meant, write " + values[0] + "." + values[1] + "\n";
  }
  return lines;
}

std::vector<std::vector<rail::Override>> OfflineArguments::combinations() const {
  std::vector<std::vector<rail::Override>> all(1);
  for (const auto& [key, values] : sets) {
    std::vector<std::vector<rail::Override>> longer;
    for (const std::vector<rail::Override>& shorter : all) {
      for (const std::string& value : values) {
        longer.push_back(shorter);
        longer.back().push_back({key, value});
      }
    }
    all = std::move(longer);
  }
  return all;
}

}  // namespace ltd
