// The half of DocumentLoader that takes overrides apart and applies them.

#include <algorithm>
#include <iterator>

#include "document_loader.hpp"
#include "rail_core/number_text.hpp"
#include "yaml_nodes.hpp"
#include "yaml_source.hpp"

namespace rail {
namespace {

std::vector<std::string> split(const std::string& path) {
  std::vector<std::string> components(1);
  for (const char c : path) {
    if (c == '.') {
      components.emplace_back();
    } else {
      components.back() += c;
    }
  }
  return components;
}

}  // namespace

/// Takes the overrides apart and sorts them, outer keys first.
void DocumentLoader::readTargets(const std::vector<Override>& overrides) {
  for (const Override& given : overrides) {
    Target target{given.key, given.key, {}, given.value, namesFile(given.key)};
    if (target.is_file) target.path = withoutSuffix(given.key);
    target.components = split(target.path);
    const auto& parts = target.components;
    if (std::any_of(parts.begin(), parts.end(), [](const std::string& part) { return part.empty(); })) {
      problems_.add(kOverrideFile, "key '" + given.key + "'", "must be names with dots between");
    } else if (isReplaced(target.path)) {
      problems_.add(kOverrideFile, given.key, given.value, "is set twice");
    } else {
      targets_.push_back(target);
    }
  }
  std::stable_sort(targets_.begin(), targets_.end(),
                   [](const Target& a, const Target& b) { return a.components.size() < b.components.size(); });
}

/// True if an override sets exactly this path.
bool DocumentLoader::isReplaced(const std::string& path) const {
  return std::any_of(targets_.begin(), targets_.end(), [&](const Target& target) { return target.path == path; });
}

void DocumentLoader::apply(const Target& target) {
  YAML::Node parent;
  if (!descend(target, parent)) return;
  forget(target.path);
  YAML::Node value;
  if (target.is_file) {
    value = include(scalar(target.value, kQuotedTag), {kOverrideFile, target.key, target.path, ""}, target.path);
  } else {
    document_.overridden_.insert(target.path);
    const std::optional<YAML::Node> raw = readYaml(target.value, kOverrideFile, target.key, problems_);
    value = raw ? resolve(*raw, {kOverrideFile, target.path, target.path, ""}) : fail(target.path);
  }
  const std::string& last = target.components.back();
  if (parent.IsSequence()) {
    parent[static_cast<std::size_t>(*parseInteger(last))] = value;
  } else {
    parent[last] = value;
  }
}

/// Makes `parent` the map or list that holds the target's last component. False, with the problem added, if there is
/// none.
bool DocumentLoader::descend(const Target& target, YAML::Node& parent) {
  YAML::Node node = document_.root_;
  std::string path;
  for (std::size_t i = 0; i < target.components.size(); ++i) {
    if (document_.unreadable(path)) return false;  // has been reported
    const std::string& component = target.components[i];
    const bool last = i + 1 == target.components.size();
    const bool new_key = last && node.IsMap();
    const std::string fault = new_key ? "" : stepFault(node, component, path);
    if (!fault.empty()) {
      problems_.add(kOverrideFile, "key '" + target.key + "'", fault);
      return false;
    }
    if (last) break;
    if (node.IsSequence()) {
      node.reset(node[static_cast<std::size_t>(*parseInteger(component))]);
    } else {
      node.reset(node[component]);
    }
    path = joinPath(path, component);
  }
  parent.reset(node);
  return true;
}

/// Why there is nothing at `component` of `node`, which stands at `path`; "" if there is.
std::string DocumentLoader::stepFault(const YAML::Node& node, const std::string& component,
                                      const std::string& path) const {
  if (node.IsMap()) {
    const std::vector<std::string> keys = keysOf(node);
    if (std::find(keys.begin(), keys.end(), component) != keys.end()) return "";
    const std::string near = nearestWord(component, keys);
    if (!near.empty()) return "no such key, nearest '" + joinPath(path, near) + "'";
    return path.empty() ? "no such key" : "no such key in '" + path + "'";
  }
  if (!node.IsSequence()) return "'" + path + "' is neither a map nor a list";
  const std::optional<std::int64_t> index = parseInteger(component);
  const bool in_list = index && *index >= 0 && *index < static_cast<std::int64_t>(node.size());
  if (in_list && std::to_string(*index) == component) return "";  // `00` would be a second name of 0
  return "'" + component + "' must be an index of '" + path + "', which has " + std::to_string(node.size()) +
         " entries, the first at 0";
}

/// Drops what is remembered of a subtree that is about to be replaced.
void DocumentLoader::forget(const std::string& path) {
  auto& files = document_.file_of_subtree_;
  for (auto it = files.begin(); it != files.end();) it = isWithin(it->first, path) ? files.erase(it) : std::next(it);
  auto& keys = document_.file_key_;
  for (auto it = keys.begin(); it != keys.end();) it = isWithin(it->first, path) ? keys.erase(it) : std::next(it);
  auto& unreadable = document_.unreadable_;
  for (auto it = unreadable.begin(); it != unreadable.end();) {
    it = isWithin(*it, path) ? unreadable.erase(it) : std::next(it);
  }
}

}  // namespace rail
