#include "document_loader.hpp"

#include <algorithm>
#include <filesystem>

#include "number_text.hpp"
#include "yaml_source.hpp"

namespace rail {
namespace {

const std::string kFileSuffix = "_file";
const std::string kOverrideFile = "--set";

bool namesFile(const std::string& key) {
  return key.size() > kFileSuffix.size() &&
         key.compare(key.size() - kFileSuffix.size(), kFileSuffix.size(), kFileSuffix) == 0;
}

std::string withoutSuffix(const std::string& key) { return key.substr(0, key.size() - kFileSuffix.size()); }

/// One name for a file, however the path to it is written.
std::string identity(const std::string& file) {
  std::error_code error;
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(file, error);
  return error ? file : canonical.string();
}

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

YAML::Node scalar(const std::string& text, const char* tag) {
  YAML::Node node(text);
  node.SetTag(tag);
  return node;
}

std::vector<std::string> keysOf(const YAML::Node& map) {
  std::vector<std::string> keys;
  for (const auto& pair : map) keys.push_back(pair.first.Scalar());
  return keys;
}

}  // namespace

void DocumentLoader::load(const std::string& path, const std::vector<Override>& overrides) {
  readTargets(overrides);
  const std::optional<std::string> text = readFile(path);
  if (!text) problems_.add(path, "", "cannot be read");
  const std::string directory = std::filesystem::path(path).parent_path().string();
  open_files_ = {path};
  setRoot(text ? readYaml(*text, path, "", problems_) : std::nullopt, {path, "", "", directory});
  open_files_.clear();
  if (document_.unreadable("")) return;
  for (const Target& target : targets_) apply(target);
}

void DocumentLoader::parse(const std::string& text, const std::string& name) {
  files_allowed_ = false;
  setRoot(readYaml(text, name, "", problems_), {name, "", "", ""});
}

void DocumentLoader::setRoot(const std::optional<YAML::Node>& raw, const Cursor& cursor) {
  document_.file_of_subtree_[""] = cursor.file;
  document_.root_ = YAML::Node(YAML::NodeType::Map);
  if (raw && raw->IsMap()) {
    document_.root_ = resolve(*raw, cursor);
    return;
  }
  if (raw) problems_.add(cursor.file, "", "must be a map");
  document_.unreadable_.insert("");
}

/// A copy of `raw` of its own, with all `NAME_file` keys in it resolved.
YAML::Node DocumentLoader::resolve(const YAML::Node& raw, const Cursor& cursor) {
  if (raw.IsMap()) return resolveMap(raw, cursor);
  if (raw.IsScalar()) {
    // A plain scalar of several lines becomes text: it cannot be written again as it stood.
    const bool text = raw.Tag() == kQuotedTag || raw.Scalar().find('\n') != std::string::npos;
    return scalar(raw.Scalar(), text ? kQuotedTag : kPlainTag);
  }
  if (!raw.IsSequence()) return YAML::Node(YAML::NodeType::Null);
  YAML::Node list(YAML::NodeType::Sequence);
  std::size_t index = 0;
  for (const auto& entry : raw) {
    Cursor inner = cursor;
    inner.local = joinPath(cursor.local, index);
    inner.path = joinPath(cursor.path, index);
    list.push_back(resolve(entry, inner));
    ++index;
  }
  return list;
}

YAML::Node DocumentLoader::resolveMap(const YAML::Node& raw, const Cursor& cursor) {
  const std::vector<std::string> keys = keysOf(raw);
  YAML::Node map(YAML::NodeType::Map);
  for (const auto& pair : raw) {
    const std::string& key = pair.first.Scalar();
    Cursor inner = cursor;
    inner.local = joinPath(cursor.local, key);
    inner.path = joinPath(cursor.path, key);
    if (!namesFile(key)) {
      map.force_insert(key, resolve(pair.second, inner));
      continue;
    }
    const std::string name = withoutSuffix(key);
    if (std::find(keys.begin(), keys.end(), name) != keys.end()) {
      problems_.add(cursor.file, inner.local, "stands beside '" + name + "', only one may be given");
      continue;
    }
    map.force_insert(name, include(pair.second, inner, joinPath(cursor.path, name)));
  }
  return map;
}

/// The content of the file that the scalar `raw` names; it will stand at `path`.
YAML::Node DocumentLoader::include(const YAML::Node& raw, const Cursor& cursor, const std::string& path) {
  if (isReplaced(path) && cursor.file != kOverrideFile) return YAML::Node(YAML::NodeType::Null);
  if (!raw.IsScalar() || raw.Scalar().empty()) {
    problems_.add(cursor.file, cursor.local, "must be the path of a file");
    return fail(path);
  }
  const std::string& name = raw.Scalar();
  if (!files_allowed_) {
    problems_.add(cursor.file, cursor.local, name, "files cannot be named here, the text must be complete");
    return fail(path);
  }
  const std::string file = (std::filesystem::path(cursor.directory) / name).lexically_normal().string();
  const std::string extension = std::filesystem::path(file).extension().string();
  if (extension != ".yaml" && extension != ".csv") {
    problems_.add(cursor.file, cursor.local, name, "must end in .yaml or .csv");
    return fail(path);
  }
  const std::string round = circle(file);
  if (!round.empty()) {
    problems_.add(cursor.file, cursor.local, name, "includes itself: " + round);
    return fail(path);
  }
  const std::optional<std::string> text = readFile(file);
  if (!text) {
    problems_.add(cursor.file, cursor.local, name, "cannot read '" + file + "'");
    return fail(path);
  }
  document_.file_of_subtree_[path] = file;
  if (extension == ".csv") return scalar(*text, kQuotedTag);
  return includeYaml(*text, file, path);
}

YAML::Node DocumentLoader::includeYaml(const std::string& text, const std::string& file, const std::string& path) {
  const std::optional<YAML::Node> raw = readYaml(text, file, "", problems_);
  if (!raw) return fail(path);
  open_files_.push_back(file);
  const std::string directory = std::filesystem::path(file).parent_path().string();
  YAML::Node node = resolve(*raw, {file, "", path, directory});
  open_files_.pop_back();
  return node;
}

/// `a.yaml -> b.yaml -> a.yaml` if `file` is being read already, otherwise "".
std::string DocumentLoader::circle(const std::string& file) const {
  std::string round;
  for (const std::string& open : open_files_) {
    if (!round.empty() || identity(open) == identity(file)) round += open + " -> ";
  }
  return round.empty() ? "" : round + file;
}

YAML::Node DocumentLoader::fail(const std::string& path) {
  document_.unreadable_.insert(path);
  return YAML::Node(YAML::NodeType::Null);
}

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
  if (index && *index >= 0 && *index < static_cast<std::int64_t>(node.size())) return "";
  return "'" + component + "' must be an index of '" + path + "', which has " + std::to_string(node.size()) +
         " entries, the first at 0";
}

/// Drops what is remembered of a subtree that is about to be replaced.
void DocumentLoader::forget(const std::string& path) {
  auto& files = document_.file_of_subtree_;
  for (auto it = files.begin(); it != files.end();) it = isWithin(it->first, path) ? files.erase(it) : std::next(it);
  auto& unreadable = document_.unreadable_;
  for (auto it = unreadable.begin(); it != unreadable.end();) {
    it = isWithin(*it, path) ? unreadable.erase(it) : std::next(it);
  }
}

}  // namespace rail
