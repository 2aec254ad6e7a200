#pragma once

#include <sstream>
#include <string>

namespace ltd {

/// A number in the words of a rule: four digits tell what is meant.
inline std::string format(double x) {
  std::ostringstream text;
  text.precision(4);
  text << x;
  return text.str();
}

}  // namespace ltd
