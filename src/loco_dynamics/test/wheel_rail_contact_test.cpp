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
  EXPECT_EQ(run({"--write-wheel", "x.csv", "--load", "1e5"}).status, 2);
  EXPECT_EQ(run({"--lateral", "0"}).status, 2);
  EXPECT_EQ(run({"--help"}).status, 0);
}

TEST(WheelRailContactTest, FaultsOfTheCommandLineBeginWithTheProgramAndSayWhatThereIs) {
  const auto fault = [](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"--load", "1e5", "--lateral", "0"};
    words.insert(words.end(), more.begin(), more.end());
    return linesOf(run(words).errors).at(0);
  };
  EXPECT_EQ(fault({"--wheel", "s1003"}),
            "wheel_rail_contact: --wheel s1003: must be one of S1002, coned_1_20, or a CSV file that can be read, did "
            "you mean S1002?");
  EXPECT_EQ(fault({"--rail", "."}),
            "wheel_rail_contact: --rail .: must be one of UIC60, or a CSV file that can be read");
  EXPECT_EQ(fault({"--whel", "S1002"}), "wheel_rail_contact: --whel: unknown option, did you mean '--wheel'?");
  EXPECT_EQ(fault({"--wheel", "--yaw", "3"}), "wheel_rail_contact: --wheel: needs a value after it");
  EXPECT_EQ(fault({"--yaw=3"}), "wheel_rail_contact: --yaw=3: unknown option, write '--yaw', a blank, its value");
  EXPECT_EQ(fault({"S1002"}).rfind("wheel_rail_contact: S1002: unknown option; there are: --wheel, ", 0), 0u);
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

/// Files of one's own begin as copies of the built-in profiles: what is written is read again without a loss.
TEST(WheelRailContactTest, WrittenProfilesGiveTheSameContacts) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "wheel_rail_contact_test_copies";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  for (const std::string name : {"S1002", "coned_1_20"}) {
    const std::string wheel = (folder / (name + ".csv")).string(), rail = (folder / (name + "_rail.csv")).string();
    const Answer written = run({"--wheel", name, "--write-wheel", wheel, "--write-rail", rail});
    ASSERT_EQ(written.status, 0) << written.errors;
    EXPECT_EQ(written.output + written.errors, "");
    const std::vector<std::string> where = {"--load", "109500", "--lateral", "0,3,5.5", "--yaw", "3"};
    std::vector<std::string> named = where, copied = where;
    named.insert(named.end(), {"--wheel", name});
    copied.insert(copied.end(), {"--wheel", wheel, "--rail", rail});
    const std::vector<std::string> expected = linesOf(run(named).output), found = linesOf(run(copied).output);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 1; i < found.size(); ++i) {
      std::istringstream a(expected[i].substr(expected[i].find(',') + 1)), b(found[i].substr(found[i].find(',') + 1));
      for (std::string x, y; std::getline(a, x, ',') && std::getline(b, y, ',');) {
        // 15 digits of a mm are 1e-14 of a tread; overlaps of 0.1 mm, in which the forces count, have lost 1e-11 by
        // that, and the output shows 9 digits
        EXPECT_NEAR(std::stod(y), std::stod(x), 2e-8 * std::abs(std::stod(x)) + 1e-10) << found[i];
      }
    }
    const Answer again = run({"--wheel", name, "--write-wheel", wheel});
    EXPECT_EQ(again.status, 2);
    EXPECT_EQ(again.errors, "wheel_rail_contact: --write-wheel " + wheel +
                                ": is there already: remove it first, or give another name\n");
  }
  const std::string nowhere = (folder / "absent" / "x.csv").string();
  EXPECT_EQ(run({"--write-rail", nowhere}).errors,
            "wheel_rail_contact: --write-rail " + nowhere + ": cannot be written\n");
  std::filesystem::remove_all(folder);
}

TEST(WheelRailContactTest, YawToTheRightMirrorsYawToTheLeft) {
  const auto right = linesOf(run({"--load", "109500", "--lateral", "3", "--yaw", "5"}).output);
  const auto left = linesOf(run({"--load", "109500", "--lateral", "-3", "--yaw", "-5"}).output);
  ASSERT_EQ(right.size(), 3u);
  ASSERT_EQ(left.size(), 3u);
  EXPECT_EQ(right[1].substr(right[1].find(",1,")).substr(0, 12), left[2].substr(left[2].find(",1,")).substr(0, 12));
}

}  // namespace
