#include "text_fault.hpp"

#include <gtest/gtest.h>

#include "rail_core/csv_table.hpp"
#include "rail_core/document.hpp"

namespace {

using Lines = std::vector<std::string>;

TEST(TextFaultTest, OtherEncodingsAreNamedWithWhatToDo) {
  EXPECT_EQ(rail::textFault("a\nb\nZw\xF6lf Wagen\n"),
            "line 3: holds a character that is not UTF-8 (an umlaut?): save the file as UTF-8");
  EXPECT_EQ(rail::textFault("\xFF\xFE\x61\0"), "is text in UTF-16: must be UTF-8, save it so");
  EXPECT_EQ(rail::textFault("cut off \xE2\x82"),
            "line 1: holds a character that is not UTF-8 (an umlaut?): save the file as UTF-8");
  EXPECT_EQ(rail::textFault(std::string("a\nb\0c", 5)), "line 2: holds a zero byte: must be text in UTF-8");
  EXPECT_EQ(rail::textFault("PK\x03\x04"),
            "is a zip file or a spreadsheet: must be text, export the sheet as CSV in UTF-8");
  EXPECT_EQ(rail::textFault("a,b\r1,2\r"), "has lines that end in CR alone: must end in LF or CRLF");
}

TEST(TextFaultTest, TextInUtf8WithAnyLineEndPasses) {
  for (const char* const text : {"", "a", "PK", "PKP: 1\n",
                                 "\xEF\xBB\xBF"
                                 "a,b\r\n1,2\r\n",
                                 "Zw\xC3\xB6lf \xE2\x82\xAC \xF0\x9F\x9A\x82\n"})
    EXPECT_EQ(rail::textFault(text), "") << text;
}

TEST(TextFaultTest, BothKindsOfFilesAreLookedAt) {
  rail::Problems problems;
  rail::readCsv("a,\xF6\n1,2\n", "f.csv", {"a", "b"}, problems);
  rail::readOpenCsv("a,\xF6\n1,2\n", "g.csv", "a", problems);
  rail::Document::parse("name: Zw\xF6lf\n", "f.yaml", problems);
  const std::string rule = ": line 1: holds a character that is not UTF-8 (an umlaut?): save the file as UTF-8";
  EXPECT_EQ(problems.lines(), (Lines{"f.csv" + rule, "g.csv" + rule, "f.yaml" + rule}));
}

}  // namespace
