#pragma once

#include <yaml-cpp/yaml.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "rail_core/document.hpp"
#include "rail_core/problems.hpp"

namespace rail {

/// Builds a Document: reads files, puts the content of `NAME_file` keys in their place, applies overrides.
/// In a first pass the tree is read without the overrides, and without the files that an override replaces; then the
/// overrides are applied one by one, outer keys first.
class DocumentLoader {
 public:
  DocumentLoader(Document& document, Problems& problems) : document_(document), problems_(problems) {}

  void load(const std::string& path, const std::vector<Override>& overrides);
  void parse(const std::string& text, const std::string& name);

 private:
  /// Where the reader stands: in which file, at which key of it, and where that is in the resolved document.
  struct Cursor {
    std::string file;       ///< for messages
    std::string local;      ///< dotted path within the file
    std::string path;       ///< dotted path within the document
    std::string directory;  ///< which paths in this file are relative to
  };
  /// `--set` taken apart.
  struct Target {
    std::string key;                      ///< as given
    std::string path;                     ///< of the value in the resolved document: without `_file`
    std::vector<std::string> components;  ///< of `path`
    std::string value;
    bool is_file;
  };

  void setRoot(const std::optional<YAML::Node>& raw, const Cursor& cursor);
  YAML::Node resolve(const YAML::Node& raw, const Cursor& cursor);
  YAML::Node resolveMap(const YAML::Node& raw, const Cursor& cursor);
  YAML::Node include(const YAML::Node& raw, const Cursor& cursor, const std::string& path);
  YAML::Node includeYaml(const std::string& text, const std::string& file, const std::string& path);
  std::string circle(const std::string& file) const;
  YAML::Node fail(const std::string& path);

  void readTargets(const std::vector<Override>& overrides);
  bool isReplaced(const std::string& path) const;
  void apply(const Target& target);
  bool descend(const Target& target, YAML::Node& parent);
  std::string stepFault(const YAML::Node& node, const std::string& component, const std::string& path) const;
  void forget(const std::string& path);

  Document& document_;
  Problems& problems_;
  std::vector<Target> targets_;
  std::vector<std::string> open_files_;  ///< those being read now, outermost first
  bool files_allowed_ = true;
};

}  // namespace rail
