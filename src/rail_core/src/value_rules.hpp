#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

#include "rail_core/yaml_reader.hpp"

namespace rail {

bool isQuoted(const YAML::Node& node);
bool isPlainScalar(const YAML::Node& node);

/// A value as messages show it.
std::string shown(const YAML::Node& node);

bool keepsRule(double number, const Range& range);

/// The rule in words: "must be a number > 0 and <= 1".
std::string wordsFor(const Range& range);
std::string wordsForInteger(int low, int high);

inline constexpr char kMapRule[] = "must be a map";
inline constexpr char kListRule[] = "must be a list";
inline constexpr char kBooleanRule[] = "must be true or false";
inline constexpr char kTextRule[] = "must be text, and not empty";
std::string choiceRule(const std::vector<std::string>& allowed);

/// Some number that keeps the rule, to go on reading with.
double harmlessValue(const Range& range);

}  // namespace rail
