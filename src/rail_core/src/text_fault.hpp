#pragma once

#include <string>

namespace rail {

/// Why the bytes of a file are no text in UTF-8, with the line where there is one and what to do; "" if they are.
std::string textFault(const std::string& bytes);

}  // namespace rail
