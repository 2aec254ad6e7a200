#include "yaml_writer.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

#include "yaml_source.hpp"

namespace rail {
namespace {

constexpr std::size_t kIndent = 2;

/// Letters, digits and signs that mean nothing to YAML wherever they stand; enough for keys, numbers and names.
bool isHarmless(const std::string& text) {
  const std::string harmless = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.+-/";
  const bool dash = text.find_first_not_of("-.") == std::string::npos;  // "-", "---", "..."
  const bool null = text == "null" || text == "Null" || text == "NULL";
  return !text.empty() && !dash && !null && text.find_first_not_of(harmless) == std::string::npos;
}

std::string quoted(const std::string& text) {
  const char* const digits = "0123456789ABCDEF";
  std::string result = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (c == '\n') {
      result += "\\n";
    } else if (code < 0x20 || code == 0x7f) {
      result += "\\x";
      result += digits[code >> 4U];
      result += digits[code & 0xfU];
    } else {
      result += c;
    }
  }
  return result + "\"";
}

/// True if `text` can stand as a literal block `|`, which people can read: complete lines, none blank, the first not
/// indented, no control characters.
bool fitsLiteralBlock(const std::string& text) {
  if (text.empty() || text.front() == ' ' || text.front() == '\n' || text.back() != '\n') return false;
  if (text.find("\n\n") != std::string::npos || text.find(" \n") != std::string::npos) return false;
  return std::all_of(text.begin(), text.end(), [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return c == '\n' || (code >= 0x20 && code < 0x7f);
  });
}

std::string literalBlock(const std::string& text, std::size_t indent) {
  std::string result = "|\n";
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    result += std::string(indent, ' ') + text.substr(begin, end - begin) + "\n";
    begin = end + 1;
  }
  result.pop_back();
  return result;
}

/// A scalar after `key: ` or `- `; further lines are indented by `indent`.
std::string scalarText(const YAML::Node& node, std::size_t indent) {
  const std::string& text = node.Scalar();
  const bool plain = node.Tag() != kQuotedTag && !text.empty() && text.find('\n') == std::string::npos;
  if (plain) return text;
  return fitsLiteralBlock(text) ? literalBlock(text, indent) : quoted(text);
}

/// `[1, 2, 3]` for a list of plain numbers or names, "" for any other node.
std::string flowText(const YAML::Node& node) {
  if (node.IsNull()) return "~";
  if (node.IsMap() && node.size() == 0) return "{}";
  if (!node.IsSequence()) return "";
  std::string text;
  for (const auto& entry : node) {
    if (!entry.IsScalar() || entry.Tag() == kQuotedTag || !isHarmless(entry.Scalar())) return "";
    text += (text.empty() ? "" : ", ") + entry.Scalar();
  }
  return "[" + text + "]";
}

void write(const YAML::Node& node, std::size_t indent, std::string& out);

/// What follows `key:` or `-`, up to and with the line's end. `inner` is the indentation of lines below.
void writeValue(const YAML::Node& node, std::size_t inner, std::string& out) {
  const std::string flow = flowText(node);
  if (!flow.empty()) {
    out += " " + flow + "\n";
  } else if (node.IsScalar()) {
    out += " " + scalarText(node, inner) + "\n";
  } else {
    out += "\n";
    write(node, inner, out);
  }
}

/// A map or list in block style.
void write(const YAML::Node& node, std::size_t indent, std::string& out) {
  if (node.IsMap()) {
    for (const auto& pair : node) {
      const std::string& key = pair.first.Scalar();
      out += std::string(indent, ' ') + (isHarmless(key) ? key : quoted(key)) + ":";
      writeValue(pair.second, indent + kIndent, out);
    }
  } else {
    for (const auto& entry : node) {
      out += std::string(indent, ' ') + "-";
      writeValue(entry, indent + kIndent, out);
    }
  }
}

}  // namespace

std::string writeYaml(const YAML::Node& node) {
  const std::string flow = flowText(node);
  if (!flow.empty()) return flow + "\n";
  std::string out;
  write(node, 0, out);
  return out;
}

}  // namespace rail
