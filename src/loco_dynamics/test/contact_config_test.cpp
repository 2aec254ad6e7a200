#include "loco_dynamics/contact/contact_config.hpp"

#include <gtest/gtest.h>

namespace {

using loco::CreepLawParameters;
using loco::CreepMethod;

CreepLawParameters load(const std::string& name) {
  rail::Problems problems;
  const rail::Document document = rail::Document::load(std::string(CONFIG_DIR) + "/adhesion/" + name, {}, problems);
  const CreepLawParameters parameters = loco::readCreepLaw(rail::YamlReader(document, problems));
  problems.throwIfAny();
  return parameters;
}

std::vector<std::string> problemsOf(const std::string& text) {
  rail::Problems problems;
  const rail::Document document = rail::Document::parse(text, "adhesion.yaml", problems);
  loco::readCreepLaw(rail::YamlReader(document, problems));
  return problems.lines();
}

bool tells(const std::vector<std::string>& lines, const std::string& part) {
  for (const std::string& line : lines) {
    if (line.find(part) != std::string::npos) return true;
  }
  return false;
}

TEST(ContactConfigTest, PaperSetHasTable1) {
  const CreepLawParameters p = load("paper_table1.yaml");
  EXPECT_EQ(p.method, CreepMethod::kModfastsim);
  EXPECT_EQ(p.friction.mu0, 0.35);
  EXPECT_EQ(p.friction.A, 0.40);
  EXPECT_EQ(p.friction.B_s_per_m, 0.275);
  EXPECT_EQ(p.reduction.k0, 0.075);
  EXPECT_EQ(p.reduction.alpha_inf, 0.0008);
  EXPECT_EQ(p.reduction.beta, 0.30);
  EXPECT_EQ(p.cells, 20);
  EXPECT_EQ(p.strips, 20);
  EXPECT_EQ(p.flexibility, loco::FlexibilityRule::kBlended);
}

TEST(ContactConfigTest, PolachSetsHaveThePublishedNumbers) {
  const CreepLawParameters dry = load("polach_dry.yaml"), wet = load("polach_wet.yaml");
  EXPECT_EQ(dry.method, CreepMethod::kPolach);
  EXPECT_EQ(dry.friction.mu0, 0.55);
  EXPECT_EQ(dry.friction.A, 0.40);
  EXPECT_EQ(dry.friction.B_s_per_m, 0.60);
  EXPECT_EQ(dry.polach.k_A, 1.0);
  EXPECT_EQ(dry.polach.k_S, 0.40);
  EXPECT_EQ(wet.friction.mu0, 0.30);
  EXPECT_EQ(wet.friction.B_s_per_m, 0.20);
  EXPECT_EQ(wet.polach.k_A, 0.30);
  EXPECT_EQ(wet.polach.k_S, 0.10);
}

TEST(ContactConfigTest, EveryValueOutOfRangeIsNamedAtOnce) {
  const auto lines = problemsOf(
      "name: bad\nmethod: modfastsim\nfriction: {mu0: 0, A: 1.5, B_s_per_m: -1}\n"
      "reduction: {k0: 0, alpha_inf: -0.1, beta: -2}\ngrid: {cells: 0, strips: 1001}\n");
  EXPECT_EQ(lines.size(), 8u);
  for (const char* key : {"friction.mu0", "friction.A", "friction.B_s_per_m", "reduction.k0", "reduction.alpha_inf",
                          "reduction.beta", "grid.cells", "grid.strips"}) {
    EXPECT_TRUE(tells(lines, std::string("adhesion.yaml: ") + key + " = ")) << key;
  }
}

TEST(ContactConfigTest, MisspelledAndForeignKeysAreRefused) {
  const auto lines = problemsOf(
      "name: bad\nmethod: polach\nfriction: {mu0: 0.3, A: 0.4, B_s_per_m: 0.2}\n"
      "polach: {k_A: 0.3, k_S: 0.1, k_s: 0.1}\nreduction: {k0: 1, alpha_inf: 1, beta: 0}\n");
  EXPECT_EQ(lines.size(), 2u);
  EXPECT_TRUE(tells(lines, "k_s"));
  EXPECT_TRUE(tells(lines, "reduction"));
}

TEST(ContactConfigTest, MissingMapIsNamed) {
  const auto lines = problemsOf("name: bad\nmethod: closed\nfriction: {mu0: 0.3, A: 0.4, B_s_per_m: 0.2}\n");
  EXPECT_TRUE(tells(lines, "reduction"));
}

TEST(ContactConfigTest, SlipReductionAboveThatOfAdhesionIsRefused) {
  const auto lines = problemsOf(
      "name: bad\nmethod: polach\nfriction: {mu0: 0.3, A: 0.4, B_s_per_m: 0.2}\npolach: {k_A: 0.1, k_S: 0.3}\n");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(tells(lines, "polach.k_S = 0.3: must not be larger than k_A"));
}

}  // namespace
