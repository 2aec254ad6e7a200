#include "yaml_hints.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace rail {
namespace {

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

/// Without indentation, the dash of a list's entry and a comment.
std::string contentOf(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  std::string content = line.substr(first);
  if (content.compare(0, 2, "- ") == 0) content = content.substr(2);
  if (content.empty() || content.front() == '#') return "";
  content = content.substr(0, content.find(" #"));
  return content.substr(0, content.find_last_not_of(" \r") + 1);
}

bool isTabIndented(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first != std::string::npos && line.find('\t') < first;
}

/// `key:600`. A colon in a path or a time of day comes behind a blank.
bool lacksBlankBehindColon(const std::string& content) {
  const std::size_t colon = content.find(':');
  return colon != std::string::npos && colon > 0 && colon + 1 < content.size() && content[colon + 1] != ' ' &&
         content.find_first_of(" \"'{[") > colon;
}

/// `key: some text: more`, which must be quoted.
bool hasColonInPlainText(const std::string& content) {
  const std::size_t colon = content.find(": ");
  if (colon == std::string::npos || content.find_first_of("\"'{[") < colon) return false;  // the key is not plain
  const std::size_t value = colon == std::string::npos ? colon : content.find_first_not_of(' ', colon + 2);
  if (value == std::string::npos || std::string("\"'{[").find(content[value]) != std::string::npos) return false;
  return content.find(": ", value) != std::string::npos;
}

bool hasOpenBracket(const std::string& content) {
  const auto count = [&content](char c) { return std::count(content.begin(), content.end(), c); };
  return count('{') != count('}') || count('[') != count(']');
}

bool hasOpenQuote(const std::string& content) { return std::count(content.begin(), content.end(), '"') % 2 != 0; }

/// @param flow  the parser was stuck between brackets
std::string hintFor(const std::string& line, bool flow) {
  const std::string content = contentOf(line);
  if (isTabIndented(line)) return "is indented with a tab: must be indented with blanks";
  if (lacksBlankBehindColon(content)) return "lacks a blank behind the colon: '" + content + "'";
  if (hasColonInPlainText(content)) return "has a value with ': ' in it, which must stand in quotes";
  if (hasOpenQuote(content)) return "has a quote (\") that is not closed";
  if (flow && hasOpenBracket(content)) return "has a bracket that is not closed";
  if (content.find(':') == std::string::npos && content.find(" = ") != std::string::npos) return "has '=', must be ':'";
  return "";
}

}  // namespace

std::string yamlFault(const std::string& text, int line, const std::string& words) {
  const std::vector<std::string> lines = linesOf(text);
  const bool flow = words.find("flow") != std::string::npos;
  const int last = std::min(line, static_cast<int>(lines.size()));
  for (int number = last; number >= std::max(1, last - 2); --number) {
    const std::string hint = hintFor(lines[static_cast<std::size_t>(number - 1)], flow);
    if (!hint.empty()) return "line " + std::to_string(number) + ": is not YAML: " + hint;
  }
  return "line " + std::to_string(line) + ": is not YAML: " + words +
         "; look there and in the lines before for the indentation, and for brackets and quotes that are not closed";
}

bool isOpenQuote(const std::string& text, int line, int column) {
  std::size_t i = 0;
  for (int skipped = 0; skipped < line; ++skipped) {
    const std::size_t end = text.find('\n', i);
    if (end == std::string::npos) return false;
    i = end + 1;
  }
  i += static_cast<std::size_t>(column);
  if (i >= text.size() || (text[i] != '"' && text[i] != '\'')) return false;  // a block of text
  const char quote = text[i];
  for (++i; i < text.size(); ++i) {
    const bool escaped = quote == '"' ? text[i] == '\\' : text.compare(i, 2, "''") == 0;
    if (escaped) {
      ++i;
    } else if (text[i] == quote) {
      return false;
    }
  }
  return true;
}

}  // namespace rail
