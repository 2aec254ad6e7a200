#include <gtest/gtest.h>

#include <functional>

#include "rail_core/yaml_reader.hpp"

namespace rail {
namespace {

using Lines = std::vector<std::string>;

/// What one reading of the map `text` reports.
Lines faults(const std::string& text, const std::function<void(YamlReader&)>& read) {
  Problems problems;
  const Document document = Document::parse(text, "f.yaml", problems);
  YamlReader reader(document, problems);
  read(reader);
  return problems.lines();
}

Lines numberFaults(const std::string& value, const Range& range) {
  return faults("k: " + value + "\n", [&](YamlReader& reader) { reader.number("k", range); });
}

TEST(YamlReaderFaultsTest, NumbersOutsideTheirRange) {
  EXPECT_EQ(numberFaults("0", positive()), Lines{"f.yaml: k = 0: must be a number > 0"});
  EXPECT_EQ(numberFaults("-1e-9", notNegative()), Lines{"f.yaml: k = -1e-9: must be a number >= 0"});
  EXPECT_EQ(numberFaults("1.01", between(0.0, 1.0)), Lines{"f.yaml: k = 1.01: must be a number >= 0 and <= 1"});
  EXPECT_EQ(numberFaults("-0.01", between(0.0, 1.0)), Lines{"f.yaml: k = -0.01: must be a number >= 0 and <= 1"});
  EXPECT_EQ(numberFaults("2.5", above(2.5)), Lines{"f.yaml: k = 2.5: must be a number > 2.5"});
  EXPECT_EQ(numberFaults("0", aboveUpTo(0.0, 0.1)), Lines{"f.yaml: k = 0: must be a number > 0 and <= 0.1"});
  EXPECT_EQ(numberFaults("5", Range{-1.0, 5.0, true, false}), Lines{"f.yaml: k = 5: must be a number >= -1 and < 5"});
}

TEST(YamlReaderFaultsTest, WhatIsNoNumber) {
  for (const char* const value : {"nan", ".nan", "inf", "-.inf", "true", "1_000", "--1", "."}) {
    EXPECT_EQ(numberFaults(value, anyNumber()), Lines{std::string("f.yaml: k = ") + value + ": must be a number"});
  }
  EXPECT_EQ(numberFaults("3,2", anyNumber()), Lines{"f.yaml: k = 3,2: must be a number, with a decimal point"});
  for (const char* const value : {"3 kN", "0x1F", "1e", "30 %", "-2.5m"}) {
    EXPECT_EQ(numberFaults(value, anyNumber()),
              Lines{std::string("f.yaml: k = ") + value + ": must be a number, without unit or other text"});
  }
  EXPECT_EQ(numberFaults("\"3\"", anyNumber()), Lines{"f.yaml: k = \"3\": must be a number, not text"});
  EXPECT_EQ(numberFaults("1e999", positive()), Lines{"f.yaml: k = 1e999: is beyond the range of a double"});
  EXPECT_EQ(numberFaults("{a: 1}", positive()), Lines{"f.yaml: k = {...}: must be a number > 0"});
  EXPECT_EQ(numberFaults("[1]", positive()), Lines{"f.yaml: k = [...]: must be a number > 0, not a list"});
  EXPECT_EQ(numberFaults("", positive()), Lines{"f.yaml: k: is empty: must be a number > 0"});
}

TEST(YamlReaderFaultsTest, RowsWithoutTheirOwnBracketsAreToldOnce) {
  EXPECT_EQ(faults("notches: [0, 2]", [](YamlReader& reader) { reader.rows("notches", 2); }),
            Lines{"f.yaml: notches = [...]: must be a list of lists of 2 numbers, in brackets of their own: [[...], "
                  "[...]]"});
}

TEST(YamlReaderFaultsTest, APathInPlaceOfAMapIsToldTheKeyThatNamesFiles) {
  const auto read = [](YamlReader& reader) { reader.map("train"); };
  EXPECT_EQ(faults("train: trains/t.yaml", read),
            Lines{"f.yaml: train = trains/t.yaml: must be a map; a file is named by train_file"});
  EXPECT_EQ(faults("train: long", read), Lines{"f.yaml: train = long: must be a map"});
}

TEST(YamlReaderFaultsTest, MissingKeysWithTheirRule) {
  const Lines expected = {"f.yaml: a: is missing: must be a number > 0",
                          "f.yaml: b: is missing: must be an integer >= 1",
                          "f.yaml: c: is missing: must be true or false",
                          "f.yaml: d: is missing: must be text, and not empty",
                          "f.yaml: e: is missing: must be one of: x, y",
                          "f.yaml: f: is missing: must be a list of numbers",
                          "f.yaml: g: is missing: must be a list of lists of 2 numbers",
                          "f.yaml: h: is missing: must be a map, here or in the file that h_file names",
                          "f.yaml: i: is missing: must be a list of maps"};
  EXPECT_EQ(faults("{}",
                   [](YamlReader& reader) {
                     reader.number("a", positive());
                     reader.integer("b", 1);
                     reader.boolean("c");
                     reader.text("d");
                     reader.choice("e", {"x", "y"});
                     reader.numbers("f", positive());
                     reader.rows("g", 2);
                     reader.map("h");
                     reader.maps("i");
                   }),
            expected);
}

TEST(YamlReaderFaultsTest, IntegersAreWrittenAsSuch) {
  const auto integerFaults = [](const std::string& value, int low, int high) {
    return faults("k: " + value, [&](YamlReader& reader) { reader.integer("k", low, high); });
  };
  const int most = std::numeric_limits<int>::max();
  EXPECT_EQ(integerFaults("3.0", 1, most),
            Lines{"f.yaml: k = 3.0: must be an integer >= 1, written without point and exponent"});
  EXPECT_EQ(integerFaults("1e3", 1, 9),
            Lines{"f.yaml: k = 1e3: must be an integer >= 1 and <= 9, written without point and exponent"});
  EXPECT_EQ(integerFaults("0", 1, 9), Lines{"f.yaml: k = 0: must be an integer >= 1 and <= 9"});
  EXPECT_EQ(integerFaults("10", 1, 9), Lines{"f.yaml: k = 10: must be an integer >= 1 and <= 9"});
  EXPECT_EQ(integerFaults("9999999999", 1, most),
            Lines{"f.yaml: k = 9999999999: must be an integer >= 1 and <= 2147483647"});
  EXPECT_EQ(integerFaults("'3'", 1, 9), Lines{"f.yaml: k = \"3\": must be an integer >= 1 and <= 9, not text"});
  EXPECT_EQ(integerFaults("three", 1, 9), Lines{"f.yaml: k = three: must be an integer >= 1 and <= 9"});
}

TEST(YamlReaderFaultsTest, BooleansTextsAndChoices) {
  EXPECT_EQ(faults("{a: yes, b: 1, c: 'true', d: '', e: [x], f: z}",
                   [](YamlReader& reader) {
                     reader.boolean("a");
                     reader.boolean("b");
                     reader.boolean("c");
                     reader.text("d");
                     reader.text("e");
                     reader.choice("f", {"x", "y"});
                   }),
            (Lines{"f.yaml: a = yes: must be true or false", "f.yaml: b = 1: must be true or false",
                   "f.yaml: c = \"true\": must be true or false", "f.yaml: d = \"\": must be text, and not empty",
                   "f.yaml: e = [...]: must be text, and not empty", "f.yaml: f = z: must be one of: x, y"}));
}

TEST(YamlReaderFaultsTest, EntriesOfListsWithTheirIndex) {
  EXPECT_EQ(faults("{a: [1, -1, x], b: 3, c: [[0, 1], [0], 5, [1, y]], d: 7, e: [{k: 1}, 2], f: {}, g: 1}",
                   [](YamlReader& reader) {
                     EXPECT_EQ(reader.numbers("a", positive()).size(), 3u);
                     reader.numbers("b", positive());
                     reader.rows("c", 2);
                     reader.rows("d", 2);
                     EXPECT_EQ(reader.maps("e").size(), 2u);
                     reader.maps("f");
                     EXPECT_FALSE(reader.map("g").present());
                   }),
            (Lines{"f.yaml: a.1 = -1: must be a number > 0", "f.yaml: a.2 = x: must be a number > 0",
                   "f.yaml: b = 3: must be a list of numbers", "f.yaml: c.1 = [...]: must be a list of 2 numbers",
                   "f.yaml: c.2 = 5: must be a list of 2 numbers", "f.yaml: c.3.1 = y: must be a number",
                   "f.yaml: d = 7: must be a list of lists of 2 numbers", "f.yaml: e.1 = 2: must be a map",
                   "f.yaml: f = {...}: must be a list of maps", "f.yaml: g = 1: must be a map"}));
}

TEST(YamlReaderFaultsTest, OptionalKeysThatAreGivenMustBeGood) {
  EXPECT_EQ(faults("{a: -1, b: 0, c: 2, d: '', e: z}",
                   [](YamlReader& reader) {
                     reader.numberOr("a", positive(), 1.0);
                     reader.integerOr("b", 1, 5, 1);
                     reader.booleanOr("c", true);
                     reader.textOr("d", "x");
                     reader.choiceOr("e", {"x"}, "x");
                   })
                .size(),
            5u);
}

TEST(YamlReaderFaultsTest, UnknownKeysWithTheNearestKnownOne) {
  EXPECT_EQ(faults("{mas_kg: 5, colour: red, sub: {x: 1}, seed: 3}",
                   [](YamlReader& reader) {
                     reader.numberOr("mass_kg", positive(), 1.0);
                     reader.numberOr("axles", positive(), 1.0);
                     reader.has("seeds");
                     reader.finish();
                   }),
            (Lines{"f.yaml: mas_kg = 5: unknown key, did you mean 'mass_kg'?",
                   "f.yaml: colour = red: unknown key, known here: mass_kg, axles, seeds",
                   "f.yaml: sub = {...}: unknown key, known here: mass_kg, axles, seeds",
                   "f.yaml: seed = 3: unknown key, did you mean 'seeds'?"}));
}

TEST(YamlReaderFaultsTest, AKeyIsRefusedAsSuchOnlyIfItIsGiven) {
  EXPECT_EQ(faults("{a: 5, b: 6}",
                   [](YamlReader& reader) {
                     reader.refuseKey("a", "is of no use");
                     reader.refuseKey("gone", "is of no use");
                     reader.ignore("b");
                     reader.ignore("gone too");
                     reader.finish();
                   }),
            Lines{"f.yaml: a = 5: is of no use"});
}

TEST(YamlReaderFaultsTest, KeyThatWasOnlyLookedForIsNotUsed) {
  EXPECT_EQ(faults("{a: 5}",
                   [](YamlReader& reader) {
                     EXPECT_TRUE(reader.has("a"));
                     reader.finish();
                   }),
            Lines{"f.yaml: a = 5: is not used here"});
}

TEST(YamlReaderFaultsTest, RelationsAreRefusedWithTheValueButNotTwice) {
  EXPECT_EQ(faults("{h: 0.3, list: [1, 2], sub: {x: 1}, bad: -1}",
                   [](YamlReader& reader) {
                     reader.refuse("h", "must divide H");
                     reader.refuse("list.1", "must be odd");
                     reader.map("sub").refuse("", "makes no sense");
                     reader.number("bad", positive());
                     reader.refuse("bad", "must be less than good");
                     reader.number("gone", positive());
                     reader.refuse("gone", "must be less than good");
                   }),
            (Lines{"f.yaml: h = 0.3: must divide H", "f.yaml: list.1 = 2: must be odd", "f.yaml: sub: makes no sense",
                   "f.yaml: bad = -1: must be a number > 0", "f.yaml: gone: is missing: must be a number > 0"}));
}

TEST(YamlReaderFaultsTest, TenFaultsOfOneFileComeOutAtOnce) {
  const Lines lines = faults(
      "{mass_kg: -1, axles: 3.0, name: '', loaded: yes, kind: boat, curve: [1, x], points: [[1]], "
      "brake: 5, lenght_m: 3}",
      [](YamlReader& reader) {
        reader.number("mass_kg", positive());
        reader.integer("axles", 2);
        reader.text("name");
        reader.boolean("loaded");
        reader.choice("kind", {"wagon", "locomotive"});
        reader.numbers("curve", positive());
        reader.rows("points", 2);
        YamlReader brake = reader.map("brake");
        brake.number("force_N", positive());  // silent: the map itself has been reported
        brake.finish();
        reader.number("length_m", positive());
        reader.finish();
      });
  EXPECT_EQ(lines,
            (Lines{"f.yaml: mass_kg = -1: must be a number > 0",
                   "f.yaml: axles = 3.0: must be an integer >= 2, written without point and exponent",
                   "f.yaml: name = \"\": must be text, and not empty", "f.yaml: loaded = yes: must be true or false",
                   "f.yaml: kind = boat: must be one of: wagon, locomotive",
                   "f.yaml: curve.1 = x: must be a number > 0", "f.yaml: points.0 = [...]: must be a list of 2 numbers",
                   "f.yaml: brake = 5: must be a map", "f.yaml: length_m: is missing: must be a number > 0",
                   "f.yaml: lenght_m = 3: unknown key, did you mean 'length_m'?"}));
}

}  // namespace
}  // namespace rail
