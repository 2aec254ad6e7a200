#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "profile_fixtures.hpp"
#include "wheel_rail_contact_table.hpp"

namespace {

struct Answer {
  int status;
  std::string output;
  std::string errors;
};

Answer run(const std::vector<std::string>& arguments) {
  std::ostringstream out, errors;
  const int status = loco::wheelRailContactProgram(arguments, out, errors);
  return {status, out.str(), errors.str()};
}

const std::string kHeader =
    "side,y_mm,yaw_mrad,patch,y_rail_mm,z_rail_mm,angle_rad,rolling_radius_mm,normal_force_N,a_mm,b_mm,area_mm2,p_max_"
    "MPa\n";

std::vector<std::string> linesOf(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(WheelRailContactTest, BadArgumentsAreNamed) {
  for (const std::vector<std::string>& bad : std::vector<std::vector<std::string>>{{"--wheels", "S1002"},
                                                                                   {"--wheel", "S1003"},
                                                                                   {"--rail", "absent.csv"},
                                                                                   {"--inclination", "5"},
                                                                                   {"--gauge", "1.435"},
                                                                                   {"--gauge", "1420"},
                                                                                   {"--gauge", "1600"},
                                                                                   {"--flange-back", "x"},
                                                                                   {"--radius", "0.5335"},
                                                                                   {"--load", "0"},
                                                                                   {"--yaw", "nan"},
                                                                                   {"--friction", "2"},
                                                                                   {"--lateral", "0,,2"},
                                                                                   {"--lateral", "0;2"},
                                                                                   {"--sections", "/no/such/file"},
                                                                                   {"--radius"}}) {
    std::vector<std::string> arguments = bad;
    if (bad[0] != "--load") arguments.insert(arguments.begin(), {"--load", "1e5"});
    if (bad[0] != "--lateral") arguments.insert(arguments.begin(), {"--lateral", "0"});
    const Answer answer = run(arguments);
    EXPECT_EQ(answer.status, 2) << bad[0];
    EXPECT_TRUE(answer.output.empty()) << bad[0];
    EXPECT_NE(answer.errors.find(bad[0]), std::string::npos) << answer.errors;
  }
  EXPECT_EQ(run({"--load", "1e5"}).status, 2);
  EXPECT_EQ(run({"--lateral", "0"}).status, 2);
  EXPECT_EQ(run({"--help"}).status, 0);
}

TEST(WheelRailContactTest, RowsAreInOrderAndDisplacementIsToTheRight) {
  const Answer answer = run({"--load", "109500", "--lateral", "0,4"});
  EXPECT_EQ(answer.status, 0) << answer.errors;
  const std::vector<std::string> lines = linesOf(answer.output);
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines[0] + "\n", kHeader);
  EXPECT_EQ(lines[1].substr(0, 9), "left,0,0,");
  EXPECT_EQ(lines[2].substr(0, 10), "right,0,0,");
  EXPECT_EQ(lines[1].substr(4), lines[2].substr(5));  // mirror images
  const auto radius = [&](const std::string& line) {
    std::istringstream cells(line);
    std::string cell;
    for (int i = 0; i < 8; ++i) std::getline(cells, cell, ',');
    return std::stod(cell);
  };
  EXPECT_GT(radius(lines[4]), radius(lines[3]) + 1.0);  // the right wheel runs towards its flange
}

/// Over all places, light and heavy: a number, and not below what the patch's own share of the load makes of its
/// ellipse.
TEST(WheelRailContactTest, PressuresAreThoseOfTheShape) {
  for (const std::string load : {"100", "109500"}) {
    const auto lines = linesOf(run({"--load", load, "--lateral", "0,0.5,1,1.5,2,3,4,4.5,5,5.1,5.2,5.5,6,7"}).output);
    for (std::size_t i = 1; i < lines.size(); ++i) {
      std::istringstream cells(lines[i].substr(lines[i].find(',') + 1));
      std::vector<double> value;
      for (std::string cell; std::getline(cells, cell, ',');) value.push_back(std::stod(cell));
      ASSERT_EQ(value.size(), 12u);
      const double ellipse_MPa = 1.5 * value[7] / value[10];
      EXPECT_GT(value[11], 0.9 * ellipse_MPa) << lines[i];
      EXPECT_LT(value[11], 8000.0) << lines[i];  // a wheel up on its flange at 7 mm: 172 kN on 0.8 mm, ellipse 5980
    }
  }
}

TEST(WheelRailContactTest, DisplacementsThatDoNotStandAreNamedAndTheOthersComputed) {
  const Answer answer = run({"--load", "109500", "--lateral", "2,-50"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.errors.find("--lateral -50: the wheelset does not stand"), std::string::npos) << answer.errors;
  EXPECT_EQ(linesOf(answer.output).size(), 3u);
}

TEST(WheelRailContactTest, FilesGiveWhatNamesGive) {
  const std::string path = (std::filesystem::temp_directory_path() / "wheel_rail_contact_test_wheel.csv").string();
  std::ofstream(path) << fixtures::csvOf(loco::makeWheelPoints("S1002"));
  const auto named = linesOf(run({"--load", "109500", "--lateral", "3"}).output);
  const auto own = linesOf(run({"--load", "109500", "--lateral", "3", "--wheel", path}).output);
  ASSERT_EQ(own.size(), named.size());
  for (std::size_t i = 1; i < own.size(); ++i) EXPECT_EQ(own[i].substr(0, 15), named[i].substr(0, 15));
  std::filesystem::remove(path);
}

TEST(WheelRailContactTest, YawToTheRightMirrorsYawToTheLeft) {
  const auto right = linesOf(run({"--load", "109500", "--lateral", "3", "--yaw", "5"}).output);
  const auto left = linesOf(run({"--load", "109500", "--lateral", "-3", "--yaw", "-5"}).output);
  ASSERT_EQ(right.size(), 3u);
  ASSERT_EQ(left.size(), 3u);
  EXPECT_EQ(right[1].substr(right[1].find(",1,")).substr(0, 12), left[2].substr(left[2].find(",1,")).substr(0, 12));
}

}  // namespace
