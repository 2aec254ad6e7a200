#pragma once

#include <yaml-cpp/yaml.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "rail_core/problems.hpp"

namespace rail {

/// `--set key=value`: the value of one key, by its dotted path in the resolved document
/// (`train.groups.0.count`, `steps.macro_step_s`); the value is YAML.
struct Override {
  std::string key;
  std::string value;
};

/// A scenario with everything that it names, as one YAML tree.
///
/// In any map the key `NAME_file: PATH` stands for `NAME:` with the content of that file: a .yaml file becomes a
/// subtree, a .csv file a text scalar. PATH is relative to the file that holds the key (an override's path is relative
/// to the working directory). The resolved tree is itself a valid document, so `text()` alone repeats a run: it is
/// recorded in every bag and sent to every locomotive.
class Document {
 public:
  // Assigning a YAML::Node writes into the tree that it points to; assigning a document must not change copies of it.
  Document() = default;
  Document(const Document&) = default;
  Document& operator=(const Document& other);

  /// Reads a file and all that it names, and applies the overrides (also those of `NAME_file` keys, at any depth).
  /// An override of X replaces what X_file names, and one of X_file what stands at X. Overrides of outer keys come
  /// first, whatever their order, so that none is lost; a key that does not exist yet is added to its map.
  /// Unreadable files, YAML syntax errors, duplicate keys, `X` beside `X_file`, inclusion in circles and overrides that
  /// cannot be applied (index out of range, path through a scalar, no such map, one key twice) go to `problems`.
  /// Refused too, because they can be misread: anchors and aliases, tags, keys with a dot, several YAML documents.
  static Document load(const std::string& path, const std::vector<Override>& overrides, Problems& problems);

  /// Reads a resolved text; `name` stands for the file in messages. `NAME_file` keys are refused here.
  static Document parse(const std::string& text, const std::string& name, Problems& problems);

  const YAML::Node& root() const { return root_; }

  /// The resolved tree as YAML text. Scalars stand as they were written, key order is kept;
  /// parse(text()) gives the same tree.
  std::string text() const;

  /// Where the node at the dotted path `key` comes from, and how its key reads there: the innermost included file and
  /// the path within it; `--set` for overridden values.
  struct Place {
    std::string file;
    std::string key;
  };
  Place place(const std::string& key) const;

  /// The `NAME_file` key that brought the content of `key`: where it stands, and the path as it is written there.
  struct FileKey {
    Place place;
    std::string path;
  };
  /// Null if the content of `key` itself (not of a map around it) was not named by such a key.
  const FileKey* fileKey(const std::string& key) const;

  /// True if the content that should stand at `key` could not be read. The problem has been reported: readers must not
  /// add that the key is missing.
  bool unreadable(const std::string& key) const { return unreadable_.count(key) > 0; }

 private:
  friend class DocumentLoader;
  YAML::Node root_;                                     ///< never changed after loading
  std::map<std::string, std::string> file_of_subtree_;  ///< dotted path of an included subtree -> its file
  std::map<std::string, FileKey> file_key_;             ///< dotted path of an included subtree -> what named its file
  std::set<std::string> overridden_;                    ///< dotted paths
  std::set<std::string> unreadable_;                    ///< dotted paths
};

}  // namespace rail
