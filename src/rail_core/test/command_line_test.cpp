#include "rail_core/command_line.hpp"

#include <gtest/gtest.h>

namespace {

const std::vector<std::string> kKnown = {"--method", "--grid"};

TEST(CommandLineTest, UnknownOptionsAreAnsweredWithTheNearestOrAll) {
  EXPECT_EQ(rail::unknownOption("--methd", kKnown), "--methd: unknown option, did you mean '--method'?");
  EXPECT_EQ(rail::unknownOption("--frobnicate", kKnown), "--frobnicate: unknown option; there are: --method, --grid");
  EXPECT_EQ(rail::unknownOption("--grid=3x3", kKnown),
            "--grid=3x3: unknown option, write '--grid', a blank, its value");
}

TEST(CommandLineTest, ANegativeNumberIsNoOption) {
  EXPECT_TRUE(rail::isOption("--load"));
  for (const char* const value : {"-3", "-0.5", "--", "load", ""}) EXPECT_FALSE(rail::isOption(value)) << value;
}

}  // namespace
