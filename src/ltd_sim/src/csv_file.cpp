#include "ltd_sim/csv_file.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace ltd {

CsvFile::CsvFile(const std::string& path, const std::vector<std::string>& columns)
    : path_(path), width_(columns.size()), file_(std::fopen(path.c_str(), "w")) {
  if (!file_) throw std::runtime_error(path + ": cannot be written: " + std::strerror(errno));
  row(columns);
}

void CsvFile::row(const std::vector<std::string>& cells) {
  if (cells.size() != width_) throw std::runtime_error(path_ + ": row and columns differ");
  std::string line;
  for (const std::string& cell : cells) line += (line.empty() && &cell == &cells.front() ? "" : ",") + cell;
  line += '\n';
  if (std::fputs(line.c_str(), file_.get()) < 0)
    throw std::runtime_error(path_ + ": cannot be written: " + std::strerror(errno));
}

void CsvFile::flush() {
  if (std::fflush(file_.get()) != 0) throw std::runtime_error(path_ + ": cannot be written: " + std::strerror(errno));
}

std::string allDigits(double x) {
  char text[32];
  for (int digits = 15; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, x);
    if (std::strtod(text, nullptr) == x) break;
  }
  return text;
}

void makeDirectories(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw std::runtime_error(path + ": cannot be made: " + error.message());
}

}  // namespace ltd
