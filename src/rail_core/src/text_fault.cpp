#include "text_fault.hpp"

#include <algorithm>
#include <cstddef>

namespace rail {
namespace {

unsigned char byteAt(const std::string& bytes, std::size_t i) { return static_cast<unsigned char>(bytes[i]); }

/// Bytes of the UTF-8 character that begins at `i`; 0 if none does. Overlong forms and surrogates are let pass: no
/// other encoding gives them by chance.
std::size_t characterLength(const std::string& bytes, std::size_t i) {
  const unsigned char first = byteAt(bytes, i);
  const std::size_t length = first < 0x80 ? 1 : first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (length == 0 || first > 0xF4 || i + length > bytes.size()) return 0;
  for (std::size_t j = i + 1; j < i + length; ++j) {
    if ((byteAt(bytes, j) & 0xC0U) != 0x80U) return 0;
  }
  return length;
}

std::string atLine(const std::string& bytes, std::size_t i) {
  const auto end = bytes.begin() + static_cast<std::ptrdiff_t>(i);
  return "line " + std::to_string(1 + std::count(bytes.begin(), end, '\n')) + ": ";
}

}  // namespace

std::string textFault(const std::string& bytes) {
  const std::string start = bytes.substr(0, 2);
  if (start == "\xFF\xFE" || start == "\xFE\xFF") return "is text in UTF-16: must be UTF-8, save it so";
  if (bytes.compare(0, 4, "PK\x03\x04") == 0)
    return "is a zip file or a spreadsheet: must be text, export the sheet as CSV in UTF-8";
  for (std::size_t i = 0; i < bytes.size();) {
    if (bytes[i] == '\0') return atLine(bytes, i) + "holds a zero byte: must be text in UTF-8";
    const std::size_t length = characterLength(bytes, i);
    if (length == 0)
      return atLine(bytes, i) + "holds a character that is not UTF-8 (an umlaut?): save the file as UTF-8";
    i += length;
  }
  const bool only_returns = bytes.find('\r') != std::string::npos && bytes.find('\n') == std::string::npos;
  return only_returns ? "has lines that end in CR alone: must end in LF or CRLF" : "";
}

}  // namespace rail
