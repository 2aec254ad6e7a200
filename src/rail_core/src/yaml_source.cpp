#include "yaml_source.hpp"

#include <yaml-cpp/eventhandler.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

#include "text_fault.hpp"
#include "yaml_hints.hpp"

namespace rail {
namespace {

/// Listens to the parser for what the finished tree no longer shows.
class Listener : public YAML::EventHandler {
 public:
  explicit Listener(const std::string& text) : text_(text) {}  ///< without byte order mark
  const std::string& fault() const { return fault_; }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { check(mark, anchor); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override { check(mark, anchor); }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, const std::string&) override {
    check(mark, anchor);
    if (fault_.empty() && tag == kQuotedTag && isOpenQuote(text_, mark.line, mark.column)) {
      fault_ = "line " + std::to_string(mark.line + 1) + ": is not YAML: has a quote that is not closed";
    }
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    check(mark, anchor);
  }
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    check(mark, anchor);
  }
  void OnMapEnd() override {}

 private:
  void check(const YAML::Mark& mark, YAML::anchor_t anchor) {
    if (anchor == YAML::NullAnchor || !fault_.empty()) return;
    fault_ = "line " + std::to_string(mark.line + 1) +
             ": anchors and aliases (&name, *name) are not allowed, write it out or use a NAME_file key";
  }

  const std::string& text_;
  std::string fault_;
};

std::string withoutByteOrderMark(const std::string& text) {
  return text.compare(0, 3, "\xEF\xBB\xBF") == 0 ? text.substr(3) : text;
}

/// "" if the text is one YAML document without aliases, otherwise what is wrong.
std::string syntaxFault(const std::string& given) {
  const std::string no_text = textFault(given);
  if (!no_text.empty()) return no_text;
  const std::string text = withoutByteOrderMark(given);
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    Listener finder(text);
    const bool any = parser.HandleNextDocument(finder);
    if (!finder.fault().empty()) return finder.fault();
    if (any && parser.HandleNextDocument(finder)) return "must be one YAML document, without '---'";
  } catch (const YAML::Exception& error) {
    return yamlFault(text, error.mark.line + 1, error.msg);
  }
  return "";
}

bool hasExplicitTag(const YAML::Node& node) {
  const std::string& tag = node.Tag();
  return !tag.empty() && tag != kPlainTag && tag != kQuotedTag;
}

/// Checks a parsed tree recursively for what yaml-cpp accepts in silence.
class TreeCheck {
 public:
  TreeCheck(const std::string& file, Problems& problems) : file_(file), problems_(problems) {}

  void check(const YAML::Node& node, const std::string& path) {
    if (hasExplicitTag(node)) problems_.add(file_, path, "tags (!type) are not allowed");
    if (node.IsMap()) checkMap(node, path);
    if (node.IsSequence()) {
      std::size_t index = 0;
      for (const auto& entry : node) check(entry, joinPath(path, index++));
    }
  }

 private:
  void checkMap(const YAML::Node& map, const std::string& path) {
    std::map<std::string, int> line_of;  // 1-based
    for (const auto& pair : map) {
      if (!pair.first.IsScalar() || pair.first.Scalar().empty()) {
        problems_.add(file_, path, "a key must be text, and not empty");
        continue;
      }
      const std::string& key = pair.first.Scalar();
      if (key.find('.') != std::string::npos) problems_.add(file_, joinPath(path, key), "a key must not hold a dot");
      const auto [known, first] = line_of.insert({key, pair.first.Mark().line + 1});
      if (!first) {
        problems_.add(file_, joinPath(path, key),
                      "is given twice, in line " + std::to_string(known->second) + " and in line " +
                          std::to_string(pair.first.Mark().line + 1));
      }
      check(pair.second, joinPath(path, key));
    }
  }

  const std::string& file_;
  Problems& problems_;
};

}  // namespace

std::optional<std::string> readFile(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return std::nullopt;
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (stream.bad()) return std::nullopt;
  return text;
}

std::optional<YAML::Node> readYaml(const std::string& text, const std::string& file, const std::string& key,
                                   Problems& problems) {
  const std::string fault = syntaxFault(text);
  if (!fault.empty()) {
    problems.add(file, key, fault);
    return std::nullopt;
  }
  YAML::Node node = YAML::Load(text);
  const std::size_t before = problems.count();
  TreeCheck(file, problems).check(node, key);
  if (problems.count() != before) return std::nullopt;
  return node;
}

}  // namespace rail
