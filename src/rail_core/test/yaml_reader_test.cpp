#include "rail_core/yaml_reader.hpp"

#include "test_files.hpp"

namespace rail {
namespace {

class YamlReaderTest : public TestFiles {
 protected:
  YamlReader read(const std::string& text) {
    document_ = Document::parse(text, "f.yaml", problems_);
    return YamlReader(document_, problems_);
  }
  Document document_;
  Problems problems_;
};

TEST_F(YamlReaderTest, GoodValuesAreGivenExactly) {
  YamlReader reader = read(
      "{a: 0.1, b: -12, c: true, d: 3, e: right, f: [1, 2.5e3, +.5], g: [[0, 1], [2, 3]], h: {i: 1.}, j: [{k: 1}, {k: "
      "2}]}");
  EXPECT_EQ(reader.number("a", positive()), 0.1);
  EXPECT_EQ(reader.integer("b", -12, 5), -12);
  EXPECT_TRUE(reader.boolean("c"));
  EXPECT_EQ(reader.text("d"), "3");
  EXPECT_EQ(reader.choice("e", {"left", "right"}), "right");
  EXPECT_EQ(reader.numbers("f", positive()), (std::vector<double>{1.0, 2500.0, 0.5}));
  EXPECT_EQ(reader.rows("g", 2), (std::vector<std::vector<double>>{{0.0, 1.0}, {2.0, 3.0}}));
  YamlReader inner = reader.map("h");
  EXPECT_EQ(inner.number("i", between(1.0, 1.0)), 1.0);
  EXPECT_EQ(inner.path(), "h");
  inner.finish();
  std::vector<YamlReader> entries = reader.maps("j");
  ASSERT_EQ(entries.size(), 2u);
  EXPECT_EQ(entries[1].integer("k", 0), 2);
  EXPECT_EQ(entries[1].path(), "j.1");
  reader.finish();
  EXPECT_EQ(problems_.lines(), Lines{});
}

TEST_F(YamlReaderTest, BoundsBelongToTheRangeOrNotAsSaid) {
  YamlReader reader = read("{zero: 0, one: 1}");
  reader.number("zero", notNegative());
  reader.number("zero", between(0.0, 1.0));
  reader.number("one", between(0.0, 1.0));
  reader.number("one", aboveUpTo(0.0, 1.0));
  EXPECT_TRUE(problems_.empty());
  reader.number("zero", positive());
  reader.number("zero", aboveUpTo(0.0, 1.0));
  reader.number("one", above(1.0));
  EXPECT_EQ(problems_.lines().size(), 3u);
}

TEST_F(YamlReaderTest, AbsentOptionalKeysGiveTheFallback) {
  YamlReader reader = read("{}");
  EXPECT_EQ(reader.numberOr("a", positive(), -5.0), -5.0);
  EXPECT_EQ(reader.integerOr("b", 1, 2, 7), 7);
  EXPECT_TRUE(reader.booleanOr("c", true));
  EXPECT_EQ(reader.textOr("d", ""), "");
  EXPECT_EQ(reader.choiceOr("e", {"x"}, "none"), "none");
  reader.finish();
  EXPECT_TRUE(problems_.empty());
}

TEST_F(YamlReaderTest, AfterAProblemTheValueIsHarmless) {
  YamlReader reader = read("{}");
  EXPECT_EQ(reader.number("a", between(2.0, 3.0)), 2.0);
  EXPECT_GT(reader.number("b", above(2.0)), 2.0);
  const double inside = reader.number("c", Range{2.0, 3.0, false, false});
  EXPECT_TRUE(inside > 2.0 && inside < 3.0);
  const double below = reader.number("d", Range{-std::numeric_limits<double>::infinity(), 3.0, true, false});
  EXPECT_LT(below, 3.0);
  EXPECT_EQ(reader.number("e", anyNumber()), 0.0);
  EXPECT_EQ(reader.integer("f", 4, 9), 4);
  EXPECT_EQ(reader.choice("g", {"x", "y"}), "x");
  EXPECT_EQ(problems_.lines().size(), 7u);
}

TEST_F(YamlReaderTest, ReadingLeavesTheDocumentAsItIs) {
  const std::string text = "a:\n  b: [1, 2]\n";
  YamlReader reader = read(text);
  reader.has("x");
  reader.map("y").number("z", positive());
  reader.map("a").number("q", positive());
  reader.numbers("a", positive());
  reader.refuse("a.c.d", "is refused");
  reader.finish();
  EXPECT_EQ(document_.text(), text);
}

TEST_F(YamlReaderTest, AssigningToAReaderLeavesTheDocumentAsItIs) {
  YamlReader reader = read("{a: {x: 1}, b: {x: 2}}");
  const std::string text = document_.text();
  YamlReader inner = reader.map("a");
  inner = reader.map("b");
  EXPECT_EQ(inner.number("x", positive()), 2.0);
  EXPECT_EQ(document_.text(), text);
}

TEST_F(YamlReaderTest, KeysAreNamedInOrderAndStayToBeAskedFor) {
  YamlReader reader = read("{z: 1, a: 2, m: 3}");
  EXPECT_EQ(reader.keys(), (Lines{"z", "a", "m"}));
  reader.finish();
  EXPECT_EQ(problems_.lines().size(), 3u);
}

TEST_F(YamlReaderTest, AbsentMapIsReportedOnce) {
  YamlReader reader = read("{}").map("gone");
  EXPECT_FALSE(reader.present());
  reader.number("a", positive());
  reader.map("b").maps("c");
  EXPECT_FALSE(reader.has("a"));
  reader.refuse("a", "is refused");
  reader.finish();
  EXPECT_EQ(problems_.lines(),
            Lines{"f.yaml: gone: is missing: must be a map, here or in the file that gone_file names"});
}

TEST_F(YamlReaderTest, UnknownKeysThatNameAFileAreToldAsTheyAreWrittenWhereTheyStand) {
  write("s.yaml", "train_file: trains/t.yaml\nlots_file: absent.yaml\nempty: {}\ninner: {deep_file: b.yaml}\n");
  write("trains/t.yaml", "bodis_file: ../b.yaml\ncurve_file: ../b.yaml\n");
  write("b.yaml", "x: 1\ny_file: c.csv\n");
  write("c.csv", "x\n1\n");
  const Document document = Document::load(
      path("s.yaml"),
      {{"empty.stray_file", "nowhere.yaml"}, {"train.curve", "{z: 1}"}, {"train.bodies", "{}"}, {"inner", "{deep: 3}"}},
      problems_);
  YamlReader reader(document, problems_);
  YamlReader train = reader.map("train");
  train.map("bodies").finish();
  train.finish();
  YamlReader empty = reader.map("empty");
  empty.finish();
  YamlReader inner = reader.map("inner");
  inner.finish();
  reader.has("lot");
  reader.finish();
  EXPECT_EQ(linesOf(problems_),
            (Lines{"s.yaml: lots_file = absent.yaml: cannot read 'absent.yaml'",
                   "--set: empty.stray_file = nowhere.yaml: cannot read 'nowhere.yaml'",
                   "trains/t.yaml: bodis_file = ../b.yaml: unknown key, did you mean 'bodies_file'?",
                   "--set: train.curve = {...}: unknown key, known here: bodies",  // what it named is not in force
                   "--set: empty.stray_file = nowhere.yaml: unknown key, none is known here",
                   "--set: inner.deep = 3: unknown key, none is known here",
                   "s.yaml: lots_file = absent.yaml: unknown key, did you mean 'lot_file'?"}));
  Document copy;
  copy = document;
  ASSERT_NE(copy.fileKey("train.bodis"), nullptr);
  EXPECT_NE(copy.fileKey("train.bodis.y"), nullptr);
  EXPECT_EQ(copy.fileKey("train.bodis.x"), nullptr);
  EXPECT_EQ(copy.fileKey("train.curve.y"), nullptr);
}

TEST_F(YamlReaderTest, MessagesNameTheFileThatHoldsTheKey) {
  write("s.yaml", "train_file: trains/t.yaml\ntable_file: c.csv\nn: 0\nlost_file: absent.yaml\n");
  write("trains/t.yaml", "mass_kg: -1\nlenght_m: 1\n");
  write("c.csv", "x\n1\n");
  const Document document = Document::load(path("s.yaml"), {{"n", "-5"}}, problems_);
  YamlReader reader(document, problems_);
  YamlReader train = reader.map("train");
  train.number("mass_kg", positive());
  train.number("length_m", positive());
  train.finish();
  reader.integer("n", 1);
  reader.map("lost").number("x", positive());
  reader.text("table");
  reader.finish();
  EXPECT_EQ(linesOf(problems_), (Lines{"s.yaml: lost_file = absent.yaml: cannot read 'absent.yaml'",
                                       "trains/t.yaml: mass_kg = -1: must be a number > 0",
                                       "trains/t.yaml: length_m: is missing: must be a number > 0",
                                       "trains/t.yaml: lenght_m = 1: unknown key, did you mean 'length_m'?",
                                       "--set: n = -5: must be an integer >= 1"}));
  EXPECT_EQ(reader.file(), path("s.yaml"));
  EXPECT_EQ(reader.file("table"), path("c.csv"));
  EXPECT_EQ(train.file("mass_kg"), path("trains/t.yaml"));
}

TEST_F(YamlReaderTest, DocumentThatCouldNotBeReadIsReportedOnce) {
  const Document document = Document::load(path("absent.yaml"), {}, problems_);
  YamlReader reader(document, problems_);
  EXPECT_FALSE(reader.present());
  reader.number("a", positive());
  reader.finish();
  EXPECT_EQ(linesOf(problems_), Lines{"absent.yaml: cannot be read"});
}

}  // namespace
}  // namespace rail
