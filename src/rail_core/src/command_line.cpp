#include "rail_core/command_line.hpp"

#include "rail_core/problems.hpp"
#include "words.hpp"

namespace rail {

bool isOption(const std::string& word) { return word.size() > 2 && word.compare(0, 2, "--") == 0; }

std::string unknownOption(const std::string& given, const std::vector<std::string>& known) {
  const std::size_t equals = given.find('=');
  const std::string name = given.substr(0, equals);
  std::string text = given + ": unknown option";
  if (equals != std::string::npos && contains(known, name)) return text + ", write '" + name + "', a blank, its value";
  const std::string near = nearestWord(name, known);
  return text + (near.empty() ? "; there are: " + joinWords(known) : ", did you mean '" + near + "'?");
}

}  // namespace rail
