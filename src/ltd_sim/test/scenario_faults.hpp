#pragma once

#include <string>
#include <vector>

#include "ltd_sim/scenario.hpp"
#include "scratch_directory.hpp"
#include "train_fixtures.hpp"

namespace fixtures {

/// A copy of config/ in which a test breaks something.
class ScenarioFaultTest : public fixtures::ScratchDirectory {
 protected:
  ScenarioFaultTest() { std::filesystem::copy(CONFIG_DIR, path("config"), std::filesystem::copy_options::recursive); }

  /// What is refused, without this test's directory.
  std::vector<std::string> faults(const std::vector<rail::Override>& overrides = {},
                                  const std::string& file = "scenarios/paper_1d.yaml") const {
    try {
      ltd::Scenario::load(path("config/" + file), overrides);
    } catch (const rail::ConfigError& error) {
      std::vector<std::string> lines = error.lines();
      for (std::string& line : lines) {
        const std::size_t at = line.find(path("config/"));
        if (at != std::string::npos) line.erase(at, path("config/").size());
      }
      return lines;
    }
    return {};
  }

  /// What is said of a scenario outside the copy.
  static std::vector<std::string> absent(const std::string& file) {
    try {
      ltd::Scenario::load(file, {});
    } catch (const rail::ConfigError& error) {
      return error.lines();
    }
    return {};
  }

  /// The one line that breaking `file` gives.
  std::string faultOf(const std::string& file, const std::string& from, const std::string& to) const {
    replace("config/" + file, from, to);
    const std::vector<std::string> lines = faults();
    EXPECT_EQ(lines.size(), 1u) << fixtures::joined(lines);
    return lines.empty() ? "accepted" : lines.front();
  }
  std::string faultOf(const std::vector<rail::Override>& overrides) const {
    const std::vector<std::string> lines = faults(overrides);
    EXPECT_EQ(lines.size(), 1u) << fixtures::joined(lines);
    return lines.empty() ? "accepted" : lines.front();
  }
};

}  // namespace fixtures
