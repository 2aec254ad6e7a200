// The part of YamlReader that turns one node into a value, or into a problem and a harmless value.

#include <limits>
#include <optional>

#include "rail_core/number_text.hpp"
#include "rail_core/yaml_reader.hpp"
#include "value_rules.hpp"
#include "words.hpp"
#include "yaml_nodes.hpp"
#include "yaml_source.hpp"

namespace rail {
namespace {

/// What a person has likely written in place of a number, and how it is written; "" if nothing is likely.
std::string notANumberHint(const YAML::Node& node) {
  if (node.IsSequence()) return ", not a list";
  if (!isPlainScalar(node)) return "";
  const std::string& text = node.Scalar();
  if (isDecimal(text)) return "";  // a number, but not one that keeps the rule
  const std::size_t comma = text.find(',');
  if (comma != std::string::npos && isDecimal(text.substr(0, comma) + "." + text.substr(comma + 1))) {
    return ", with a decimal point";
  }
  const std::size_t end = text.find_first_not_of("+-.0123456789");
  const bool number_first = end != std::string::npos && isDecimal(text.substr(0, end));
  return number_first && text.compare(end, 1, "_") != 0 ? ", without unit or other text" : "";
}

bool namesYamlOrCsv(const std::string& text) {
  for (const std::string ending : {".yaml", ".csv"}) {
    if (text.size() > ending.size() && text.compare(text.size() - ending.size(), ending.size(), ending) == 0)
      return true;
  }
  return false;
}

}  // namespace

double YamlReader::readNumber(const YAML::Node& node, const std::string& key, const Range& range) {
  if (!node.IsDefined()) return harmlessValue(range);
  const std::optional<double> value = isPlainScalar(node) ? parseNumber(node.Scalar()) : std::nullopt;
  if (value && keepsRule(*value, range)) return *value;
  if (node.IsScalar() && isQuoted(node)) {
    reject(key, wordsFor(range) + ", not text");
  } else if (!value && isPlainScalar(node) && isDecimal(node.Scalar())) {
    reject(key, "is beyond the range of a double");
  } else {
    reject(key, wordsFor(range) + notANumberHint(node));
  }
  return harmlessValue(range);
}

int YamlReader::readInteger(const YAML::Node& node, const std::string& key, int low, int high) {
  if (!node.IsDefined()) return low;
  const std::optional<std::int64_t> value = isPlainScalar(node) ? parseInteger(node.Scalar()) : std::nullopt;
  if (value && *value >= low && *value <= high) return static_cast<int>(*value);
  const std::string words = wordsForInteger(low, high);
  if (node.IsScalar() && isQuoted(node)) {
    reject(key, words + ", not text");
  } else if (!value && isPlainScalar(node) && isDecimal(node.Scalar()) && !parseInteger(node.Scalar())) {
    reject(key, words + ", written without point and exponent");
  } else if (value && *value > high && high == std::numeric_limits<int>::max()) {
    reject(key, words + " and <= " + std::to_string(high));
  } else {
    reject(key, words + notANumberHint(node));
  }
  return low;
}

bool YamlReader::readBoolean(const YAML::Node& node, const std::string& key) {
  if (!node.IsDefined()) return false;
  const bool plain = isPlainScalar(node);
  if (plain && node.Scalar() == "true") return true;
  if (!plain || node.Scalar() != "false") reject(key, kBooleanRule);
  return false;
}

std::string YamlReader::readText(const YAML::Node& node, const std::string& key) {
  if (!node.IsDefined()) return "";
  if (node.IsScalar() && !node.Scalar().empty()) return node.Scalar();
  if (node.IsScalar() && document_->fileKey(joinPath(path_, key)) != nullptr) {
    faulty_.push_back(key);
    problems_->add(file(key), "", "is empty");
    return "";
  }
  reject(key, kTextRule);
  return "";
}

std::string YamlReader::readChoice(const YAML::Node& node, const std::string& key,
                                   const std::vector<std::string>& allowed) {
  if (!node.IsDefined()) return allowed.front();
  if (node.IsScalar() && contains(allowed, node.Scalar())) return node.Scalar();
  reject(key, choiceRule(allowed));
  return allowed.front();
}

YamlReader YamlReader::readMap(const YAML::Node& node, const std::string& key) {
  const bool present = node.IsDefined() && node.IsMap();
  const std::string path = joinPath(path_, key);
  if (node.IsDefined() && !present && !document_->unreadable(path)) {
    const bool path_given = node.IsScalar() && namesYamlOrCsv(node.Scalar());
    reject(key, kMapRule + (path_given ? "; a file is named by " + key + kFileSuffix : ""));
  }
  return YamlReader(*document_, *problems_, present ? node : YAML::Node(YAML::NodeType::Map), path, present);
}

}  // namespace rail
