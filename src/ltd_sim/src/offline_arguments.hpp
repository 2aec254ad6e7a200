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

  /// Every combination of the values, the last key varying fastest; one empty combination if nothing is set.
  std::vector<std::vector<rail::Override>> combinations() const;
};

/// Splits `a,b,[c,d]` at the commas outside brackets, braces and quotes.
std::vector<std::string> splitValues(const std::string& text);

}  // namespace ltd
