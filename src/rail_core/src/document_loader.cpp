#include "document_loader.hpp"

#include <algorithm>
#include <filesystem>

#include "yaml_nodes.hpp"
#include "yaml_source.hpp"

namespace rail {
namespace {

/// One name for a file, however the path to it is written.
std::string identity(const std::string& file) {
  std::error_code error;
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(file, error);
  return error ? file : canonical.string();
}

bool isFolder(const std::string& path) {
  std::error_code error;
  return std::filesystem::is_directory(path, error);
}

/// A hint at a file of the same kind beside the one that is not there; "" if none has a name like it.
std::string nearestFile(const std::string& absent) {
  const std::filesystem::path path = absent;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error))
    return ": there is no folder '" + folder.string() + "' (a path counts from the file that names it)";
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().extension() == path.extension()) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());  // a folder has no order
  const std::string near = nearestWord(path.filename().string(), names);
  return near.empty() ? "" : ": there is none, did you mean '" + near + "'?";
}

}  // namespace

void DocumentLoader::load(const std::string& path, const std::vector<Override>& overrides) {
  readTargets(overrides);
  const std::optional<std::string> text = readFile(path);
  if (!text) problems_.add(path, "", isFolder(path) ? "is a folder: must be a file" : "cannot be read");
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
  if (raw) problems_.add(cursor.file, "", raw->IsNull() ? "is empty" : "must be a map, of lines `key: value`");
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
  document_.file_key_[path] = {{cursor.file, cursor.local}, name};
  if (!files_allowed_) {
    problems_.add(cursor.file, cursor.local, name, "files cannot be named here, the text must be complete");
    return fail(path);
  }
  const std::string file = (std::filesystem::path(cursor.directory) / name).lexically_normal().string();
  const std::string extension = std::filesystem::path(file).extension().string();
  if (isFolder(file) || (extension != ".yaml" && extension != ".csv")) {
    problems_.add(cursor.file, cursor.local, name,
                  std::string(isFolder(file) ? "is a folder: must be a file, and" : "must") + " end in .yaml or .csv");
    return fail(path);
  }
  const std::string round = circle(file);
  if (!round.empty()) {
    problems_.add(cursor.file, cursor.local, name, "includes itself: " + round);
    return fail(path);
  }
  const std::optional<std::string> text = readFile(file);
  if (!text) {
    problems_.add(cursor.file, cursor.local, name, "cannot read '" + file + "'" + nearestFile(file));
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

}  // namespace rail
