#include "rail_core/document.hpp"

#include "test_files.hpp"

namespace rail {
namespace {

class DocumentTest : public TestFiles {
 protected:
  Document load(const std::string& name) { return Document::load(path(name), {}, problems_); }
  Document parse(const std::string& text) { return Document::parse(text, "text", problems_); }
  Problems problems_;
};

// --- what is refused

TEST_F(DocumentTest, FaultsOfTheFileAreNamedWithTheirLine) {
  load("absent.yaml");
  write("syntax.yaml", "a: 1\nb: [1, 2\n");
  load("syntax.yaml");
  write("list.yaml", "- 1\n");
  load("list.yaml");
  write("empty.yaml", "");
  load("empty.yaml");
  write("directory.yaml/x", "");
  load("directory.yaml");
  EXPECT_EQ(linesOf(problems_),
            (Lines{"absent.yaml: cannot be read", "syntax.yaml: line 2: is not YAML: has a bracket that is not closed",
                   "list.yaml: must be a map, of lines `key: value`", "empty.yaml: is empty",
                   "directory.yaml: is a folder: must be a file"}));
}

TEST_F(DocumentTest, WhatYamlCppAcceptsInSilenceIsRefused) {
  parse("a: {b: 1, c: 2, b: 3}\n");
  parse("a: &x 1\nb: *x\n");
  parse("a: !!str 1\n");
  parse("a: 1\n---\nb: 2\n");
  parse("a.b: 1\n");
  parse("{[1, 2]: 3}\n");
  parse("~: 3\n");
  const std::string alias = "anchors and aliases (&name, *name) are not allowed, write it out or use a NAME_file key";
  EXPECT_EQ(problems_.lines(),
            (Lines{"text: a.b: is given twice, in line 1 and in line 1", "text: line 1: " + alias,
                   "text: a: tags (!type) are not allowed", "text: must be one YAML document, without '---'",
                   "text: a.b: a key must not hold a dot", "text: a key must be text, and not empty"}));
  EXPECT_EQ(problems_.count(), 7u);  // the last rule is broken twice
}

TEST_F(DocumentTest, IncludedFilesThatCannotBeUsedAreNamedWhereTheyAreNamed) {
  write("main.yaml",
        "a_file: absent.yaml\n"
        "b_file: notes.txt\n"
        "c_file: [1]\n"
        "d: 1\nd_file: x.csv\n"
        "e_file: bad.yaml\n"
        "f_file: bda.yaml\n"
        "g_file: .\n"
        "h_file: nowhere/x.yaml\n");
  write("bad.yaml", "x: 1\nx: 2\n");
  load("main.yaml");
  ASSERT_EQ(linesOf(problems_),
            (Lines{"main.yaml: a_file = absent.yaml: cannot read 'absent.yaml'",
                   "main.yaml: b_file = notes.txt: must end in .yaml or .csv",
                   "main.yaml: c_file: must be the path of a file",
                   "main.yaml: d_file: stands beside 'd', only one may be given",
                   "bad.yaml: x: is given twice, in line 1 and in line 2",
                   "main.yaml: f_file = bda.yaml: cannot read 'bda.yaml': there is none, did you mean 'bad.yaml'?",
                   "main.yaml: g_file = .: is a folder: must be a file, and end in .yaml or .csv",
                   "main.yaml: h_file = nowhere/x.yaml: cannot read 'nowhere/x.yaml': there is no folder 'nowhere' "
                   "(a path counts from the file that names it)"}));
}

TEST_F(DocumentTest, InclusionInCirclesIsRefusedWithTheRound) {
  write("a.yaml", "b_file: sub/b.yaml\n");
  write("sub/b.yaml", "list: [{c_file: ../a.yaml}]\n");
  load("a.yaml");
  EXPECT_EQ(linesOf(problems_),
            Lines{"sub/b.yaml: list.0.c_file = ../a.yaml: includes itself: a.yaml -> sub/b.yaml -> a.yaml"});
}

TEST_F(DocumentTest, OneFileMayStandInTwoPlaces) {
  write("a.yaml", "front_file: b.yaml\nrear_file: b.yaml\n");
  write("b.yaml", "x: 1\n");
  const Document document = load("a.yaml");
  EXPECT_TRUE(problems_.empty());
  EXPECT_EQ(document.text(), "front:\n  x: 1\nrear:\n  x: 1\n");
}

TEST_F(DocumentTest, ResolvedTextMustNameNoFiles) {
  parse("a: [{b_file: c.yaml}]\n");
  EXPECT_EQ(problems_.lines(),
            Lines{"text: a.0.b_file = c.yaml: files cannot be named here, the text must be complete"});
}

// --- what is read

TEST_F(DocumentTest, FilesAreResolvedAtAnyDepthRelativeToTheirOwnDirectory) {
  write("scenarios/s.yaml", "train_file: ../trains/t.yaml\nsteps: {n: 1}\n");
  write("trains/t.yaml", "groups:\n  - {count: 2, vehicle_file: ../vehicles/v.yaml}\n  - {count: 3}\n");
  write("vehicles/v.yaml", "mass_kg: 120000\ncurve_file: data/c.csv\n");
  write("vehicles/data/c.csv", "x,y\n0,1\n");
  const Document document = load("scenarios/s.yaml");
  EXPECT_EQ(linesOf(problems_), Lines{});
  EXPECT_EQ(document.text(),
            "train:\n"
            "  groups:\n"
            "    -\n"
            "      count: 2\n"
            "      vehicle:\n"
            "        mass_kg: 120000\n"
            "        curve: |\n"
            "          x,y\n"
            "          0,1\n"
            "    -\n"
            "      count: 3\n"
            "steps:\n"
            "  n: 1\n");
}

TEST_F(DocumentTest, PlaceIsTheInnermostFileAndTheKeyInIt) {
  write("s.yaml", "train_file: trains/t.yaml\nsteps: {n: 1}\n");
  write("trains/t.yaml", "groups: [{vehicle_file: ../v.yaml, count: 1}]\n");
  write("v.yaml", "mass_kg: 1\n");
  const Document document = load("s.yaml");
  const auto at = [&](const std::string& key) {
    const Document::Place place = document.place(key);
    return std::filesystem::path(place.file).lexically_relative(path("")).string() + "|" + place.key;
  };
  EXPECT_EQ(at("steps.n"), "s.yaml|steps.n");
  EXPECT_EQ(at("train"), "trains/t.yaml|");
  EXPECT_EQ(at("train.groups.0.count"), "trains/t.yaml|groups.0.count");
  EXPECT_EQ(at("train.groups.0.vehicle.mass_kg"), "v.yaml|mass_kg");
  EXPECT_EQ(at("trainer.x"), "s.yaml|trainer.x");  // no component boundary after `train`
}

TEST_F(DocumentTest, MessagesUseThePathAsTheUserGaveIt) {
  write("scenarios/s.yaml", "a_file: ../trains/t.yaml\n");
  write("trains/t.yaml", "x: 1\nx: 1\n");
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(path(""));
  Document::load("scenarios/s.yaml", {}, problems_);
  std::filesystem::current_path(before);
  EXPECT_EQ(problems_.lines(), Lines{"trains/t.yaml: x: is given twice, in line 1 and in line 2"});
}

TEST_F(DocumentTest, UnreadableContentIsMarkedSoThatItIsReportedOnce) {
  write("s.yaml", "a_file: absent.yaml\n");
  const Document document = load("s.yaml");
  EXPECT_TRUE(document.unreadable("a"));
  EXPECT_FALSE(document.unreadable(""));
  EXPECT_TRUE(load("absent.yaml").unreadable(""));
}

TEST_F(DocumentTest, AssigningToADocumentLeavesItsCopiesAsTheyWere) {
  Document document = parse("a: 1\n");
  const Document copy = document;
  document = parse("b: 2\n");
  EXPECT_EQ(copy.text(), "a: 1\n");
  EXPECT_EQ(document.text(), "b: 2\n");
}

// --- what comes out again

TEST_F(DocumentTest, ScalarsStandAsTheyWereWritten) {
  const std::string text =
      "z: 0.10\n"
      "a: 1e-3\n"
      "quoted: \"3\"\n"
      "empty: \"\"\n"
      "nothing: ~\n"
      "list: [0.10, 1e-3, left]\n"
      "no_entries: []\n"
      "no_keys: {}\n"
      "words: two words, and a comma\n"
      "\"odd key\": 1\n"
      "\"null\": 2\n"
      "m: 010\n";
  EXPECT_EQ(parse(text).text(), text);
  EXPECT_TRUE(problems_.empty());
}

TEST_F(DocumentTest, TextOfTheTextIsTheSameTextWhateverTheStyle) {
  const Document document = parse(
      "a: 'it''s \"quoted\" \\ and # no comment: '\n"
      "b: >\n  folded\n  text\n"
      "c: |-\n  kept\n    indented\n\n  after a blank line\n"
      "d: plain over\n  two lines\n\n  and a paragraph\n"
      "e: [[1, 2], [\"3\", {f: ~}], [], {}]\n"
      "g: \"tab\\t, bell\\a, nul\\0, grad \xC2\xB0, del\\x7F, \\r\\n\"\n"
      "h: {i: [a, b]}\n"
      "j: \"true\"\n"
      "k: -\"\n"
      "l: \" # leading\\n blank\\n\"\n"
      "'m: n': '- o'\n"
      "p: \"\xEF\xBB\xBFmarked\"\n");
  ASSERT_EQ(problems_.lines(), Lines{});
  const std::string text = document.text();
  const Document again = parse(text);
  ASSERT_EQ(problems_.lines(), Lines{}) << text;
  EXPECT_EQ(again.text(), text);
  const auto scalarOf = [](const Document& of, const std::string& key) { return of.root()[key].Scalar(); };
  for (const char* const key : {"a", "b", "c", "d", "g", "j", "k", "l", "m: n", "p"}) {
    EXPECT_EQ(scalarOf(again, key), scalarOf(document, key)) << key;
    EXPECT_EQ(again.root()[key].Tag(), document.root()[key].Tag()) << key;
  }
  EXPECT_EQ(scalarOf(again, "g"), std::string("tab\t, bell\a, nul\0, grad \xC2\xB0, del\x7F, \r\n", 36));
  EXPECT_EQ(scalarOf(again, "d"), "plain over two lines\nand a paragraph");
  EXPECT_EQ(again.root()["e"][1][0].Tag(), "!");
}

TEST_F(DocumentTest, CsvTextsComeBackByteForByte) {
  std::string large = "x,y\r\n";
  for (int i = 0; i < 5000; ++i) large += std::to_string(i) + ",0.5\r\n";
  const std::vector<std::string> tables = {"x,y\n0,1\n",
                                           "x,y\n0,1",
                                           "x,y\r\n0,1\r\n",
                                           "# comment: [\nx,y\n\n0,1\n\n\n",
                                           "\n\nx,y\n",
                                           "  x,y\n0,1\n",
                                           "x,y \n0,1\t\n",
                                           "\xEF\xBB\xBFx,y\n0,1\n",
                                           "x\n---\n...\n# \xC2\xB0\n",
                                           "",
                                           "# it's \"q\" \\n\n",
                                           "x\n \n1\n",
                                           "\tx\n1\n",
                                           "x\n\r\n1\n",
                                           "\n",
                                           large};
  for (const std::string& table : tables) {
    write("t.csv", table);
    write("s.yaml", "outer: [{table_file: t.csv, after: 1}]\n");
    const Document document = load("s.yaml");
    EXPECT_EQ(document.root()["outer"][0]["table"].Scalar(), table);
    const Document again = parse(document.text());
    ASSERT_EQ(problems_.lines(), Lines{}) << document.text();
    EXPECT_EQ(again.root()["outer"][0]["table"].Scalar(), table);
    EXPECT_EQ(again.root()["outer"][0]["after"].Scalar(), "1");
    EXPECT_EQ(again.text(), document.text());
  }
}

}  // namespace
}  // namespace rail
