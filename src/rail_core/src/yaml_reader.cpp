#include "rail_core/yaml_reader.hpp"

#include <algorithm>
#include <optional>

#include "rail_core/number_text.hpp"
#include "value_rules.hpp"
#include "words.hpp"
#include "yaml_nodes.hpp"
#include "yaml_source.hpp"

namespace rail {

YamlReader::YamlReader(const Document& document, Problems& problems)
    : YamlReader(document, problems, document.root(), "", document.root().IsMap() && !document.unreadable("")) {}

YamlReader::YamlReader(const Document& document, Problems& problems, YAML::Node node, std::string path, bool present)
    : document_(&document), problems_(&problems), node_(std::move(node)), path_(std::move(path)), present_(present) {}

YamlReader& YamlReader::operator=(const YamlReader& other) {
  document_ = other.document_;
  problems_ = other.problems_;
  node_.reset(other.node_);
  path_ = other.path_;
  present_ = other.present_;
  asked_ = other.asked_;
  known_ = other.known_;
  faulty_ = other.faulty_;
  return *this;
}

double YamlReader::number(const std::string& key, const Range& range) {
  return readNumber(ask(key, wordsFor(range)), key, range);
}

double YamlReader::numberOr(const std::string& key, const Range& range, double fallback) {
  return isGiven(key) ? number(key, range) : fallback;
}

int YamlReader::integer(const std::string& key, int low, int high) {
  return readInteger(ask(key, wordsForInteger(low, high)), key, low, high);
}

int YamlReader::integerOr(const std::string& key, int low, int high, int fallback) {
  return isGiven(key) ? integer(key, low, high) : fallback;
}

bool YamlReader::boolean(const std::string& key) { return readBoolean(ask(key, kBooleanRule), key); }

bool YamlReader::booleanOr(const std::string& key, bool fallback) { return isGiven(key) ? boolean(key) : fallback; }

std::string YamlReader::text(const std::string& key) { return readText(ask(key, kTextRule), key); }

std::string YamlReader::textOr(const std::string& key, const std::string& fallback) {
  return isGiven(key) ? text(key) : fallback;
}

std::string YamlReader::choice(const std::string& key, const std::vector<std::string>& allowed) {
  return readChoice(ask(key, choiceRule(allowed)), key, allowed);
}

std::string YamlReader::choiceOr(const std::string& key, const std::vector<std::string>& allowed,
                                 const std::string& fallback) {
  return isGiven(key) ? choice(key, allowed) : fallback;
}

std::vector<double> YamlReader::numbers(const std::string& key, const Range& range) {
  const YAML::Node list = ask(key, std::string(kListRule) + " of numbers");
  std::vector<double> values;
  if (!list.IsDefined()) return values;
  if (!list.IsSequence()) {
    reject(key, std::string(kListRule) + " of numbers");
    return values;
  }
  for (const auto& entry : list) values.push_back(readNumber(entry, joinPath(key, values.size()), range));
  return values;
}

std::vector<std::vector<double>> YamlReader::rows(const std::string& key, std::size_t width) {
  const std::string rule = std::string(kListRule) + " of lists of " + std::to_string(width) + " numbers";
  const YAML::Node list = ask(key, rule);
  std::vector<std::vector<double>> rows;
  if (!list.IsDefined()) return rows;
  if (!list.IsSequence()) {
    reject(key, rule);
    return rows;
  }
  const bool flat = std::all_of(list.begin(), list.end(), [](const auto& entry) { return entry.IsScalar(); });
  if (list.size() > 0 && flat) {
    reject(key, rule + ", in brackets of their own: [[...], [...]]");
    return rows;
  }
  std::size_t index = 0;
  for (const auto& entry : list) {
    const std::string row_key = joinPath(key, index++);
    if (!entry.IsSequence() || entry.size() != width) {
      reject(row_key, "must be a list of " + std::to_string(width) + " numbers");
      continue;
    }
    std::vector<double> row;
    for (const auto& cell : entry) row.push_back(readNumber(cell, joinPath(row_key, row.size()), anyNumber()));
    rows.push_back(std::move(row));
  }
  return rows;
}

bool YamlReader::has(const std::string& key) const {
  known_.push_back(key);
  return present_ && find(key).IsDefined();
}

YamlReader YamlReader::map(const std::string& key) {
  return readMap(ask(key, kMapRule + (", here or in the file that " + key) + kFileSuffix + " names"), key);
}

std::vector<YamlReader> YamlReader::maps(const std::string& key) {
  const YAML::Node list = ask(key, std::string(kListRule) + " of maps");
  std::vector<YamlReader> readers;
  if (!list.IsDefined()) return readers;
  if (!list.IsSequence()) {
    reject(key, std::string(kListRule) + " of maps");
    return readers;
  }
  for (const auto& entry : list) readers.push_back(readMap(entry, joinPath(key, readers.size())));
  return readers;
}

std::vector<std::string> YamlReader::keys() const {
  std::vector<std::string> names;
  if (!present_) return names;
  for (const auto& pair : node_) names.push_back(pair.first.Scalar());
  return names;
}

void YamlReader::refuse(const std::string& key, const std::string& rule) {
  if (present_ && !contains(faulty_, key)) reject(key, rule);
}

void YamlReader::refuseKey(const std::string& key, const std::string& rule) {
  if (!isGiven(key)) return;
  if (const Document::FileKey* const named = document_->fileKey(joinPath(path_, key))) {
    problems_->add(named->place.file, named->place.key, named->path, rule);
  } else {
    reject(key, rule);
  }
}

std::string YamlReader::file(const std::string& key) const {
  return document_->place(key.empty() ? path_ : joinPath(path_, key)).file;
}

void YamlReader::finish() {
  std::vector<std::string> known = asked_;
  for (const std::string& key : known_) {
    if (!contains(known, key)) known.push_back(key);
  }
  for (const std::string& key : keys()) {
    if (contains(asked_, key)) continue;
    if (contains(known_, key)) {
      refuseKey(key, "is not used here");
      continue;
    }
    std::string near = nearestWord(key, known);
    if (!near.empty() && document_->fileKey(joinPath(path_, key))) near += kFileSuffix;
    const std::string list = known.empty() ? "none is known here" : "known here: " + joinWords(known);
    refuseKey(key, "unknown key, " + (near.empty() ? list : "did you mean '" + near + "'?"));
  }
}

/// The node at a dotted path below this map; undefined if there is none. Works on const nodes throughout: the other
/// operator[] of yaml-cpp would add the key.
YAML::Node YamlReader::find(const std::string& path) const {
  const YAML::Node undefined(YAML::NodeType::Undefined);
  YAML::Node node = node_;
  for (std::size_t begin = 0; begin < path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    const std::string component = path.substr(begin, end - begin);
    const YAML::Node parent = node;
    const std::optional<std::int64_t> index = parseInteger(component);
    const bool in_list = parent.IsSequence() && index && *index >= 0;
    if (!parent.IsMap() && !in_list) return undefined;
    const YAML::Node child = in_list ? parent[static_cast<std::size_t>(*index)] : parent[component];
    if (!child.IsDefined()) return undefined;
    node.reset(child);
    begin = end + 1;
  }
  return node;
}

/// Marks a key as asked for. Undefined, with the problem added, if it is missing; `words` says what it should be.
YAML::Node YamlReader::ask(const std::string& key, const std::string& words) {
  asked_.push_back(key);
  const YAML::Node undefined(YAML::NodeType::Undefined);
  if (!present_) return undefined;
  if (document_->unreadable(joinPath(path_, key))) {
    faulty_.push_back(key);
    return undefined;
  }
  YAML::Node node = find(key);
  if (!node.IsDefined()) reject(key, "is missing: " + words);
  return node;
}

/// Adds a problem with a key of this map, and the key's value if there is one to show.
void YamlReader::reject(const std::string& key, const std::string& rule) {
  faulty_.push_back(key);
  const Document::Place place = document_->place(key.empty() ? path_ : joinPath(path_, key));
  const YAML::Node node = find(key);
  if (!node.IsDefined() || key.empty()) {
    problems_->add(place.file, place.key, rule);
  } else if (node.IsNull()) {
    problems_->add(place.file, place.key, "is empty: " + rule);
  } else {
    problems_->add(place.file, place.key, shown(node), rule);
  }
}

/// True if an optional key stands in the map; marks it as asked for either way.
bool YamlReader::isGiven(const std::string& key) {
  asked_.push_back(key);
  return present_ && find(key).IsDefined();
}

}  // namespace rail
