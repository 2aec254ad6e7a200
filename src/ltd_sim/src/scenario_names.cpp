#include "scenario_names.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

namespace ltd {

namespace {

using Path = std::filesystem::path;

/// A YAML file of other content is none: tracks, trains and drivers have not these keys side by side.
bool isScenario(const Path& file) {
  std::error_code unreadable;
  if (file.extension() != ".yaml" || !std::filesystem::is_regular_file(file, unreadable)) return false;
  try {
    const YAML::Node root = YAML::LoadFile(file.string());
    return root.IsMap() && root["locomotive_model"] && (root["run"] || root["run_file"]) &&
           (root["train"] || root["train_file"]);
  } catch (const YAML::Exception&) {
    return false;  // whoever names it is told why
  }
}

std::vector<std::string> scenariosIn(const Path& folder) {
  std::vector<std::string> names;
  std::error_code unreadable;  // a folder that is not there holds none
  for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable))
    if (isScenario(entry.path())) names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

void checkScenarioExists(const std::string& path, rail::Problems& problems) {
  const Path file = path;
  std::error_code unreadable;
  if (std::filesystem::exists(file, unreadable)) return;
  const Path given = file.has_parent_path() ? file.parent_path() : ".";
  const Path shipped = "config/scenarios";
  const std::string name = file.stem().string();
  Path folder = given.lexically_normal();
  std::vector<std::string> names = scenariosIn(folder);
  if (names.empty()) names = scenariosIn(folder = shipped);
  std::string rule = "scenario " + name + " does not exist";
  if (names.empty()) {
    problems.add(path, "", rule + "; there are none in " + given.string());
    return;
  }
  names = rail::nearestFirst(name, names);
  if (rail::isMisspeltBeginning(name, names.front()))
    rule += ", did you mean " + (folder / (names.front() + ".yaml")).string() + "?";
  rule += "; in " + folder.string() + " there are: ";
  for (std::size_t i = 0; i < names.size(); ++i) rule += (i == 0 ? "" : ", ") + names[i];
  problems.add(path, "", rule);
}

}  // namespace ltd
