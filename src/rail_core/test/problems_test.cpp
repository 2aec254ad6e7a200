#include "rail_core/problems.hpp"

#include <gtest/gtest.h>

namespace rail {
namespace {

TEST(ProblemsTest, LineNamesFileKeyValueAndRule) {
  Problems problems;
  problems.add("train.yaml", "groups.0.count", "-1", "must be an integer >= 1");
  problems.add("train.yaml", "name", "is missing");
  problems.add("train.yaml", "", "is empty");
  EXPECT_EQ(problems.lines(), (std::vector<std::string>{"train.yaml: groups.0.count = -1: must be an integer >= 1",
                                                        "train.yaml: name: is missing", "train.yaml: is empty"}));
}

TEST(ProblemsTest, ValueOfSeveralLinesIsShownOnOneAndCut) {
  Problems problems;
  problems.add("f", "table", "a\n\tb\r" + std::string(100, 'x'), "rule");
  EXPECT_EQ(problems.lines().front(), "f: table = a\\n\\tb\\r" + std::string(52, 'x') + "...: rule");
}

TEST(ProblemsTest, NothingIsThrownWithoutProblems) { EXPECT_NO_THROW(Problems().throwIfAny()); }

TEST(ProblemsTest, AllLinesAreThrownAtOnce) {
  Problems problems;
  problems.add("f", "a", "1", "wrong");
  problems.add("f", "b", "2", "wrong too");
  try {
    problems.throwIfAny();
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_EQ(error.lines().size(), 2u);
    EXPECT_STREQ(error.what(), "f: a = 1: wrong\nf: b = 2: wrong too");
  }
}

TEST(NearestWordTest, FindsSlipsOfTheFinger) {
  const std::vector<std::string> known = {"mass_kg", "length_m", "axles"};
  EXPECT_EQ(nearestWord("mas_kg", known), "mass_kg");     // a letter left out
  EXPECT_EQ(nearestWord("lenght_m", known), "length_m");  // swapped
  EXPECT_EQ(nearestWord("nmae", {"name"}), "name");       // one slip, not two
  EXPECT_EQ(nearestWord("Axles", known), "axles");        // case
  EXPECT_EQ(nearestWord("mass", known), "mass_kg");       // the unit left out
  EXPECT_EQ(nearestWord("mass_t", known), "mass_kg");     // another unit
}

TEST(NearestWordTest, AnotherWordIsNotNear) {
  EXPECT_EQ(nearestWord("colour", {"mass_kg", "length_m", "axles"}), "");
  EXPECT_EQ(nearestWord("x", {}), "");
  EXPECT_EQ(nearestWord("ab", {"xy"}), "");
}

TEST(NearestWordTest, OfTwoTheNearerIsTaken) { EXPECT_EQ(nearestWord("speed_2", {"speed_11", "speed_1"}), "speed_1"); }

}  // namespace
TEST(NearestFirstTest, AMisspeltBeginningComesFirstThenFewestSlips) {
  const std::vector<std::string> known = {"paper_1d", "paper_3d", "emergency_stop", "paper_3d_two_point"};
  EXPECT_EQ(nearestFirst("emergncy", known).front(), "emergency_stop");
  EXPECT_EQ(nearestFirst("paper_3", known),
            (std::vector<std::string>{"paper_3d", "paper_3d_two_point", "paper_1d", "emergency_stop"}));
  EXPECT_TRUE(isMisspeltBeginning("emergncy", "emergency_stop"));
  EXPECT_FALSE(isMisspeltBeginning("emergncy", "paper_1d"));
  EXPECT_FALSE(isMisspeltBeginning("wagons", "paper_1d"));
  EXPECT_FALSE(isMisspeltBeginning("x", "paper_1d"));
}

TEST(ProblemsTest, AMessageShowsTheFirstFortyAndCountsTheRest) {
  rail::Problems problems;
  for (int i = 0; i < 325; ++i) problems.add("a.csv", "line " + std::to_string(i), "must rise");
  try {
    problems.throwIfAny();
    FAIL();
  } catch (const rail::ConfigError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("line 39: must rise\nand 285 problems more"), std::string::npos) << text;
    EXPECT_EQ(error.lines().size(), 325u);
  }
}

TEST(ProblemsTest, AProblemAddedTwiceStandsOnceButIsCountedTwice) {
  rail::Problems problems;
  problems.add("a.yaml", "mass_kg", "-1", "must be > 0");
  problems.add("a.yaml", "mass_kg", "-1", "must be > 0");
  EXPECT_EQ(problems.lines().size(), 1u);
  EXPECT_EQ(problems.count(), 2u);
}

}  // namespace rail
