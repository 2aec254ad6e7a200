#include "rail_core/problems.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace rail {
namespace {

/// Longest value that a message shows. Chosen: such a line still fits a terminal of 200 columns.
constexpr std::size_t kLongestValue = 60;

/// Lines of problems that a message shows. Chosen: what fits a screen; a table with one slip has it in every row.
constexpr std::size_t kMostLines = 40;

std::string joinLines(const std::vector<std::string>& lines) {
  std::string text;
  for (std::size_t i = 0; i < std::min(lines.size(), kMostLines); ++i) text += (i == 0 ? "" : "\n") + lines[i];
  if (lines.size() > kMostLines) text += "\nand " + std::to_string(lines.size() - kMostLines) + " problems more";
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

/// Numbers of slips between two words.
struct Distance {
  std::size_t whole;      ///< to the whole word
  std::size_t beginning;  ///< to that beginning of it which is nearest
};

/// Number of insertions, deletions, substitutions and swaps of neighbours that make `b`, or its nearest beginning, of
/// `a` (optimal string alignment).
Distance editDistance(const std::string& a, const std::string& b) {
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
  const std::vector<std::size_t>& last = d[a.size()];
  return {last[b.size()], *std::min_element(last.begin(), last.end())};
}

/// Chosen: one slip in three letters is still a misspelling, half a word is another word.
std::size_t mostSlips(std::size_t letters) { return std::max<std::size_t>(1, letters / 3); }

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
    const std::size_t distance = editDistance(wanted, lower).whole;
    const bool near = distance <= mostSlips(std::max(wanted.size(), lower.size())) || isBeginningOf(wanted, lower) ||
                      isBeginningOf(lower, wanted);
    if (near && (nearest.empty() || distance < least)) {
      nearest = candidate;
      least = distance;
    }
  }
  return nearest;
}

std::vector<std::string> nearestFirst(const std::string& word, std::vector<std::string> known) {
  const std::string wanted = lowerCase(word);
  std::stable_sort(known.begin(), known.end(), [&wanted](const std::string& a, const std::string& b) {
    const Distance to_a = editDistance(wanted, lowerCase(a)), to_b = editDistance(wanted, lowerCase(b));
    return to_a.beginning != to_b.beginning ? to_a.beginning < to_b.beginning : to_a.whole < to_b.whole;
  });
  return known;
}

bool isMisspeltBeginning(const std::string& word, const std::string& candidate) {
  const std::size_t slips = editDistance(lowerCase(word), lowerCase(candidate)).beginning;
  return slips <= mostSlips(word.size()) && slips < word.size();  // of all letters: it is no beginning
}

}  // namespace rail
