#include "scenario_names.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

namespace ltd {

namespace {

std::vector<std::string> scenariosIn(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code unreadable;  // a folder that is not there holds none
  for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable))
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

void checkScenarioExists(const std::string& path, rail::Problems& problems) {
  const std::filesystem::path file = path;
  std::error_code unreadable;
  if (std::filesystem::exists(file, unreadable)) return;
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const std::vector<std::string> names = scenariosIn(folder);
  std::string rule = "scenario " + file.stem().string() + " does not exist; ";
  if (names.empty()) rule += "there are none in " + folder.string();
  for (std::size_t i = 0; i < names.size(); ++i) rule += (i == 0 ? "there are: " : ", ") + names[i];
  problems.add(path, "", rule);
}

}  // namespace ltd
