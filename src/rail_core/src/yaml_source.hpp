#pragma once

#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>

#include "rail_core/problems.hpp"

namespace rail {

/// Tags that yaml-cpp gives to scalars without an explicit one.
inline constexpr char kPlainTag[] = "?";
inline constexpr char kQuotedTag[] = "!";

/// A dotted path with one more component.
inline std::string joinPath(const std::string& path, const std::string& key) {
  return path.empty() ? key : path + "." + key;
}
inline std::string joinPath(const std::string& path, std::size_t index) {
  return joinPath(path, std::to_string(index));
}

/// True if `path` is `ancestor` or lies below it.
inline bool isWithin(const std::string& path, const std::string& ancestor) {
  if (ancestor.empty() || path == ancestor) return true;
  return path.size() > ancestor.size() && path.compare(0, ancestor.size(), ancestor) == 0 &&
         path[ancestor.size()] == '.';
}

/// The whole content of a file; nothing if it is no file or cannot be read.
std::optional<std::string> readFile(const std::string& path);

/// One YAML document of a subset of which nothing can be lost or read in two ways. Refused: syntax errors, several
/// documents, anchors and aliases, explicit tags, keys that are given twice, are no text, are empty or hold a dot.
/// @param key  where in `file` the text stands, for messages ("" for a whole file)
std::optional<YAML::Node> readYaml(const std::string& text, const std::string& file, const std::string& key,
                                   Problems& problems);

}  // namespace rail
