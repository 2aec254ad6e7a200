#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

namespace rail {

/// A tree from readYaml as YAML text. Unlike yaml-cpp's emitter it keeps quoted scalars quoted, so that reading the
/// text again gives the same tree.
std::string writeYaml(const YAML::Node& node);

}  // namespace rail
