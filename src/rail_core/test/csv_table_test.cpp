#include "rail_core/csv_table.hpp"

#include <gtest/gtest.h>

#include <clocale>

namespace rail {
namespace {

using Lines = std::vector<std::string>;
const Lines kColumns = {"chainage_km", "grade_permille", "radius_m"};

/// What readCsv finds wrong with a text, for columns chainage_km, grade_permille, radius_m.
Lines faults(const std::string& text) {
  Problems problems;
  readCsv(text, "line.csv", kColumns, problems);
  return problems.lines();
}

const std::string kHeader = "chainage_km,grade_permille,radius_m\n";

TEST(CsvTableTest, WrongRowsAreNamedWithTheirLine) {
  EXPECT_EQ(faults(kHeader + "0,0,0\n\n# comment\n1,x,0\n"),
            Lines{"line.csv: line 5: grade_permille = x: must be a number"});
  EXPECT_EQ(faults(kHeader + "0,,0\n"), Lines{"line.csv: line 2: grade_permille: is empty: must be a number"});
  EXPECT_EQ(faults(kHeader + "0,1\n"), Lines{"line.csv: line 2: has 2 cells, the header names 3"});
  EXPECT_EQ(faults(kHeader + "0,1,nan\n"), Lines{"line.csv: line 2: radius_m = nan: must be a number"});
  EXPECT_EQ(faults(kHeader + "0,1,1e999\n"),
            Lines{"line.csv: line 2: radius_m = 1e999: is beyond the range of a double"});
  EXPECT_EQ(faults(kHeader + "0,1,300m\n"),
            Lines{"line.csv: line 2: radius_m = 300m: must be a number, without unit or other text"});
  EXPECT_EQ(faults(kHeader + "0,1,0x10\n"),
            Lines{"line.csv: line 2: radius_m = 0x10: must be a number, without unit or other text"});
}

TEST(CsvTableTest, DecimalCommaIsNamed) {
  EXPECT_EQ(faults(kHeader + "3,2,0,0\n"),
            Lines{"line.csv: line 2: has 4 cells, the header names 3 (a decimal comma?)"});
  EXPECT_EQ(faults(kHeader + "\"3,2\",0,0\n"),
            Lines{"line.csv: line 2: chainage_km = 3,2: must be a number, with a decimal point"});
  EXPECT_EQ(faults("chainage_km;grade_permille;radius_m\n3,2;0;0\n"),
            Lines{"line.csv: line 1: columns must be separated by ',', not by ';'"});
}

TEST(CsvTableTest, WhatSpreadsheetsLeaveIsNamedOnce) {
  EXPECT_EQ(faults("chainage_km\tgrade_permille\tradius_m\n3\t0\t0\n"),
            Lines{"line.csv: line 1: columns must be separated by ',', not by tabs"});
  EXPECT_EQ(faults(kHeader + "0,0,0\n,,\n"), Lines{"line.csv: line 3: has only empty cells: remove it"});
  EXPECT_EQ(faults("chainage_km,grade_permille,radius_m,\n0,0,0,\n"),
            Lines{"line.csv: line 1: column 4 has no name (a comma at the end of the line?)"});
}

TEST(CsvTableTest, WrongColumnsAreNamed) {
  EXPECT_EQ(faults("chainage_km,grade_promille,radius_m\n0,0,0\n"),
            (Lines{"line.csv: line 1: unknown column 'grade_promille', did you mean 'grade_permille'?",
                   "line.csv: line 1: column 'grade_permille' is missing"}));
  EXPECT_EQ(faults("chainage_km,chainage_km,radius_m\n0,0,0\n"),
            Lines{"line.csv: line 1: column 'chainage_km' is given twice"});
  EXPECT_EQ(faults("chainage_km,,radius_m\n0,0,0\n"), Lines{"line.csv: line 1: column 2 has no name"});
}

TEST(CsvTableTest, TextWithoutRowsIsRefused) {
  EXPECT_EQ(faults(""), Lines{"line.csv: is empty"});
  EXPECT_EQ(faults("# only a comment\n"), Lines{"line.csv: is empty"});
  EXPECT_EQ(faults(kHeader), Lines{"line.csv: has no rows"});
}

TEST(CsvTableTest, AllFaultsComeOutAtOnceAndGoodRowsAreKept) {
  Problems problems;
  const CsvTable table = readCsv(kHeader + "0,a,b\n1,2,3\n2,,0\n", "f", kColumns, problems);
  EXPECT_EQ(problems.lines().size(), 3u);
  EXPECT_EQ(table.rows, (std::vector<std::vector<double>>{{1.0, 2.0, 3.0}}));
  EXPECT_EQ(table.line_of_row, std::vector<int>{3});
}

TEST(CsvTableTest, ColumnsAreGivenInTheAskedOrder) {
  Problems problems;
  const CsvTable table = readCsv("radius_m, chainage_km ,grade_permille\r\n# c\r\n300,0.1,-2.5e1\r\n\r\n+.5,1.,0", "f",
                                 kColumns, problems);
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(table.columns, kColumns);
  EXPECT_EQ(table.rows, (std::vector<std::vector<double>>{{0.1, -25.0, 300.0}, {1.0, 0.0, 0.5}}));
  EXPECT_EQ(table.line_of_row, (std::vector<int>{3, 5}));
  EXPECT_EQ(table.column("radius_m"), 2);
  EXPECT_EQ(table.column("radius"), -1);
}

TEST(CsvTableTest, QuotesAndByteOrderMarkOfSpreadsheetsAreNoContent) {
  EXPECT_EQ(faults("\xEF\xBB\xBF\"chainage_km\",\"grade_permille\",radius_m\n\"0\",0,0\n"), Lines{});
}

TEST(CsvTableTest, NumbersDoNotDependOnTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  const char* const german = std::setlocale(LC_ALL, "de_DE.UTF-8");  // as a Qt program would; may not be installed
  Problems problems;
  const CsvTable table = readCsv("x\n0.1\n", "f", {"x"}, problems);
  std::setlocale(LC_ALL, before.c_str());
  if (german == nullptr) GTEST_SKIP() << "no German locale on this machine";
  EXPECT_EQ(table.rows.front().front(), 0.1);
}

TEST(OpenCsvTest, ColumnsAreThoseOfTheFile) {
  Problems problems;
  const CsvTable table = readOpenCsv("speed_kmph,notch_1,notch_2\n0,1,2\n", "f", "speed_kmph", problems);
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(table.columns, (Lines{"speed_kmph", "notch_1", "notch_2"}));
  EXPECT_EQ(table.rows.front(), (std::vector<double>{0.0, 1.0, 2.0}));
}

TEST(OpenCsvTest, FirstColumnMustBeTheNamedOne) {
  Problems problems;
  readOpenCsv("speed,notch_1\n0,1\n", "f", "speed_kmph", problems);
  readOpenCsv("speed_kmph,a,a\n0,1,2\n", "f", "speed_kmph", problems);
  readOpenCsv("", "f", "speed_kmph", problems);
  EXPECT_EQ(problems.lines(), (Lines{"f: line 1: the first column must be 'speed_kmph', not 'speed'",
                                     "f: line 1: column 'a' is given twice", "f: is empty"}));
}

TEST(CsvColumnsTest, OtherColumnsAreOfNoMatterWhateverStandsInThem) {
  Problems problems;
  const CsvTable table = readCsvColumns("clock,v,km\n08:00,3,1\n,4,2\n", "f", {"km", "v"}, problems);
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(table.rows, (std::vector<std::vector<double>>{{1.0, 3.0}, {2.0, 4.0}}));
  readCsvColumns("clock,v\n08:00,x\n", "f", {"km", "v"}, problems);
  readCsvColumns("clock,v\n08:00,x\n", "f", {"v"}, problems);
  EXPECT_EQ(problems.lines(), (Lines{"f: line 1: column 'km' is missing", "f: line 2: v = x: must be a number"}));
}

}  // namespace
}  // namespace rail
