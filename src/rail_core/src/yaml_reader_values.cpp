// The part of YamlReader that turns one node into a value, or into a problem and a harmless value.

#include <limits>
#include <optional>

#include "number_text.hpp"
#include "rail_core/yaml_reader.hpp"
#include "value_rules.hpp"
#include "yaml_source.hpp"

namespace rail {

double YamlReader::readNumber(const YAML::Node& node, const std::string& key, const Range& range) {
  if (!node.IsDefined()) return harmlessValue(range);
  const std::optional<double> value = isPlainScalar(node) ? parseNumber(node.Scalar()) : std::nullopt;
  if (value && keepsRule(*value, range)) return *value;
  if (node.IsScalar() && isQuoted(node)) {
    reject(key, wordsFor(range) + ", not text");
  } else if (!value && isPlainScalar(node) && isDecimal(node.Scalar())) {
    reject(key, "is beyond the range of a double");
  } else {
    reject(key, wordsFor(range));
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
    reject(key, words);
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
  if (node.IsDefined() && !present && !document_->unreadable(path)) reject(key, kMapRule);
  return YamlReader(*document_, *problems_, present ? node : YAML::Node(YAML::NodeType::Map), path, present);
}

}  // namespace rail
