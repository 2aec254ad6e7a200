#pragma once

#include <string>

namespace rail {

/// What is likely wrong with a text that is not YAML. A parser tells where it was stuck, often a line late and in its
/// own words; people slip at a few places that can be looked for.
/// @param line  1-based, where the parser was stuck
/// @param words  what the parser says
/// @return `line 10: ...`
std::string yamlFault(const std::string& text, int line, const std::string& words);

/// True if the quoted text that begins at this place (0-based) is never closed: yaml-cpp lets it end with the file.
bool isOpenQuote(const std::string& text, int line, int column);

}  // namespace rail
