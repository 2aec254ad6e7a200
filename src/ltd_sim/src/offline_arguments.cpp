#include "offline_arguments.hpp"

#include <algorithm>

namespace ltd {

namespace {

constexpr int kMostJobs = 999;

/// @return 0 if it is no such number
int readJobs(const std::string& text) {
  if (text.empty() || text.size() > 3 || text.find_first_not_of("0123456789") != std::string::npos) return 0;
  return std::stoi(text);
}

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

std::string OfflineArguments::parse(const std::vector<std::string>& arguments) {
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& a = arguments[i];
    if (a == "--help" || a == "-h") {
      help = true;
    } else if (a == "--no-bag") {
      bag = false;
    } else if (a == "--out" || a == "--set" || a == "--jobs") {
      if (++i == arguments.size()) return a + ": needs a value after it";
      if (a == "--out") {
        out = arguments[i];
        continue;
      }
      if (a == "--jobs") {
        jobs = readJobs(arguments[i]);
        if (jobs == 0)
          return "--jobs " + arguments[i] + ": must be a whole number from 1 to " + std::to_string(kMostJobs);
        continue;
      }
      const std::size_t equals = arguments[i].find('=');
      if (equals == std::string::npos || equals == 0) return "--set " + arguments[i] + ": must read key=value";
      const std::string key = arguments[i].substr(0, equals);
      auto known = std::find_if(sets.begin(), sets.end(), [&](const auto& set) { return set.first == key; });
      if (known == sets.end()) known = sets.insert(sets.end(), {key, {}});
      for (const std::string& value : splitValues(arguments[i].substr(equals + 1))) {
        if (std::find(known->second.begin(), known->second.end(), value) != known->second.end())
          return "--set " + arguments[i] + ": gives the value " + value +
                 " twice; a comma separates values, a run each";
        known->second.push_back(value);
      }
    } else if (!a.empty() && a[0] == '-') {
      return a + ": unknown option";
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
