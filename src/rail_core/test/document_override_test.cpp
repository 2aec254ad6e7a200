#include "rail_core/document.hpp"
#include "test_files.hpp"

namespace rail {
namespace {

/// Overrides (`--set`) of a scenario with a train of two groups and a track in files of their own.
class DocumentOverrideTest : public TestFiles {
 protected:
  void SetUp() override {
    TestFiles::SetUp();
    write("scenarios/s.yaml",
          "train_file: ../trains/t.yaml\ntrack_file: ../track.yaml\nsteps: {macro_step_s: 0.002}\n");
    write("trains/t.yaml", "groups: [{count: 2, vehicle: {mass_kg: 1}}, {count: 3}]\n");
    write("other_train.yaml", "groups: [{count: 7}]\n");
    write("track.yaml", "name: line\n");
  }

  std::string textWith(const std::vector<Override>& overrides) {
    document_ = Document::load(path("scenarios/s.yaml"), overrides, problems_);
    return document_.text();
  }
  Lines faultsWith(const std::vector<Override>& overrides) {
    problems_ = {};
    textWith(overrides);
    return linesOf(problems_);
  }

  Document document_;
  Problems problems_;
};

// --- what is refused

TEST_F(DocumentOverrideTest, KeysThatLeadNowhereAreNamedWithTheNearest) {
  EXPECT_EQ(faultsWith({{"step.macro_step_s", "1"}}),
            Lines{"--set: key 'step.macro_step_s': no such key, nearest 'steps'"});
  EXPECT_EQ(faultsWith({{"train.grups.0.count", "1"}}),
            Lines{"--set: key 'train.grups.0.count': no such key, nearest 'train.groups'"});
  EXPECT_EQ(faultsWith({{"colour.red", "1"}}), Lines{"--set: key 'colour.red': no such key"});
  EXPECT_EQ(faultsWith({{"steps.macro_step_s.x", "1"}}),
            Lines{"--set: key 'steps.macro_step_s.x': 'steps.macro_step_s' is neither a map nor a list"});
  EXPECT_EQ(faultsWith({{"steps..x", "1"}}), Lines{"--set: key 'steps..x': must be names with dots between"});
}

TEST_F(DocumentOverrideTest, IndicesMustLieInTheList) {
  const std::string rule = "must be an index of 'train.groups', which has 2 entries, the first at 0";
  EXPECT_EQ(faultsWith({{"train.groups.2.count", "1"}}), Lines{"--set: key 'train.groups.2.count': '2' " + rule});
  EXPECT_EQ(faultsWith({{"train.groups.2", "{count: 1}"}}), Lines{"--set: key 'train.groups.2': '2' " + rule});
  EXPECT_EQ(faultsWith({{"train.groups.-1", "1"}}), Lines{"--set: key 'train.groups.-1': '-1' " + rule});
  EXPECT_EQ(faultsWith({{"train.groups.00.count", "1"}}), Lines{"--set: key 'train.groups.00.count': '00' " + rule});
  EXPECT_EQ(faultsWith({{"train.groups.all.count", "1"}}), Lines{"--set: key 'train.groups.all.count': 'all' " + rule});
}

TEST_F(DocumentOverrideTest, ValuesThatAreNoYamlAreRefused) {
  EXPECT_EQ(faultsWith({{"steps.macro_step_s", "[1"}}),
            Lines{"--set: steps.macro_step_s: line 1: is not YAML: has a bracket that is not closed"});
  EXPECT_EQ(faultsWith({{"steps", "{a: 1, a: 2}"}}), Lines{"--set: steps.a: is given twice, in line 1 and in line 1"});
}

TEST_F(DocumentOverrideTest, OneKeyTwiceIsRefusedAlsoAsFile) {
  EXPECT_EQ(faultsWith({{"steps.n", "1"}, {"steps.n", "2"}}), Lines{"--set: steps.n = 2: is set twice"});
  EXPECT_EQ(faultsWith({{"train", "{}"}, {"train_file", "x.yaml"}}), Lines{"--set: train_file = x.yaml: is set twice"});
}

TEST_F(DocumentOverrideTest, FileThatCannotBeReadIsReportedOnceForAllOverridesInIt) {
  EXPECT_EQ(faultsWith({{"train_file", "absent.yaml"}, {"train.groups.0.count", "1"}}),
            Lines{"--set: train_file = absent.yaml: cannot read 'absent.yaml'"});
}

// --- what is done

TEST_F(DocumentOverrideTest, ValueInAnIncludedSubtreeIsReplacedInPlace) {
  EXPECT_EQ(textWith({{"train.groups.0.count", "5"}}),
            "train:\n  groups:\n    -\n      count: 5\n      vehicle:\n        mass_kg: 1\n    -\n      count: 3\n"
            "track:\n  name: line\nsteps:\n  macro_step_s: 0.002\n");
  EXPECT_TRUE(problems_.empty());
  EXPECT_EQ(document_.place("train.groups.0.count").file, "--set");
  EXPECT_EQ(document_.place("train.groups.0.count").key, "train.groups.0.count");
  EXPECT_EQ(document_.place("train.groups.1.count").file, path("trains/t.yaml"));
}

TEST_F(DocumentOverrideTest, AbsentKeyIsAddedToItsMap) {
  textWith({{"steps.micro_step_s", "0.0010"}, {"seed", "'7'"}});
  EXPECT_TRUE(problems_.empty());
  EXPECT_EQ(document_.root()["steps"]["micro_step_s"].Scalar(), "0.0010");
  EXPECT_EQ(document_.root()["seed"].Tag(), "!");
  EXPECT_EQ(document_.place("seed").file, "--set");
}

TEST_F(DocumentOverrideTest, ValueReplacesTheIncludedFileWhichNeedNotExist) {
  std::filesystem::remove(path("track.yaml"));
  textWith({{"track", "{name: other, length: [1, 2]}"}});
  EXPECT_EQ(linesOf(problems_), Lines{});
  EXPECT_EQ(document_.root()["track"]["name"].Scalar(), "other");
  EXPECT_EQ(document_.place("track.name").file, "--set");
}

TEST_F(DocumentOverrideTest, FileReplacesTheFileOrTheInlineValue) {
  textWith({{"train_file", path("other_train.yaml")}, {"steps_file", path("track.yaml")}});
  EXPECT_EQ(linesOf(problems_), Lines{});
  EXPECT_EQ(document_.root()["train"]["groups"][0]["count"].Scalar(), "7");
  EXPECT_EQ(document_.place("train.groups.0.count").file, path("other_train.yaml"));
  EXPECT_EQ(document_.place("train.groups.0.count").key, "groups.0.count");
  EXPECT_EQ(document_.root()["steps"]["name"].Scalar(), "line");
  EXPECT_FALSE(document_.root()["steps_file"].IsDefined());
}

TEST_F(DocumentOverrideTest, PathOfAnOverrideIsRelativeToTheWorkingDirectory) {
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(path("trains"));
  textWith({{"train_file", "../other_train.yaml"}});
  std::filesystem::current_path(before);
  EXPECT_EQ(linesOf(problems_), Lines{});
  EXPECT_EQ(document_.place("train.groups").file, "../other_train.yaml");
}

TEST_F(DocumentOverrideTest, OuterKeysComeFirstSoThatNoneIsLost) {
  textWith({{"train.groups.0.count", "5"}, {"train_file", path("other_train.yaml")}});
  EXPECT_EQ(linesOf(problems_), Lines{});
  EXPECT_EQ(document_.root()["train"]["groups"][0]["count"].Scalar(), "5");
  EXPECT_EQ(document_.root()["train"]["groups"].size(), 1u);
}

TEST_F(DocumentOverrideTest, FileNamedDeepInAnIncludedFileCanBeReplaced) {
  write("trains/t.yaml", "groups: [{vehicle_file: absent.yaml}]\n");
  write("v.yaml", "mass_kg: 9\n");
  textWith({{"train.groups.0.vehicle_file", path("v.yaml")}, {"train.groups.0.vehicle.mass_kg", "10"}});
  EXPECT_EQ(linesOf(problems_), Lines{});
  EXPECT_EQ(document_.root()["train"]["groups"][0]["vehicle"]["mass_kg"].Scalar(), "10");
  EXPECT_EQ(document_.place("train.groups.0.vehicle.mass_kg").file, "--set");
  EXPECT_EQ(document_.place("train.groups.0.vehicle.name").file, path("v.yaml"));
}

TEST_F(DocumentOverrideTest, ReplacedSubtreeForgetsTheFilesThatWereInIt) {
  write("scenarios/s.yaml", "a: {b_file: ../track.yaml, lost_file: absent.yaml}\n");
  textWith({{"a", "{b: {name: other}, lost: 1}"}});
  EXPECT_EQ(document_.place("a.b.name").file, "--set");
  EXPECT_FALSE(document_.unreadable("a.lost"));
}

TEST_F(DocumentOverrideTest, FilesNamedInAValueAreRead) {
  textWith({{"train", "{first_file: " + path("track.yaml") + "}"}});
  EXPECT_EQ(linesOf(problems_), Lines{});
  EXPECT_EQ(document_.root()["train"]["first"]["name"].Scalar(), "line");
  EXPECT_EQ(document_.place("train.first.name").file, path("track.yaml"));
  EXPECT_EQ(document_.place("train.second").file, "--set");
}

}  // namespace
}  // namespace rail
