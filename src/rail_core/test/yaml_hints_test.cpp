// What people slip at in YAML, and the line that they are told.

#include "yaml_hints.hpp"

#include <gtest/gtest.h>

#include "rail_core/document.hpp"

namespace {

using Lines = std::vector<std::string>;

Lines faults(const std::string& text) {
  rail::Problems problems;
  rail::Document::parse(text, "f", problems);
  return problems.lines();
}

TEST(YamlHintsTest, TabsAreNamed) {
  EXPECT_EQ(faults("a: 1\nrun:\n\tend: 3\n"),
            Lines{"f: line 3: is not YAML: is indented with a tab: must be indented with blanks"});
}

TEST(YamlHintsTest, AMissingBlankIsNamedInItsOwnLineThoughTheParserIsStuckInTheNext) {
  EXPECT_EQ(faults("a: 1\nend_time_s:600   # s\nb: 2\n"),
            Lines{"f: line 2: is not YAML: lacks a blank behind the colon: 'end_time_s:600'"});
  EXPECT_EQ(faults("run:\n  a: 1\n  end_time_s:600\n  b: 2\n"),
            Lines{"f: line 3: is not YAML: lacks a blank behind the colon: 'end_time_s:600'"});
}

TEST(YamlHintsTest, AColonInATextAsksForQuotes) {
  EXPECT_EQ(faults("description: two: one and one\n"),
            Lines{"f: line 1: is not YAML: has a value with ': ' in it, which must stand in quotes"});
}

TEST(YamlHintsTest, QuotesThatAreNotClosedAreRefusedThoughTheParserLetsThemPass) {
  EXPECT_EQ(faults("a: 1\nname: \"Two\nb: 1\nc: 2\n"), Lines{"f: line 2: is not YAML: has a quote that is not closed"});
  EXPECT_EQ(faults("\xEF\xBB\xBFname: 'it''s\n"), Lines{"f: line 1: is not YAML: has a quote that is not closed"});
  EXPECT_EQ(faults("a: \"x\\\"\n"), Lines{"f: line 1: is not YAML: has a quote that is not closed"});
  EXPECT_EQ(faults("a: 'it''s'\nb: \"\\\"\"\nc: |\n  \"x\nd: it's\ne: \"z\xC3\xB6\" # it's\n"), Lines{});
}

TEST(YamlHintsTest, BracketsAndEqualSigns) {
  EXPECT_EQ(faults("a:\n  - {k: 1, l: 2}\n  - {k: 1, l: 2\n"),
            Lines{"f: line 3: is not YAML: has a bracket that is not closed"});
  EXPECT_EQ(faults("a: 1\nlength_m = 14\nb: 2\n"), Lines{"f: line 2: is not YAML: has '=', must be ':'"});
}

TEST(YamlHintsTest, AnEntryWithNothingInItIsPassedOver) {
  EXPECT_EQ(faults("a:\n  - {k: 1\n  - \n"), Lines{"f: line 2: is not YAML: has a bracket that is not closed"});
}

TEST(YamlHintsTest, OtherwiseTheParsersWordsAndWhereToLook) {
  EXPECT_EQ(faults("a: 1\n   b: 2\n"),
            Lines{"f: line 2: is not YAML: illegal map value; look there and in the lines before for the indentation, "
                  "and for brackets and quotes that are not closed"});
}

TEST(YamlHintsTest, AKeyGivenTwiceIsNamedWithBothLines) {
  EXPECT_EQ(faults("run:\n  a: 1\n  b: 2\n  a: 3\n"), Lines{"f: run.a: is given twice, in line 2 and in line 4"});
}

}  // namespace
