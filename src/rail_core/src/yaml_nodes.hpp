#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

namespace rail {

/// What stands for the file in messages about overrides.
inline const std::string kOverrideFile = "--set";

/// Ending of a key whose value is the path of a file with the content.
inline const std::string kFileSuffix = "_file";

inline bool namesFile(const std::string& key) {
  return key.size() > kFileSuffix.size() &&
         key.compare(key.size() - kFileSuffix.size(), kFileSuffix.size(), kFileSuffix) == 0;
}

inline std::string withoutSuffix(const std::string& key) { return key.substr(0, key.size() - kFileSuffix.size()); }

/// A scalar with kPlainTag or kQuotedTag.
inline YAML::Node scalar(const std::string& text, const char* tag) {
  YAML::Node node(text);
  node.SetTag(tag);
  return node;
}

inline std::vector<std::string> keysOf(const YAML::Node& map) {
  std::vector<std::string> keys;
  for (const auto& pair : map) keys.push_back(pair.first.Scalar());
  return keys;
}

}  // namespace rail
