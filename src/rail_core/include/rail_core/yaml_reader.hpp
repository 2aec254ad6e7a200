#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "rail_core/document.hpp"
#include "rail_core/problems.hpp"

namespace rail {

/// What a number must satisfy. Build with the functions below; the rule's words appear in the message.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_included = true;
  bool high_included = true;
};
Range anyNumber();
Range positive();                          ///< > 0
Range notNegative();                       ///< >= 0
Range between(double low, double high);    ///< low <= x <= high
Range above(double low);                   ///< > low
Range aboveUpTo(double low, double high);  ///< low < x <= high

/// Strict reader of one map of a Document. Every key must be asked for; missing keys, ill-typed or impossible values
/// are added to the Problems and a harmless value is returned so that reading goes on; finish() reports the keys that
/// nobody asked for, with the nearest known one. Numbers are plain decimal YAML numbers: nan, inf, text, booleans and
/// trailing garbage are refused. What is refused is never repaired.
class YamlReader {
 public:
  /// Reader of the document's root map.
  YamlReader(const Document& document, Problems& problems);

  // Assigning a YAML::Node writes into the tree that it points to; assigning a reader must only point it elsewhere.
  YamlReader(const YamlReader&) = default;
  YamlReader& operator=(const YamlReader& other);

  double number(const std::string& key, const Range& range);
  double numberOr(const std::string& key, const Range& range, double fallback);
  int integer(const std::string& key, int low, int high = std::numeric_limits<int>::max());
  int integerOr(const std::string& key, int low, int high, int fallback);
  bool boolean(const std::string& key);
  bool booleanOr(const std::string& key, bool fallback);
  std::string text(const std::string& key);  ///< not empty
  std::string textOr(const std::string& key, const std::string& fallback);
  std::string choice(const std::string& key, const std::vector<std::string>& allowed);
  std::string choiceOr(const std::string& key, const std::vector<std::string>& allowed, const std::string& fallback);
  std::vector<double> numbers(const std::string& key, const Range& range);  ///< a list, may be empty
  /// A list of lists of `width` numbers each (points of a table).
  std::vector<std::vector<double>> rows(const std::string& key, std::size_t width);

  bool has(const std::string& key) const;
  YamlReader map(const std::string& key);  ///< required; an absent map reads as one with no keys to ask for
  std::vector<YamlReader> maps(const std::string& key);  ///< required list of maps, may be empty
  /// Names of the keys of this map in order (for maps whose keys the user chooses); marks none as asked for.
  std::vector<std::string> keys() const;

  /// Adds `file: key = value: rule` for a key of this map, for rules that only the caller knows (relations). `key` may
  /// go deeper (`points.3`), "" is the map itself. A key that was found missing or ill-typed is not refused again.
  void refuse(const std::string& key, const std::string& rule);

  /// Refuses a key as such, whatever its value, if it is given. If the value came from a file, the message tells of the
  /// `NAME_file` key and where it stands, not of the file.
  void refuseKey(const std::string& key, const std::string& rule);

  /// Leaves a key unread: it may be given or not.
  void ignore(const std::string& key) { asked_.push_back(key); }

  /// Dotted path of this map in the document ("" for the root).
  const std::string& path() const { return path_; }
  /// False for a map that was absent or no map; the problem has then been reported already.
  bool present() const { return present_; }
  /// The file this map, or the named key's content, comes from (for CSV readers and messages).
  std::string file(const std::string& key = "") const;

  /// Reports unknown keys. Call once on every reader when all keys have been asked for.
  void finish();

  Problems& problems() { return *problems_; }

 private:
  YamlReader(const Document& document, Problems& problems, YAML::Node node, std::string path, bool present);

  YAML::Node find(const std::string& path) const;
  YAML::Node ask(const std::string& key, const std::string& words);
  void reject(const std::string& key, const std::string& rule);
  double readNumber(const YAML::Node& node, const std::string& key, const Range& range);
  int readInteger(const YAML::Node& node, const std::string& key, int low, int high);
  bool readBoolean(const YAML::Node& node, const std::string& key);
  std::string readText(const YAML::Node& node, const std::string& key);
  std::string readChoice(const YAML::Node& node, const std::string& key, const std::vector<std::string>& allowed);
  YamlReader readMap(const YAML::Node& node, const std::string& key);
  bool isGiven(const std::string& key);

  const Document* document_;
  Problems* problems_;
  YAML::Node node_;
  std::string path_;
  bool present_ = true;
  std::vector<std::string> asked_;
  mutable std::vector<std::string> known_;  ///< asked about with has(), perhaps not asked for
  std::vector<std::string> faulty_;         ///< keys of which a problem has been reported
};

}  // namespace rail
