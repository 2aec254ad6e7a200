#include "rail_core/problems.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace rail {
namespace {

/// Longest value that a message shows. Chosen: such a line still fits a terminal of 200 columns.
constexpr std::size_t kLongestValue = 60;

std::string joinLines(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
  return text;
}

/// A value as it fits into one line: line ends and tabs shown as escapes, the tail of a long one left out.
std::string oneLine(const std::string& value) {
  std::string line;
  for (const char c : value) {
    if (line.size() >= kLongestValue) return line + "...";
    if (c == '\n') {
      line += "\\n";
    } else if (c == '\r') {
      line += "\\r";
    } else if (c == '\t') {
      line += "\\t";
    } else {
      line += c;
    }
  }
  return line;
}

std::string lowerCase(std::string word) {
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word;
}

/// Number of insertions, deletions, substitutions and swaps of neighbours that make `b` of `a` (optimal string
/// alignment).
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitution = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, substitution});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

/// A key without its unit (`mass` for `mass_kg`) is many edits away and a likely slip all the same.
bool isBeginningOf(const std::string& beginning, const std::string& word) {
  constexpr std::size_t kShortest = 3;  // chosen: fewer letters fit too many words
  return beginning.size() >= kShortest && word.compare(0, beginning.size(), beginning) == 0;
}

}  // namespace

ConfigError::ConfigError(const std::vector<std::string>& lines) : std::runtime_error(joinLines(lines)), lines_(lines) {}

void Problems::add(const std::string& file, const std::string& key, const std::string& value, const std::string& rule) {
  addOnce(file + ": " + (key.empty() ? "" : key + " = ") + oneLine(value) + ": " + rule);
}

void Problems::add(const std::string& file, const std::string& key, const std::string& rule) {
  addOnce(file + ": " + (key.empty() ? "" : key + ": ") + rule);
}

void Problems::addOnce(const std::string& line) {
  ++count_;
  if (std::find(lines_.begin(), lines_.end(), line) == lines_.end()) lines_.push_back(line);
}

void Problems::throwIfAny() const {
  if (!lines_.empty()) throw ConfigError(lines_);
}

std::string nearestWord(const std::string& word, const std::vector<std::string>& known) {
  const std::string wanted = lowerCase(word);
  std::string nearest;
  std::size_t least = 0;
  for (const std::string& candidate : known) {
    const std::string lower = lowerCase(candidate);
    const std::size_t distance = editDistance(wanted, lower);
    // Chosen: one slip in three letters is still a misspelling, half a word is another word.
    const bool near = distance <= std::max<std::size_t>(1, std::max(wanted.size(), lower.size()) / 3) ||
                      isBeginningOf(wanted, lower) || isBeginningOf(lower, wanted);
    if (near && (nearest.empty() || distance < least)) {
      nearest = candidate;
      least = distance;
    }
  }
  return nearest;
}

}  // namespace rail
