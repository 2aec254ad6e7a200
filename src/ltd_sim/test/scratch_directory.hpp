#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "rail_core/problems.hpp"

namespace fixtures {

/// A directory of its own for each test; its files are removed with it.
class ScratchDirectory : public ::testing::Test {
 protected:
  ScratchDirectory() {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string pattern = ::testing::TempDir() + "/" + info->name() + "_XXXXXX";
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error(pattern + ": cannot be made");
    directory_ = std::filesystem::path(pattern).lexically_normal().string();
  }
  ~ScratchDirectory() override { std::filesystem::remove_all(directory_); }

  std::string path(const std::string& name) const { return directory_ + "/" + name; }
  const std::string& directory() const { return directory_; }

  void write(const std::string& name, const std::string& content) const {
    std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
    std::ofstream(path(name), std::ios::binary) << content;
  }

  std::string read(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    EXPECT_TRUE(file) << path(name);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }

  /// Replaces the first `from` in a file by `to`; it must be there.
  void replace(const std::string& name, const std::string& from, const std::string& to) const {
    std::string text = read(name);
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << name << " has no '" << from << "'";
    write(name, text.replace(at, from.size(), to));
  }

  /// Cells of a CSV file, line by line, the header first.
  std::vector<std::vector<std::string>> cells(const std::string& name) const {
    std::istringstream text(read(name));
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(text, line);) {
      std::vector<std::string> row(1);
      for (const char c : line) {
        if (c == ',') {
          row.emplace_back();
        } else {
          row.back() += c;
        }
      }
      rows.push_back(row);
    }
    return rows;
  }

 private:
  std::string directory_;
};

}  // namespace fixtures
