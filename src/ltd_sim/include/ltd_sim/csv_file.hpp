#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace ltd {

/// A CSV file being written: numbers with all digits (17), text as it is.
class CsvFile {
 public:
  /// @throws std::runtime_error naming the path and the system's reason if it cannot be opened.
  CsvFile(const std::string& path, const std::vector<std::string>& columns);

  /// @throws std::runtime_error if the row has another number of cells than there are columns, or cannot be written.
  void row(const std::vector<std::string>& cells);
  void flush();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::string path_;
  std::size_t width_;
  std::unique_ptr<std::FILE, Close> file_;
};

/// The shortest of all digits: reading it back gives the same bits.
std::string allDigits(double x);

/// Makes a directory and its parents. @throws std::runtime_error with path and reason.
void makeDirectories(const std::string& path);

}  // namespace ltd
