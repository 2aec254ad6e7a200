#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace rail {

/// Thrown once, after everything was read, with all problems of the user's files; what() holds one line each.
class ConfigError : public std::runtime_error {
 public:
  explicit ConfigError(const std::vector<std::string>& lines);
  const std::vector<std::string>& lines() const { return lines_; }

 private:
  std::vector<std::string> lines_;
};

/// Collects every fault found in the user's files, so that a person mends them in one go.
/// A line reads `file: key = value: rule`, or `file: key: rule` where there is no value to show, or `file: rule` for an
/// empty key. A value is shown on one line and at most 60 characters long.
class Problems {
 public:
  void add(const std::string& file, const std::string& key, const std::string& value, const std::string& rule);
  void add(const std::string& file, const std::string& key, const std::string& rule);

  bool empty() const { return lines_.empty(); }
  const std::vector<std::string>& lines() const { return lines_; }
  /// How often a problem was added, repeated ones too: unchanged means that nothing was wrong meanwhile.
  std::size_t count() const { return count_; }

  /// @throws ConfigError with all lines if there are any.
  void throwIfAny() const;

 private:
  void addOnce(const std::string& line);  ///< a file that is named three times is at fault once
  std::vector<std::string> lines_;
  std::size_t count_ = 0;
};

/// The member of `known` nearest to `word` by edit distance, or "" if none is near enough to be a misspelling.
std::string nearestWord(const std::string& word, const std::vector<std::string>& known);

/// `known` with the likeliest meant first: those that `word` is a misspelt beginning of (`emergncy` of
/// `emergency_stop`), fewest slips first.
std::vector<std::string> nearestFirst(const std::string& word, std::vector<std::string> known);
/// True if `word` is `candidate` or a beginning of it, but for some slips.
bool isMisspeltBeginning(const std::string& word, const std::string& candidate);

}  // namespace rail
