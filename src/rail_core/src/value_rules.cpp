#include "value_rules.hpp"

#include <limits>

#include "rail_core/number_text.hpp"
#include "words.hpp"
#include "yaml_source.hpp"

namespace rail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

Range anyNumber() { return {}; }
Range positive() { return {0.0, kInfinity, false, true}; }
Range notNegative() { return {0.0, kInfinity, true, true}; }
Range between(double low, double high) { return {low, high, true, true}; }
Range above(double low) { return {low, kInfinity, false, true}; }
Range aboveUpTo(double low, double high) { return {low, high, false, true}; }

bool isQuoted(const YAML::Node& node) { return node.Tag() == kQuotedTag; }

bool isPlainScalar(const YAML::Node& node) { return node.IsScalar() && !isQuoted(node); }

std::string shown(const YAML::Node& node) {
  if (node.IsMap()) return "{...}";
  if (node.IsSequence()) return "[...]";
  return isQuoted(node) ? "\"" + node.Scalar() + "\"" : node.Scalar();
}

bool keepsRule(double number, const Range& range) {
  const bool above_low = range.low_included ? number >= range.low : number > range.low;
  const bool below_high = range.high_included ? number <= range.high : number < range.high;
  return above_low && below_high;
}

std::string wordsFor(const Range& range) {
  std::string words = "must be a number";
  if (range.low > -kInfinity) words += (range.low_included ? " >= " : " > ") + formatNumber(range.low);
  if (range.low > -kInfinity && range.high < kInfinity) words += " and";
  if (range.high < kInfinity) words += (range.high_included ? " <= " : " < ") + formatNumber(range.high);
  return words;
}

std::string wordsForInteger(int low, int high) {
  std::string words = "must be an integer";
  if (low > std::numeric_limits<int>::min()) words += " >= " + std::to_string(low);
  if (low > std::numeric_limits<int>::min() && high < std::numeric_limits<int>::max()) words += " and";
  if (high < std::numeric_limits<int>::max()) words += " <= " + std::to_string(high);
  return words;
}

std::string choiceRule(const std::vector<std::string>& allowed) { return "must be one of: " + joinWords(allowed); }

double harmlessValue(const Range& range) {
  if (range.low > -kInfinity && range.low_included) return range.low;
  if (range.high < kInfinity && range.high_included) return range.high;
  if (range.low > -kInfinity && range.high < kInfinity) return range.low + 0.5 * (range.high - range.low);
  if (range.low > -kInfinity) return range.low + 1.0;
  return range.high < kInfinity ? range.high - 1.0 : 0.0;
}

}  // namespace rail
