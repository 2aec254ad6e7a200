#pragma once

#include <string>
#include <utility>
#include <vector>

#include "rail_core/document.hpp"

namespace ltd {

/// The command line of ltd_offline.
struct OfflineArguments {
  std::string scenario;
  std::string out;
  bool bag = true;
  bool help = false;
  int jobs = 1;  ///< runs of a sweep beside each other
  /// Keys in the order of their first --set, with all values given for each.
  std::vector<std::pair<std::string, std::vector<std::string>>> sets;

  /// @return empty, or what is wrong with the command line
  std::string parse(const std::vector<std::string>& arguments);

  /// Before a sweep: the number of runs, and the values of each key; empty if there is one run only.
  std::string announcement() const;

  /// A line for each value that looks like a decimal comma, `--set x=0,25`, and is taken as two values all the same.
  std::string commaHints() const;

  /// Every combination of the values, the last key varying fastest; one empty combination if nothing is set.
  std::vector<std::vector<rail::Override>> combinations() const;

 private:
  std::string takeSet(const std::string& argument);
  std::vector<std::string> like_decimal_comma_;  ///< arguments of --set
};

/// True for two whole numbers of which the first is 0 or the larger one: a person who sweeps writes the smaller value
/// first, one who writes a decimal comma need not. `0,1` and `20,10` may be meant as they stand: a hint, no refusal.
bool looksLikeDecimalComma(const std::vector<std::string>& values);

/// Splits `a,b,[c,d]` at the commas outside brackets, braces and quotes.
std::vector<std::string> splitValues(const std::string& text);

}  // namespace ltd
