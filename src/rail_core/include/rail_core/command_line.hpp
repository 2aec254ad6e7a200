#pragma once

#include <string>
#include <vector>

namespace rail {

// What command line tools say alike.

/// True for `--word`: never a value, so the option before it lacks one. (-3 is a value.)
bool isOption(const std::string& word);

/// `--methd: unknown option, did you mean '--method'?`, or all that exist if none is like it.
std::string unknownOption(const std::string& given, const std::vector<std::string>& known);

}  // namespace rail
