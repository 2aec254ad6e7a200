#include "loco_dynamics/contact/rail_conditions.hpp"

#include <gtest/gtest.h>

namespace {

constexpr const char* kLaw =
    "{name: x, method: polach, friction: {mu0: %, A: 0.4, B_s_per_m: 0.2}, polach: {k_A: 1, k_S: 0.4}}";

std::string law(const std::string& mu0) {
  std::string text = kLaw;
  return text.replace(text.find('%'), 1, mu0);
}

std::string section(const std::string& from_km, const std::string& to_km, const std::string& mu0) {
  return "  - {from_km: " + from_km + ", to_km: " + to_km + ", adhesion: " + law(mu0) + "}\n";
}

loco::RailConditions read(const std::string& sections, rail::Problems& problems) {
  const std::string text = "adhesion: " + law("0.35") + "\n" + (sections.empty() ? "" : "rail_sections:\n" + sections);
  const rail::Document document = rail::Document::parse(text, "scenario.yaml", problems);
  rail::YamlReader root(document, problems);
  return loco::readRailConditions(root);
}

std::string faultOf(const std::string& sections) {
  rail::Problems problems;
  read(sections, problems);
  EXPECT_EQ(problems.lines().size(), 1u);
  return problems.empty() ? "accepted" : problems.lines().front();
}

TEST(RailConditionsTest, RefusesSectionsThatOverlapOrEndBeforeTheyBegin) {
  EXPECT_EQ(faultOf(section("3.2", "3.1", "0.2")),
            "scenario.yaml: rail_sections.0.to_km = 3.1: must be ahead of from_km");
  EXPECT_EQ(faultOf(section("3.2", "3.4", "0.2") + section("3.3", "3.5", "0.1")),
            "scenario.yaml: rail_sections.1.from_km = 3.3: must not be before the end of the section before it");
}

TEST(RailConditionsTest, RefusesAMisspeltKeyAndAWrongValueInASection) {
  rail::Problems problems;
  read("  - {from_km: 3.2, to: 3.3, adhesion: " + law("1.2") + "}\n", problems);
  ASSERT_EQ(problems.lines().size(), 3u);
  EXPECT_NE(problems.lines()[0].find("rail_sections.0.to_km: is missing"), std::string::npos) << problems.lines()[0];
  EXPECT_NE(problems.lines()[1].find("rail_sections.0.adhesion.friction.mu0 = 1.2"), std::string::npos);
  EXPECT_NE(problems.lines()[2].find("rail_sections.0.to = 3.3: unknown key"), std::string::npos);
}

TEST(RailConditionsTest, EachPlaceHasTheLawOfItsSectionAndTheRestTheOneElsewhere) {
  rail::Problems problems;
  const loco::CreepLawByPlace laws(
      read(section("3.2", "3.3", "0.2") + section("3.3", "3.4", "0.1") + section("3.5", "3.6", "0.25"), problems));
  problems.throwIfAny();
  const auto mu0At = [&](double s_m) { return laws.at(s_m, false).parameters().friction.mu0; };
  EXPECT_EQ(mu0At(-1e9), 0.35);
  EXPECT_EQ(mu0At(3199.999), 0.35);
  EXPECT_EQ(mu0At(3200.0), 0.2);
  EXPECT_EQ(mu0At(3299.999), 0.2);
  EXPECT_EQ(mu0At(3300.0), 0.1);
  EXPECT_EQ(mu0At(3400.0), 0.35);
  EXPECT_EQ(mu0At(3550.0), 0.25);
  EXPECT_EQ(mu0At(3600.0), 0.35);
}

TEST(RailConditionsTest, WithoutSectionsOneLawHoldsEverywhere) {
  rail::Problems problems;
  const loco::CreepLawByPlace laws(read("", problems));
  problems.throwIfAny();
  EXPECT_EQ(laws.at(0.0, false).parameters().friction.mu0, 0.35);
}

/// A section of 0.2 from 3.2 to 3.3 km, 0.35 elsewhere, and this law under sand.
loco::RailConditions readSanded(const std::string& sanded, rail::Problems& problems) {
  return read(section("3.2", "3.3", "0.2") + "sanded_adhesion: " + sanded + "\n", problems);
}

TEST(RailConditionsTest, SandHoldsWhereItOffersMoreThanThePlaceAndOnlyWhileItIsLaid) {
  rail::Problems problems;
  const loco::CreepLawByPlace laws(readSanded(law("0.28"), problems));
  problems.throwIfAny();
  EXPECT_EQ(laws.at(3250.0, true).parameters().friction.mu0, 0.28);
  EXPECT_EQ(laws.at(3250.0, false).parameters().friction.mu0, 0.2);
  EXPECT_EQ(&laws.at(3100.0, true), &laws.at(3100.0, false));
}

TEST(RailConditionsTest, SandWithoutALawOfItsOwnChangesNothing) {
  rail::Problems problems;
  const loco::CreepLawByPlace laws(read(section("3.2", "3.3", "0.2"), problems));
  problems.throwIfAny();
  EXPECT_EQ(&laws.at(3250.0, true), &laws.at(3250.0, false));
}

TEST(RailConditionsTest, RefusesFaultsOfTheLawUnderSandAllAtOnce) {
  rail::Problems problems;
  readSanded("{name: x, method: polach, friction: {mu0: 1.2, A: 0.4, B: 0.2}, polach: {k_A: 1, k_S: 0.4}}", problems);
  ASSERT_EQ(problems.lines().size(), 3u);
  EXPECT_NE(problems.lines()[0].find("sanded_adhesion.friction.mu0 = 1.2: must be"), std::string::npos)
      << problems.lines()[0];
  EXPECT_NE(problems.lines()[1].find("sanded_adhesion.friction.B_s_per_m: is missing"), std::string::npos);
  EXPECT_NE(problems.lines()[2].find("sanded_adhesion.friction.B = 0.2: unknown key"), std::string::npos);
}

}  // namespace
