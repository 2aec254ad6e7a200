#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "rail_core/problems.hpp"

/// A directory of its own for each test; its files are removed with it.
class TestFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string pattern = ::testing::TempDir() + "/" + info->name() + "_XXXXXX";
    ASSERT_NE(mkdtemp(pattern.data()), nullptr) << pattern;
    directory_ = std::filesystem::path(pattern).lexically_normal().string();
  }
  void TearDown() override { std::filesystem::remove_all(directory_); }

  std::string path(const std::string& name) const { return directory_ + "/" + name; }

  /// Writes a file, with the directories above it, and returns its path.
  std::string write(const std::string& name, const std::string& content) const {
    const std::string file = path(name);
    std::filesystem::create_directories(std::filesystem::path(file).parent_path());
    std::ofstream(file, std::ios::binary) << content;
    return file;
  }

  /// Lines of `problems` without this test's directory.
  std::vector<std::string> linesOf(const rail::Problems& problems) const {
    std::vector<std::string> lines = problems.lines();
    for (std::string& line : lines) {
      for (auto at = line.find(directory_ + "/"); at != std::string::npos; at = line.find(directory_ + "/")) {
        line.erase(at, directory_.size() + 1);
      }
    }
    return lines;
  }

 private:
  std::string directory_;
};

using Lines = std::vector<std::string>;
