// What bad profiles and dimensions get: file, line and rule.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "loco_dynamics/profile/profile_file.hpp"
#include "profile_fixtures.hpp"
#include "rail_core/yaml_reader.hpp"

namespace {

using loco::ProfileKind;
using loco::ProfilePoints;

/// A wheel of 0.7 mm steps, fewer points than the built-in one.
ProfilePoints wheel() {
  ProfilePoints points;
  for (double s_mm = -69.5; s_mm <= 60.0; s_mm += 0.7)
    points.push_back({1e-3 * s_mm, 1e-3 * loco::computeS1002Depth_mm(s_mm)});
  return points;
}

/// All messages about a profile, in one text.
std::string faults(ProfileKind kind, const ProfilePoints& points) {
  rail::Problems problems;
  const ProfilePoints read = loco::readProfileCsv(kind, fixtures::csvOf(points), "own.csv", problems);
  EXPECT_EQ(read.empty(), !problems.empty());
  std::string text;
  for (const std::string& line : problems.lines()) text += line + "\n";
  return text;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

template <typename Change>
ProfilePoints changed(ProfilePoints points, Change change) {
  for (loco::ProfilePoint& point : points) change(point);
  return points;
}

TEST(ProfileFaultsTest, GoodProfilesPass) {
  EXPECT_EQ(faults(ProfileKind::kWheel, wheel()), "");
  EXPECT_EQ(faults(ProfileKind::kWheel, loco::makeWheelPoints("S1002")), "");
  EXPECT_EQ(faults(ProfileKind::kWheel, loco::makeWheelPoints("coned_1_20")), "");
  EXPECT_EQ(faults(ProfileKind::kRail, loco::makeRailPoints("UIC60")), "");
}

TEST(ProfileFaultsTest, MirroredFlangeIsRefused) {
  ProfilePoints mirrored = changed(wheel(), [](auto& point) { point.y_m = -point.y_m; });
  std::reverse(mirrored.begin(), mirrored.end());
  EXPECT_TRUE(has(faults(ProfileKind::kWheel, mirrored), ": mirrored: the flange (tip at z = "));
}

TEST(ProfileFaultsTest, MetresCentimetresAndInchesAreRefused) {
  for (const double factor : {1e-3, 0.1, 1.0 / 25.4}) {
    const auto scale = [factor](auto& point) { point = {factor * point.y_m, factor * point.z_m}; };
    EXPECT_TRUE(has(faults(ProfileKind::kWheel, changed(wheel(), scale)), "are these millimetres?")) << factor;
    EXPECT_TRUE(
        has(faults(ProfileKind::kRail, changed(loco::makeRailPoints("UIC60"), scale)), "are these millimetres?"));
  }
  const auto metres = [](auto& point) { point.z_m *= 1e-3; };
  EXPECT_EQ(faults(ProfileKind::kRail, changed(loco::makeRailPoints("UIC60"), metres)),
            "own.csv: z_mm = spans 0.03: must span 14 to 60 mm: are these millimetres? metres would be right: multiply "
            "them by 1000\n");
}

TEST(ProfileFaultsTest, UnorderedPointsAreNamedByLine) {
  ProfilePoints points = wheel();
  std::swap(points[120], points[121]);
  EXPECT_TRUE(
      has(faults(ProfileKind::kWheel, points), "own.csv: line 123: y_mm = 14.5: must rise from point to point"));
  ProfilePoints backwards = wheel();
  std::reverse(backwards.begin(), backwards.end());
  EXPECT_TRUE(has(faults(ProfileKind::kWheel, backwards), "must rise from point to point"));
  ProfilePoints rail = loco::makeRailPoints("UIC60");
  rail[200] = rail[199];
  EXPECT_TRUE(has(faults(ProfileKind::kRail, rail), "line 202: y_mm"));
}

TEST(ProfileFaultsTest, OpenProfilesAreRefused) {
  ProfilePoints gap = wheel();
  gap.erase(gap.begin() + 100, gap.begin() + 110);
  EXPECT_TRUE(has(faults(ProfileKind::kWheel, gap), "is open here: 7.7"));
  ProfilePoints no_tip = wheel();
  no_tip.erase(no_tip.begin(), no_tip.begin() + 21);  // begins at the tip
  EXPECT_TRUE(has(faults(ProfileKind::kWheel, no_tip), "the flange is open"));
  ProfilePoints short_tread = wheel();
  short_tread.resize(125);
  EXPECT_TRUE(has(faults(ProfileKind::kWheel, short_tread), "the tread must reach y >= 20"));
  ProfilePoints no_face = loco::makeRailPoints("UIC60");
  no_face.erase(no_face.begin(), no_face.begin() + 30);
  EXPECT_TRUE(has(faults(ProfileKind::kRail, no_face), "the gauge face must reach 14 mm below the top"));
}

TEST(ProfileFaultsTest, WrongDirectionOfZIsRefused) {
  const auto turn = [](auto& point) { point.z_m = -point.z_m; };
  EXPECT_TRUE(has(faults(ProfileKind::kWheel, changed(wheel(), turn)), "z must point down"));
  EXPECT_TRUE(has(faults(ProfileKind::kRail, changed(loco::makeRailPoints("UIC60"), turn)), "z must point down"));
}

TEST(ProfileFaultsTest, AHeightFromAnotherPlaceIsToldWithWhatToDo) {
  const auto from_foot = [](auto& point) { point.z_m = 0.172 - point.z_m; };
  const std::string foot = faults(ProfileKind::kRail, changed(loco::makeRailPoints("UIC60"), from_foot));
  EXPECT_TRUE(has(foot,
                  "z_mm = 172: z must point down, so that the head's top has the least z, and this is the largest: "
                  "if this is the top, write 172 - z for every z"))
      << foot;
  const auto lower = [](auto& point) { point.z_m += 0.5e-3; };
  EXPECT_TRUE(has(faults(ProfileKind::kWheel, changed(loco::makeWheelPoints("S1002"), lower)), "it is 0.5"))
      << faults(ProfileKind::kWheel, changed(loco::makeWheelPoints("S1002"), lower));
  const auto aside = [](auto& point) { point.y_m += 2e-3; };
  const std::string back = faults(ProfileKind::kWheel, changed(wheel(), aside));
  EXPECT_TRUE(has(back, "which is 70 mm from it: add -2.5 to every y_mm")) << back;  // this wheel begins at -69.5
  // of a rail its shape alone counts: the gauge and its highest point place it
  const auto elsewhere = [](auto& point) { point = {point.y_m + 0.1, point.z_m + 0.005}; };
  EXPECT_EQ(faults(ProfileKind::kRail, changed(loco::makeRailPoints("UIC60"), elsewhere)), "");
}

TEST(ProfileFaultsTest, SlipsOfThePenAreRefused) {
  ProfilePoints spike = wheel();
  spike[130].z_m += 2e-3;
  EXPECT_TRUE(has(faults(ProfileKind::kWheel, spike), "line 132: z_mm"));
  EXPECT_TRUE(has(faults(ProfileKind::kWheel, changed(wheel(), [](auto& point) { point.z_m += 0.5e-3; })),
                  "z must be 0 within 0.1 mm at the taping line"));
  EXPECT_TRUE(has(faults(ProfileKind::kWheel, ProfilePoints(10, {0.0, 0.0})), "must have 20 at least"));
  rail::Problems problems;
  loco::readProfileCsv(ProfileKind::kWheel, "y_mm,z_mm\n1,nan\n", "own.csv", problems);
  EXPECT_FALSE(problems.empty());
}

class ProfileConfigTest : public testing::Test {
 protected:
  void SetUp() override {
    directory_ = std::filesystem::temp_directory_path() /
                 ("profiles_" + std::to_string(testing::UnitTest::GetInstance()->random_seed()) + "_" +
                  testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(directory_);
  }
  void TearDown() override { std::filesystem::remove_all(directory_); }
  void write(const std::string& name, const std::string& text) { std::ofstream(directory_ / name) << text; }

  loco::WheelRailGeometry read(const std::string& yaml) {
    write("p.yaml", yaml);
    problems_ = {};
    const rail::Document document = rail::Document::load((directory_ / "p.yaml").string(), {}, problems_);
    return loco::WheelRailGeometry::read(rail::YamlReader(document, problems_), 0.46);
  }
  std::string lines() const {
    std::string text;
    for (const std::string& line : problems_.lines()) text += line + "\n";
    return text;
  }

  std::filesystem::path directory_;
  rail::Problems problems_;
};

TEST_F(ProfileConfigTest, NamesAndFilesAreRead) {
  write("my_wheel.csv", fixtures::csvOf(loco::makeWheelPoints("S1002")));
  const std::string rest = ", rail: UIC60, inclination: 40, gauge_mm: 1435, flange_back_mm: 1360}\n";
  const loco::WheelRailGeometry named = read("{wheel: S1002" + rest);
  EXPECT_EQ(lines(), "");
  EXPECT_EQ(named.wheelRadius_m(), 0.46);
  const loco::WheelRailGeometry own = read("{wheel_file: my_wheel.csv" + rest);
  EXPECT_EQ(lines(), "");
  EXPECT_NEAR(own.wheel().at(-0.03).z_m, named.wheel().at(-0.03).z_m, 1e-9);
  read("{wheel: coned_1_20" + rest);
  EXPECT_EQ(lines(), "");
}

TEST_F(ProfileConfigTest, TheShippedPairsAreGood) {
  for (const char* name : {"s1002_uic60.yaml", "coned_1_20_uic60.yaml"}) {
    problems_ = {};
    const rail::Document document = rail::Document::load(std::string(CONFIG_DIR) + "/profiles/" + name, {}, problems_);
    const auto geometry = loco::WheelRailGeometry::read(rail::YamlReader(document, problems_), 0.5335);
    EXPECT_EQ(lines(), "");
    EXPECT_EQ(geometry.wheelRadius_m(), 0.5335);
  }
}

TEST_F(ProfileConfigTest, BadFilesAreNamed) {
  ProfilePoints spike = wheel();
  spike[130].z_m += 2e-3;
  write("my_wheel.csv", fixtures::csvOf(spike));
  read("{wheel_file: my_wheel.csv, rail: UIC60, inclination: 40, gauge_mm: 1435, flange_back_mm: 1360}\n");
  EXPECT_TRUE(has(lines(), "my_wheel.csv: line 132: z_mm")) << lines();
  read("{wheel: S1003, rail_file: absent.csv, inclination: 5, gauge_mm: 1435, flange_back_mm: 1360, guage: 1}\n");
  EXPECT_TRUE(has(lines(), "wheel = S1003: must be one of S1002, coned_1_20")) << lines();
  EXPECT_TRUE(has(lines(), "rail_file = absent.csv: cannot read")) << lines();
  EXPECT_TRUE(has(lines(), "inclination = 5: must be 0 (upright) or >= 10")) << lines();
  EXPECT_TRUE(has(lines(), "guage")) << lines();
}

TEST_F(ProfileConfigTest, WheelsetsThatDoNotFitTheTrackAreRefused) {
  const std::string pair = "{wheel: S1002, rail: UIC60, inclination: 40, ";
  read(pair + "gauge_mm: 1424, flange_back_mm: 1360}\n");
  EXPECT_TRUE(has(lines(),
                  "gauge_mm = 1424: gauge too narrow for the wheelset: its flanges are 1425.0 mm apart outside, 10 mm "
                  "below the taping line, with flange_back_mm = 1360.0"))
      << lines();
  read(pair + "gauge_mm: 1600, flange_back_mm: 1360}\n");
  EXPECT_TRUE(has(lines(), "gauge too wide for the wheelset")) << lines();
  read(pair + "gauge_mm: 1432, flange_back_mm: 1360}\n");
  EXPECT_EQ(lines(), "");
}

/// A flange twice as high as the tread is deep: a knob behind the root touches before the tread does.
TEST_F(ProfileConfigTest, PhantomContactIsRefused) {
  ProfilePoints knob = wheel();
  for (loco::ProfilePoint& point : knob) {  // a bump on the flange's root, smooth enough for all other rules
    const double u = (point.y_m + 0.036) / 0.012;
    if (std::abs(u) < 1.0) point.z_m += 6e-3 * (1.0 - u * u) * (1.0 - u * u);
  }
  write("knob.csv", fixtures::csvOf(knob));
  read("{wheel_file: knob.csv, rail: UIC60, inclination: 40, gauge_mm: 1435, flange_back_mm: 1360}\n");
  EXPECT_TRUE(has(lines(), "phantom contact") || has(lines(), "too narrow")) << lines();
}

}  // namespace
