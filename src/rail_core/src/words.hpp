#pragma once

#include <string>
#include <vector>

namespace rail {

bool contains(const std::vector<std::string>& words, const std::string& word);

/// "a, b, c"
std::string joinWords(const std::vector<std::string>& words);

}  // namespace rail
